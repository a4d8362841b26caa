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

/// Result for one altered artefact.
struct Verdict {
  bool refused = false;  ///< by verify, the stage or both
  std::string finding;   ///< broken promise; empty if there is none
};

/// A copy of the corpus with one altered artefact at a time, and the programs that judge it.
class Workbench {
 public:
  Workbench(const std::filesystem::path& corpus, const std::filesystem::path& folder,
            const std::filesystem::path& programs);

  [[nodiscard]] const std::vector<Consumer>& consumers() const { return consumers_; }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] const std::string& good(const Consumer& consumer) const {
    return good_.at(consumer.file);
  }

  /// Runs `verify` and the stage with these bytes as the artefact, and restores the corpus. With
  /// `same_content`, an accepted artefact must lead to the same output as the good one.
  Verdict judge(const Consumer& consumer, const std::string& bytes, bool same_content);

 private:
  using Contents = std::map<std::string, std::string>;

  [[nodiscard]] std::vector<std::string> command(const Consumer& consumer) const;
  /// Returns and removes the files that are not part of the corpus.
  Contents take_new_files();
  /// Returns why the programs' behaviour is wrong; empty if it is right.
  [[nodiscard]] std::string odd(const Consumer& consumer, const Outcome& verified,
                                const Outcome& outcome, const Contents& made) const;

  std::filesystem::path folder_;
  std::filesystem::path programs_;
  std::vector<Consumer> consumers_;
  std::map<std::string, std::string> good_;  ///< bytes of each artefact
  /// Outputs for the good corpus, by artefact and stage, because several stages read the same
  /// artefact.
  std::map<std::pair<std::string, std::string>, Contents> made_of_good_;
  Files corpus_;
};

}  // namespace piae::storm
