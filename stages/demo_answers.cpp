// Prints the answers to the questions of `make demo`.

#include "report/demo_answers.hpp"

#include <iostream>

#include "classification/record.hpp"
#include "cli/stage.hpp"
#include "run/held.hpp"

using namespace piae;
namespace fs = std::filesystem;

namespace {

std::vector<run::Diagnosis> diagnoses_of(const fs::path& run, const std::string& dataset) {
  const run::Layout layout(run, dataset);
  const run::Grid nothing_required{
      .dataset = dataset, .scored = {}, .combinations = {}, .seeds = {}};
  run::Collected held = run::collect_held_diagnoses(layout, nothing_required, run::Held(layout));
  run::require_all(held.results);
  return held.results.diagnoses;
}

}  // namespace

int main(int argc, char** argv) {
  cli::Stage stage(
      "demo_answers",
      "Prints the three questions of `make demo` with their answers, from the cells of "
      "its data sets and from what `classify` reported on a recording.",
      "demo_answers --run results/demo --same-speed simulated-small --other-speed "
      "simulated-small-slower --no-fault simulated-small-types-zero --diagnosis "
      "results/demo/recording.h5 --true-class outer");
  fs::path run;
  std::string same_speed;
  std::string other_speed;
  std::string no_fault;
  fs::path diagnosis;
  std::string true_class;
  stage.input_file("--run", run, "Folder of the run, such as results/demo");
  stage.options().add("--same-speed", same_speed, "Data set of the first question").required();
  stage.options().add("--other-speed", other_speed, "Data set of the second question").required();
  stage.options().add("--no-fault", no_fault, "Data set of the third question").required();
  stage.input_file("--diagnosis", diagnosis, "Classification of one recording, by `classify`");
  stage.options().add("--true-class", true_class, "Class of that recording").required();

  return stage.run(argc, argv, [&] {
    const auto named =
        classification::read_named(stage.open("diagnosis", diagnosis, "classification"));
    if (named.size() != 1) {
      throw Error(Exit::bad_input, diagnosis.string() + ": holds " + std::to_string(named.size()) +
                                       " recordings, not one; make it with `make demo`");
    }
    std::cout << report::demo_answers(
        {.same_speed = diagnoses_of(run, same_speed),
         .other_speed = diagnoses_of(run, other_speed),
         .no_fault = diagnoses_of(run, no_fault),
         .recording = {.file = named.front().recording,
                       .named = named.front().fault,
                       .correct = named.front().fault == true_class}});
  });
}
