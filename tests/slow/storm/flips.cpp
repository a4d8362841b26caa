// Flips one bit of an artefact at a time: verify and the stage that reads it must refuse it, or
// treat it exactly like the good artefact.

#include <exception>
#include <iostream>

#include "storm/bench.hpp"
#include "storm/dice.hpp"
#include "storm/tally.hpp"

using namespace piae::storm;

int main(int argc, char** argv) {
  try {
    const Requested requested = requested_by(argc, argv);
    Tally tally("flips", requested);
    Workbench bench(requested.corpus, requested.folder / "work", requested.programs);
    while (!tally.finished()) {
      Dice dice(requested.seed, tally.done());
      const Consumer& consumer = bench.consumers()[tally.done() % bench.consumers().size()];
      std::string bytes = bench.good(consumer);
      const std::size_t bit = dice.below(bytes.size() * 8);
      bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ static_cast<char>(1U << (bit % 8)));
      const Verdict verdict = bench.judge(consumer, bytes, true);
      if (!verdict.finding.empty()) {
        tally.keep_finding(std::filesystem::path(consumer.file).filename(), bytes,
                           consumer.file + ", bit " + std::to_string(bit) + ": " + verdict.finding);
      }
      tally.add(!verdict.finding.empty() ? Tally::Result::missed
                : verdict.refused        ? Tally::Result::refused
                                         : Tally::Result::accepted);
    }
    return tally.finish();
  } catch (const std::exception& error) {
    std::cerr << "flips: " << error.what() << '\n';
    return 2;
  }
}
