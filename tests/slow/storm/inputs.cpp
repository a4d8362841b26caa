// Reads damaged inputs in a child process under the sanitizers: raw recordings, descriptions,
// settings and artefacts. Each has random changes, or changed content and valid digests. The child
// reports each result through a pipe. A crash or 20 s of silence is our fault. The exception is a
// crash inside a library that reads files (HDF5, matio, sndfile): the programs isolate such
// crashes, so the programs are run instead.

#include <omp.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <exception>
#include <iostream>
#include <map>
#include <sstream>
#include <vector>

#include "base/error.hpp"
#include "base/one_line.hpp"
#include "storm/files.hpp"
#include "storm/meaning.hpp"
#include "storm/mutation.hpp"
#include "storm/program.hpp"
#include "storm/tally.hpp"
#include "storm/targets.hpp"

using namespace piae;
using namespace piae::storm;
namespace fs = std::filesystem;

namespace {

/// File of the corpus.
struct Seed {
  std::string name;
  std::string bytes;
  std::vector<Block> blocks;  ///< checksummed blocks of an artefact
};

/// An altered file and its reader.
struct Input {
  const Target* target = nullptr;
  fs::path file;
  const Seed* seed = nullptr;
  const Seed* other = nullptr;  ///< source of inserted bytes
};

class Inputs {
 public:
  Inputs(const Requested& requested, fs::path folder)
      : seed_(requested.seed), folder_(std::move(folder)) {
    for (const Target& target : targets()) {
      const fs::path from = requested.corpus.parent_path() / "inputs" / target.name;
      fs::create_directories(folder_ / target.name);
      std::vector<Seed>& seeds = seeds_[target.name];
      for (const auto& entry : fs::directory_iterator(from)) {
        Seed seed{entry.path().filename(), bytes_of(entry.path()), {}};
        if (is_artefact(target)) seed.blocks = checksummed_blocks(seed.bytes);
        seeds.push_back(std::move(seed));
      }
      if (seeds.empty()) throw std::runtime_error(from.string() + ": is empty");
      std::ranges::sort(seeds, {}, &Seed::name);
      for (const Seed& seed : seeds) {
        files_[target.name].push_back(folder_ / target.name / seed.name);
        write_bytes(files_[target.name].back(), seed.bytes);
      }
    }
  }

  /// Chooses the file of an input.
  [[nodiscard]] Input choose(Dice& dice) const {
    Input input;
    // Artefacts get three times the share, because they have most kinds and take longest.
    const std::size_t choice = dice.below(targets().size() + 2);
    input.target = &targets()[std::min(choice, targets().size() - 1)];
    const std::vector<Seed>& seeds = seeds_.at(input.target->name);
    const std::size_t which = dice.below(seeds.size());
    input.seed = &seeds[which];
    input.file = files_.at(input.target->name)[which];
    input.other = &dice.one_of(seeds);
    return input;
  }
  [[nodiscard]] Input choose(std::size_t i) const {
    Dice dice(seed_, i);
    return choose(dice);
  }

  /// Writes input i into its file. Returns how it was changed.
  [[nodiscard]] std::string make(std::size_t i) const {
    Dice dice(seed_, i);
    const Input input = choose(dice);
    const Seed& seed = *input.seed;
    if (is_artefact(*input.target) && dice.one_in(3)) {
      write_bytes(input.file, seed.bytes);
      return change_meaning(input.file, files_.at(input.target->name), dice);
    }
    const bool renewed = !seed.blocks.empty() && dice.one_in(2);
    write_bytes(input.file, renewed ? mutated_with_checksums(seed.bytes, seed.blocks, dice)
                                    : mutated(seed.bytes, input.other->bytes, dice));
    return renewed ? "damaged, with good checksums" : "damaged";
  }

  /// Restores the good file, because other inputs read files next to it.
  static void put_back(const Input& input) { write_bytes(input.file, input.seed->bytes); }

  /// Requires the readers to accept the whole corpus, otherwise the storm tests nothing. Skips
  /// files named refused-, whose formats are not ours.
  void require_good() const {
    for (const Target& target : targets()) {
      for (const fs::path& file : files_.at(target.name)) {
        if (!file.filename().string().starts_with("refused-")) target.read(file);
      }
    }
  }

 private:
  static bool is_artefact(const Target& target) { return target.name == std::string("artefact"); }

  std::uint64_t seed_;
  fs::path folder_;
  std::map<std::string, std::vector<Seed>> seeds_;
  std::map<std::string, std::vector<fs::path>> files_;
};

/// Letter that the child reports for an input; for a miss, a file holds the reason.
enum Verdict : char { refused = 'r', accepted = 'a', missed = 'm' };

Verdict read(const Input& input, const fs::path& reason) {
  std::string what;
  try {
    input.target->read(input.file);
    return accepted;
  } catch (const Error& error) {
    what = one_line(error.what());  // as programs print it
    const bool documented = error.exit() == Exit::bad_input || error.exit() == Exit::input_missing;
    const bool names = what.find(input.file.filename()) != std::string::npos;
    if (documented && names) return refused;
    what = "refused with " + std::to_string(static_cast<int>(error.exit())) + ": " + what;
  } catch (const std::exception& error) {
    what = std::string("an exception that no program expects: ") + error.what();
  }
  write_bytes(reason, what);
  return missed;
}

bool has_grown_too_much() {
  rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
  return static_cast<double>(used.ru_maxrss) / 1024 > most_mb;
}

/// Paths of one run.
struct Place {
  fs::path reports;  ///< folder of the sanitizers' reports
  fs::path words;    ///< change of the last input; missing while the input is made
  fs::path reason;
};

/// Returns the sanitizers' reports.
std::string report_in(const fs::path& reports) {
  std::string text;
  for (const auto& entry : fs::directory_iterator(reports)) text += bytes_of(entry.path());
  return text;
}

/// Returns the sanitizers' reports and removes their files.
std::string take_report(const fs::path& reports) {
  std::string text = report_in(reports);
  for (const auto& entry : fs::directory_iterator(reports)) fs::remove(entry.path());
  return text;
}

/// True if the report holds failed allocations only, in a target that libraries read. Libraries
/// trust the sizes in a file, but our own readers must not.
bool only_lacks_memory(const std::string& report, const Target& target) {
  if (!target.by_libraries) return false;
  std::istringstream lines(report);
  for (std::string line; std::getline(lines, line);) {
    if (line.find("failed to allocate") == std::string::npos) return false;
  }
  return true;
}

/// Runs the child: reads inputs until they end or one of them leaves a report.
[[noreturn]] void be_the_child(const Inputs& inputs, const Place& place, std::size_t first,
                               std::size_t count, int to) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (std::size_t i = first; i < count; ++i) {
    fs::remove(place.words);
    write_bytes(place.words, inputs.make(i));
    const Input input = inputs.choose(i);
    const Verdict verdict = read(input, place.reason);
    if (!fs::is_empty(place.reports)) {
      if (!only_lacks_memory(report_in(place.reports), *input.target)) ::_exit(3);
      (void)take_report(place.reports);
    }
    if (has_grown_too_much()) ::_exit(3);
    if (::write(to, &verdict, 1) != 1) ::_exit(4);
    if (verdict == missed) break;  // the reason and the altered bytes are in files
    Inputs::put_back(input);
  }
  ::_exit(0);
}

/// True if the innermost function of a report, apart from the sanitizers and the system, belongs to
/// a library that reads files.
bool died_in_libraries(const std::string& report) {
  std::istringstream lines(report);
  for (std::string line; std::getline(lines, line);) {
    if (line.find("    #") != 0) continue;
    const auto has = [&](const char* word) { return line.find(word) != std::string::npos; };
    if (has("libhdf5") || has("libmatio") || has("libz.so") || has("libsndfile") ||
        has("libFLAC")) {
      return true;
    }
    if (!has("libsanitizer") && !has("libasan") && !has("libubsan") && !has("libc.so") &&
        !has("libstdc++") && !has("sysdeps")) {
      return false;
    }
  }
  return report.empty();  // a stack overflow leaves no report
}

class Storm {
 public:
  explicit Storm(const Requested& requested)
      : requested_(requested),
        inputs_(requested, requested.folder / "work"),
        tally_("inputs", requested),
        place_{requested.folder / "reports", requested.folder / "words",
               requested.folder / "reason"} {
    fs::create_directories(place_.reports);
    (void)take_report(place_.reports);
  }

  int run() {
    inputs_.require_good();
    while (!tally_.finished()) run_child();
    std::cout << "inputs: " << contained_
              << " of these ended inside HDF5 or matio, and the programs "
              << "refused them; " << unmade_ << " ended HDF5 while they were made\n";
    const int status = tally_.finish();
    if (100 * unmade_ <= requested_.count) return status;
    std::cerr
        << "inputs: more than one in a hundred inputs could not be made, so too few were tried\n";
    return 1;
  }

 private:
  void run_child() {
    std::array<int, 2> pipe{};
    if (::pipe(pipe.data()) != 0) throw std::runtime_error("no pipe");
    const pid_t child = ::fork();
    if (child == 0) be_the_child(inputs_, place_, tally_.done(), requested_.count, pipe[1]);
    if (child < 0) throw std::runtime_error("fork failed");
    ::close(pipe[1]);
    const End end = receive(pipe[0]);
    const bool hung = end == End::silence;
    ::close(pipe[0]);
    if (hung) ::kill(child, SIGKILL);
    int status = 0;
    rusage used{};
    ::wait4(child, &status, 0, &used);
    if (end == End::missed || tally_.finished()) return;
    const bool big = static_cast<double>(used.ru_maxrss) / 1024 > most_mb;
    look_into(hung                  ? "hung for 20 s"
              : big                 ? "took more than 1 GB"
              : WIFSIGNALED(status) ? "ended by signal " + std::to_string(WTERMSIG(status))
                                    : "ended");
  }

  /// Reason for the child's silence: it reported a miss, ended or crashed, or was silent for too
  /// long.
  enum class End { missed, ended, silence };

  /// Counts the child's letters until it is silent.
  End receive(int from) {
    char letter = 0;
    for (;;) {
      pollfd ready{from, POLLIN, 0};
      if (::poll(&ready, 1, static_cast<int>(most_seconds * 1000)) == 0) return End::silence;
      if (::read(from, &letter, 1) != 1) return End::ended;
      if (letter == missed) {
        miss(bytes_of(place_.reason));
        return End::missed;
      }
      tally_.add(letter == refused ? Tally::Result::refused : Tally::Result::accepted);
    }
  }

  /// Records a miss of the next input to be counted. Its file still holds the altered bytes.
  void miss(const std::string& what) {
    const Input input = inputs_.choose(tally_.done());
    tally_.keep_finding(
        input.file.filename(), bytes_of(input.file),
        std::string(input.target->name) + ", " + bytes_of(place_.words) + ": " + what);
    Inputs::put_back(input);
    tally_.add(Tally::Result::missed);
  }

  void look_into(const std::string& how) {
    const std::string report = take_report(place_.reports);
    const Input input = inputs_.choose(tally_.done());
    const bool in_libraries = input.target->by_libraries && died_in_libraries(report);
    const bool is_made = fs::exists(place_.words);
    std::string what;  // empty if it ended before any reader saw the input
    if (is_made) {
      what = in_libraries ? failure_of_programs(*input.target, input.file, requested_.programs)
                          : how + "\n" + report;
    }
    if (!what.empty()) return miss(what);
    ++(is_made ? contained_ : unmade_);
    Inputs::put_back(input);
    tally_.add(Tally::Result::refused);
  }

  Requested requested_;
  Inputs inputs_;
  Tally tally_;
  Place place_;
  std::size_t contained_ = 0;
  std::size_t unmade_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  omp_set_num_threads(1);  // OpenMP threads do not survive a fork
  try {
    return Storm(requested_by(argc, argv)).run();
  } catch (const std::exception& error) {
    std::cerr << "inputs: " << error.what() << '\n';
    return 2;
  }
}
