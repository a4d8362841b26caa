#include "report/recommendation_words.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <span>

#include "augment/catalogue.hpp"
#include "report/labels.hpp"

namespace piae::report {

namespace {

constexpr NumberStyle in_points{.decimals = 1, .sign = true};

std::string counted_seeds(const Candidate& candidate) {
  const std::size_t seeds = candidate.row.seeds.size();
  return fmt::format("{} seed{}", seeds, seeds == 1 ? "" : "s");
}

/// "95 % interval 94.0 to 96.4, "; empty where there is none.
std::string interval_words(const scoring::Summary& summary, NumberStyle style) {
  if (!summary.interval) return "";
  return fmt::format("95 % interval {} to {}, ", number_label(summary.interval->low, style),
                     number_label(summary.interval->high, style));
}

std::string what_to_take(const Recommendation& of) {
  const Candidate& taken = of.recommended();
  const AccuracyRow& row = taken.row;
  const std::string windows =
      row.method == augment::no_method
          ? "without any generated window"
          : fmt::format("with {} generated windows of each fault", row.generated_per_class);
  return fmt::format("Recommended on {}: {}, right in {:.1f} % of the test windows ({}{}), {}.",
                     of.dataset, name_of(taken, of), row.summary.mean,
                     interval_words(row.summary, percent_style), counted_seeds(taken), windows);
}

/// "none by nearest (-33.4 points, p 0.01)", of all of these that take less than the best.
std::string listed_behind(const Recommendation& of, std::span<const Candidate> candidates,
                          bool with_p) {
  std::vector<std::string> words;
  for (const Candidate& each : candidates) {
    const std::string p = with_p ? fmt::format(", p {:.2g}", *each.behind->p_holm) : "";
    words.push_back(fmt::format("{} ({} points{})", name_of(each, of),
                                number_label(each.behind->paired.difference.mean, in_points), p));
  }
  return listed(words);
}

/// The best is taken.
std::string why_the_best(const Recommendation& of) {
  if (of.compared == 1) return "Nothing else was compared.";
  const std::string most =
      fmt::format("It is the most accurate of the {} that were compared", of.compared);
  const std::span less = std::span(of.by_effort).first(of.best);
  if (less.empty()) return most + ", and none takes less.";
  if (!of.can_tell) {
    return fmt::format(
        "{}. Whether what takes less is as good, {} cannot tell: {}. At least {} "
        "seeds could.",
        most, counted_seeds(of.most_accurate()), listed_behind(of, less, false),
        of.seeds_to_tell());
  }
  return most + ", and what takes less is significantly worse: " + listed_behind(of, less, true) +
         ".";
}

/// Something is taken that takes less than the best.
std::string why_not_the_best(const Recommendation& of) {
  const PairedRow& behind = *of.recommended().behind;
  const std::span still_less = std::span(of.by_effort).first(of.taken);
  return fmt::format(
             "The most accurate of the {} that were compared is {} ({:.1f} %), but {} is not "
             "significantly worse ({} points, {}p {:.2g}), and takes less: {} instead of {}.",
             of.compared, name_of(of.most_accurate(), of), of.most_accurate().row.summary.mean,
             name_of(of.recommended(), of), number_label(behind.paired.difference.mean, in_points),
             interval_words(behind.paired.difference, in_points), *behind.p_holm,
             effort_label(of.recommended().effort), effort_label(of.most_accurate().effort)) +
         (still_less.empty() ? ""
                             : " What takes still less is significantly worse: " +
                                   listed_behind(of, still_less, true) + ".");
}

std::string what_it_costs(Effort effort) {
  switch (effort) {
    case Effort::nothing:
      return "It costs nothing beforehand: no window is generated, and nothing is trained.";
    case Effort::windows:
      return "It costs the generating of windows; nothing is trained.";
    case Effort::classifier:
      return "It costs the training of the classifier; no window is generated.";
    case Effort::windows_and_classifier:
      return "It costs the training of the classifier; windows are generated without training.";
    case Effort::generator:
      return "It costs the training of a generator; the classifier needs none.";
    case Effort::generator_and_classifier:
      break;
  }
  return "It costs the training of a generator and of the classifier.";
}

/// The class of which the least is recognised; empty where all are recognised, or none is tested.
std::string least_recognised(const Recommendation& of) {
  const scoring::Confusion& confusion = of.recommended().confusion;
  std::string least;
  double percent = 100;
  for (std::size_t truth = 0; truth < confusion.classes; ++truth) {
    const scoring::Share recall = scoring::recall_of(confusion, truth);
    if (recall.of == 0 || recall.percent() >= percent) continue;
    percent = recall.percent();
    least = of.classes[truth].name;
  }
  return least.empty()
             ? ""
             : fmt::format(" Of the classes {} is recognised least, in {:.1f} %.", least, percent);
}

std::string what_it_gets_wrong(const Recommendation& of) {
  const scoring::Confusion& confusion = of.recommended().confusion;
  const scoring::Share missed = scoring::missed_faults(confusion, of.classes);
  const scoring::Share alarms = scoring::false_alarms(confusion, of.classes);
  std::vector<std::string> parts;
  if (missed.of > 0) {
    parts.push_back(
        fmt::format("{:.1f} % of the fault windows for healthy (missed faults)", missed.percent()));
  }
  if (alarms.of > 0) {
    parts.push_back(fmt::format("{:.1f} % of the healthy {} for a fault (false alarms)",
                                alarms.percent(), missed.of > 0 ? "ones" : "windows"));
  }
  return parts.empty() ? "" : "It takes " + listed(parts) + "." + least_recognised(of);
}

}  // namespace

std::string effort_label(Effort effort) {
  switch (effort) {
    case Effort::nothing:
      return "nothing";
    case Effort::windows:
      return "windows";
    case Effort::classifier:
      return "classifier";
    case Effort::windows_and_classifier:
      return "windows + classifier";
    case Effort::generator:
      return "generator";
    case Effort::generator_and_classifier:
      break;
  }
  return "generator + classifier";
}

std::string name_of(const Candidate& candidate, const Recommendation& of) {
  const AccuracyRow& row = candidate.row;
  return of.several_classifiers ? row.method + " by " + row.classifier
                                : run::name_by(row.method, row.classifier);
}

std::string share_label(const scoring::Share& share) {
  return share.of == 0 ? no_number : number_label(share.percent(), percent_style);
}

std::string behind_label(const Candidate& candidate) {
  if (!candidate.behind) return no_number;
  return number_label(candidate.behind->paired.difference.mean, in_points);
}

std::string holm_label(const Candidate& candidate) {
  const bool is_tested = candidate.behind && candidate.behind->p_holm;
  return is_tested ? fmt::format("{:.3g}", *candidate.behind->p_holm) : no_number;
}

std::vector<std::string> recommendation_sentences(const Recommendation& recommendation) {
  std::vector<std::string> sentences{what_to_take(recommendation),
                                     recommendation.taken == recommendation.best
                                         ? why_the_best(recommendation)
                                         : why_not_the_best(recommendation),
                                     what_it_costs(recommendation.recommended().effort)};
  std::string wrong = what_it_gets_wrong(recommendation);
  if (!wrong.empty()) sentences.push_back(std::move(wrong));
  return sentences;
}

std::string not_compared_note(const Recommendation& recommendation) {
  if (recommendation.left_out.empty()) return "";
  return "Not compared, for they lack seeds that the others have: " +
         listed(recommendation.left_out) + ".";
}

}  // namespace piae::report
