#include "storm/bench.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace piae::storm {

namespace {

namespace fs = std::filesystem;

std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of('\n');
  if (end == std::string::npos) return {};
  const std::size_t before = text.find_last_of('\n', end);
  return text.substr(before + 1, end - before);
}

bool names(const std::string& line, const std::string& file) {
  return line.find(fs::path(file).filename().string()) != std::string::npos;
}

/// Describes a hang, crash or memory use that no program may show for any input; "" if there is
/// none.
std::string out_of_bounds(const std::string& program, const std::string& file,
                          const Outcome& outcome) {
  const std::string printed = "; it said: " + outcome.err + outcome.out;
  if (outcome.hung) return program + " ran for more than 20 s" + printed;
  if (outcome.status > 128) {
    return program + " was ended by signal " + std::to_string(outcome.status - 128) + printed;
  }
  if (took_too_much(outcome, file)) {
    return program + " took " + std::to_string(outcome.peak_mb) + " MB" + printed;
  }
  return {};
}

std::string odd_of_verify(const std::string& file, const Outcome& verified) {
  std::string bad = out_of_bounds("verify", file, verified);
  if (!bad.empty()) return bad;
  const std::string printed = "; it said: " + verified.err + verified.out;
  if (!verified.err.empty()) return "verify printed errors" + printed;
  if (verified.status == 0)
    return verified.out.empty() ? "" : "verify found all good, but" + printed;
  constexpr int reasons = 1 | 4 | 8 | 16 | 32;
  if ((verified.status & ~reasons) != 0) {
    return "verify ended with " + std::to_string(verified.status) + printed;
  }
  std::istringstream lines(verified.out);
  std::string line;
  bool any = false;
  while (std::getline(lines, line)) {
    any = true;
    if (!names(line, file)) return "verify does not name the file" + printed;
  }
  return any ? "" : "verify refused without a word";
}

}  // namespace

std::vector<Consumer> read_consumers(const fs::path& corpus) {
  std::istringstream lines(bytes_of(corpus / "consumers"));
  std::vector<Consumer> consumers;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    Consumer consumer;
    words >> consumer.file >> consumer.stage;
    for (std::string word; words >> word;) consumer.options.push_back(word);
    consumers.push_back(consumer);
  }
  return consumers;
}

Workbench::Workbench(const fs::path& corpus, const fs::path& folder, const fs::path& programs)
    : folder_(folder), programs_(fs::absolute(programs)), consumers_(read_consumers(corpus)) {
  fs::remove_all(folder_);
  fs::create_directories(folder_);
  fs::copy(corpus, folder_, fs::copy_options::recursive);
  corpus_ = files_below(folder_);
  for (const Consumer& consumer : consumers_) {
    good_[consumer.file] = bytes_of(folder_ / consumer.file);
    const Outcome verified = run(folder_, {(programs_ / "verify").string(), consumer.file});
    const Outcome outcome = run(folder_, command(consumer));
    if (verified.status != 0 || outcome.status != 0) {
      throw std::runtime_error(consumer.file + ": the good artefact is refused: " + verified.out +
                               outcome.err);
    }
    write_bytes(folder_ / consumer.file, good_[consumer.file]);  // a used checkpoint is gone
    made_of_good_[{consumer.file, consumer.stage}] = take_new_files();
  }
}

std::vector<std::string> Workbench::command(const Consumer& consumer) const {
  std::vector<std::string> words{(programs_ / consumer.stage).string()};
  words.insert(words.end(), consumer.options.begin(), consumer.options.end());
  return words;
}

Workbench::Contents Workbench::take_new_files() {
  Contents contents;
  for (const auto& [name, time] : files_below(folder_)) {
    if (corpus_.contains(name)) continue;
    contents[name] = bytes_of(folder_ / name);
    fs::remove(folder_ / name);
  }
  return contents;
}

std::string Workbench::odd(const Consumer& consumer, const Outcome& verified,
                           const Outcome& outcome, const Contents& made) const {
  std::string bad = odd_of_verify(consumer.file, verified);
  if (bad.empty()) bad = out_of_bounds(consumer.stage, consumer.file, outcome);
  if (!bad.empty()) return bad;
  const std::string printed = "; it said: " + outcome.err + outcome.out;
  const auto same_name = [](const auto& a, const auto& b) { return a.first == b.first; };
  if (outcome.status == 0) {
    const Contents& expected = made_of_good_.at({consumer.file, consumer.stage});
    const bool as_good = std::ranges::equal(made, expected, same_name);
    return as_good ? "" : consumer.stage + " left other files than of the good artefact" + printed;
  }
  if (!made.empty()) return consumer.stage + " refused and left " + made.begin()->first + printed;
  // The options are good, so an error is due to the data; only training may also diverge.
  const std::string line = last_line(outcome.err);
  const bool diverged = outcome.status == 1 && line.find("diverge") != std::string::npos;
  if (outcome.status != 65 && !diverged) {
    return consumer.stage + " ended with " + std::to_string(outcome.status) + printed;
  }
  if (!line.starts_with(consumer.stage + ": ")) return "an error without its stage" + printed;
  // tabulate lists all refused files before its last line.
  if (!diverged && !names(outcome.err, consumer.file)) {
    return consumer.stage + " does not name the file" + printed;
  }
  return {};
}

Verdict Workbench::judge(const Consumer& consumer, const std::string& bytes, bool same_content) {
  write_bytes(folder_ / consumer.file, bytes);
  const Outcome verified = run(folder_, {(programs_ / "verify").string(), consumer.file});
  const Outcome outcome = run(folder_, command(consumer));
  write_bytes(folder_ / consumer.file, good(consumer));
  const Contents made = take_new_files();

  Verdict verdict;
  verdict.refused = verified.status != 0 || outcome.status != 0;
  verdict.finding = odd(consumer, verified, outcome, made);
  if (!verdict.finding.empty() || !same_content) return verdict;
  if (consumer.starts_anew() && outcome.status != 0) {
    verdict.finding = consumer.stage + " did not restart: " + outcome.err;
    return verdict;
  }
  if (outcome.status == 0 && made != made_of_good_.at({consumer.file, consumer.stage})) {
    verdict.finding = consumer.stage + " made something else of it, silently";
  } else if (verified.status == 0 && outcome.status != 0) {
    verdict.finding = "verify found nothing, but " + outcome.err;
  } else if (verified.status != 0 && outcome.status == 0 && !consumer.starts_anew()) {
    verdict.finding = consumer.stage + " used what verify refuses: " + verified.out;
  }
  return verdict;
}

}  // namespace piae::storm
