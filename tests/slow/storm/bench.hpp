#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "storm/consumers.hpp"
#include "storm/files.hpp"
#include "storm/program.hpp"

namespace piae::storm {

/// What became of one altered artefact.
struct Verdict {
  bool refused = false;  ///< by verify, by the stage, or by both
  std::string finding;   ///< what is not as promised; empty where all is
};

/// A copy of the corpus in which one artefact at a time is altered, and the programs that judge it.
class Workbench {
 public:
  Workbench(const std::filesystem::path& corpus, const std::filesystem::path& folder,
            const std::filesystem::path& programs);

  [[nodiscard]] const std::vector<Consumer>& consumers() const { return consumers_; }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] const std::string& good(const Consumer& consumer) const {
    return good_.at(consumer.file);
  }

  /// Runs `verify` and the stage on the corpus with these bytes in the artefact's place, and puts
  /// the corpus back. Where the same content is promised, what the stage writes must be what it
  /// writes of the good artefact.
  Verdict judge(const Consumer& consumer, const std::string& bytes, bool same_content);

 private:
  using Contents = std::map<std::string, std::string>;

  [[nodiscard]] std::vector<std::string> command(const Consumer& consumer) const;
  /// What stands in the folder beyond the corpus; it is removed.
  Contents take_new_files();
  /// Why what a stage did cannot be, or nothing.
  [[nodiscard]] std::string odd(const Consumer& consumer, const Outcome& verified,
                                const Outcome& outcome, const Contents& made) const;

  std::filesystem::path folder_;
  std::filesystem::path programs_;
  std::vector<Consumer> consumers_;
  std::map<std::string, std::string> good_;  ///< bytes of each artefact
  /// What a stage makes of the corpus as it is, by the artefact and the stage: several read one.
  std::map<std::pair<std::string, std::string>, Contents> made_of_good_;
  Files corpus_;
};

}  // namespace piae::storm
