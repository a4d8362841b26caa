// Changes the content of an artefact and renews its digests: verify and the stage that reads it
// must refuse it as documented or accept it.

#include <exception>
#include <iostream>

#include "storm/bench.hpp"
#include "storm/meaning.hpp"
#include "storm/tally.hpp"

using namespace piae::storm;
namespace fs = std::filesystem;

namespace {

std::string judge(Workbench& bench, const Consumer& consumer, Dice& dice, Tally& tally,
                  Tally::Result& result) {
  std::vector<fs::path> others;
  for (const Consumer& other : bench.consumers()) others.push_back(bench.folder() / other.file);
  const fs::path altered = bench.folder().parent_path() / "altered.h5";
  write_bytes(altered, bench.good(consumer));
  const std::string change = change_meaning(altered, others, dice);
  const std::string bytes = bytes_of(altered);
  const Verdict verdict = bench.judge(consumer, bytes, false);
  result = verdict.refused ? Tally::Result::refused : Tally::Result::accepted;
  if (verdict.finding.empty()) return change;
  result = Tally::Result::missed;
  tally.keep_finding(fs::path(consumer.file).filename(), bytes,
                     consumer.file + ": " + change + ": " + verdict.finding);
  return change;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const Requested requested = requested_by(argc, argv);
    Tally tally("meanings", requested);
    Workbench bench(requested.corpus, requested.folder / "work", requested.programs);
    while (!tally.finished()) {
      Dice dice(requested.seed, tally.done());
      const Consumer& consumer = bench.consumers()[tally.done() % bench.consumers().size()];
      auto result = Tally::Result::missed;
      judge(bench, consumer, dice, tally, result);
      tally.add(result);
    }
    return tally.finish();
  } catch (const std::exception& error) {
    std::cerr << "meanings: " << error.what() << '\n';
    return 2;
  }
}
