#include "plan/contrast_steps.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "base/error.hpp"
#include "plan/words.hpp"
#include "scoring/diagnosis_record.hpp"

namespace piae::plan {

namespace {

/// One side of a contrast: a data set of a run, and its cells by the paper's classifier.
struct Side {
  std::string folder;
  TableCells cells;
};

class Contrasts {
 public:
  explicit Contrasts(TableSteps& tables)
      : tables_(tables),
        choice_(tables.choice()),
        random_(tables.experiment(), choice_, signal::Protocol::random, tables.grid().graph()),
        blocked_(tables.experiment(), choice_, signal::Protocol::blocked, tables.grid().graph()),
        random_tables_(tables.experiment(), choice_, random_, tables.judge(), tables.disk()),
        blocked_tables_(tables.experiment(), choice_, blocked_, tables.judge(), tables.disk()) {}

  void of_protocols(const Part& part) {
    add(side(random_, random_tables_, part), side(blocked_, blocked_tables_, part), part,
        "protocols", "contrast");
  }
  void of_rates(const Part& as_published, const Part& at_one_rate) {
    add(side(random_, random_tables_, as_published), side(random_, random_tables_, at_one_rate),
        as_published, "rates", "contrast@rates");
  }

 private:
  [[nodiscard]] Words methods_of(const Part& part) const {
    Words methods;
    for (const run::Combination& cell : part.cells) {
      const bool is_new = std::ranges::count(methods, cell.method) == 0;
      if (cell.classifier == scoring::paper_classifier && is_new) methods.push_back(cell.method);
    }
    return methods;
  }

  Side side(GridSteps& grid, TableSteps& tables, const Part& part) {
    std::vector<StepId> requested;
    for (const std::int64_t seed : choice_.seeds) {
      for (const run::Combination& cell : part.cells) {
        if (cell.classifier != scoring::paper_classifier) continue;
        requested.push_back(grid.diagnosis(part.dataset, seed, variant_of(cell.method), cell.ratio,
                                           cell.classifier));
        if (run::has_score(cell.method)) {
          grid.score(part.dataset, seed, variant_of(cell.method));
        }
      }
    }
    return {grid.folder() + '/' + part.dataset.name,
            tables.with_held(part.dataset, requested, [](const HeldCell& cell) {
              return cell.kind == HeldCell::Kind::diagnosis &&
                     cell.variant.folder == cell.variant.method &&
                     cell.classifier == scoring::paper_classifier;
            })};
  }

  void add(const Side& with, const Side& without, const Part& part, const std::string& name,
           const std::string& log) {
    const std::string table = with.folder + '/' + name;
    Step step{.stage = "contrast",
              .folder = with.folder,
              .log = log,
              .words = {"--with", with.folder, "--without", without.folder},
              .outputs = {table + ".md", table + ".csv", table + ".tex"},
              .output_option = "output",
              .place = {.dataset = part.dataset.name}};
    append_option(step.words, "methods", methods_of(part));
    append_option(step.words, "ratios", choice_.ratios);
    append_option(step.words, "seeds", texts_of(choice_.seeds));
    Words left_out = with.cells.left_out;
    append(left_out, without.cells.left_out);
    std::ranges::sort(left_out);
    left_out.erase(std::unique(left_out.begin(), left_out.end()), left_out.end());
    append_option(step.words, "leave-out", left_out);
    Words files = with.cells.files;
    append(files, without.cells.files);
    tables_.show(step.outputs.front());
    random_tables_.add(std::move(step), "cells", files);
  }

  TableSteps& tables_;
  const Choice& choice_;
  GridSteps random_;
  GridSteps blocked_;
  TableSteps random_tables_;
  TableSteps blocked_tables_;
};

}  // namespace

void add_contrasts(TableSteps& tables) {
  Contrasts contrasts(tables);
  const std::vector<Part>& parts = tables.choice().parts;
  const auto part_of = [&](const std::string& dataset) {
    const auto found =
        std::ranges::find_if(parts, [&](const Part& part) { return part.dataset.name == dataset; });
    return found == parts.end() ? nullptr : &*found;
  };
  if (!has(tables.choice().classifiers, scoring::paper_classifier)) {
    throw Error(Exit::usage,
                fmt::format("make contrast: CLASSIFIERS must include {}, the paper's classifier",
                            scoring::paper_classifier));
  }
  for (const Part& part : parts) contrasts.of_protocols(part);
  const Part* const as_published = part_of("cwru-as-published");
  const Part* const at_one_rate = part_of("cwru");
  if (as_published != nullptr && at_one_rate != nullptr) {
    contrasts.of_rates(*as_published, *at_one_rate);
  }
}

}  // namespace piae::plan
