#include "diagnosis/classify.hpp"

#include <string>

#include "diagnosis/nearest.hpp"
#include "scoring/diagnosis_record.hpp"

namespace piae::diagnosis {

namespace {

WdcnnResult ask_nearest(const signal::WindowSet& training, const signal::WindowSet& test) {
  WdcnnResult result;
  result.predictions = classify_by_nearest(training, test);
  result.outputs.scores = scores_of_named(result.predictions, test.info.classes.size());
  return result;
}

}  // namespace

WdcnnResult classify(const Classifier& classifier, const signal::WindowSet& training,
                     const signal::WindowSet& test, const WdcnnOptions& options,
                     const Stream& stream, const MakeWdcnnBackend& make_backend,
                     const EpochDone& epoch_done) {
  if (!classifier.trains()) return ask_nearest(training, test);
  const std::string name = classifier.name;
  // Of the paper's classifier the name is what it was when there was no other.
  const Stream own = name == scoring::paper_classifier ? stream : stream.child(name);
  return train_and_test(classifier.represent(training, "training set"),
                        classifier.represent(test, "--test"), options, own, make_backend,
                        epoch_done);
}

}  // namespace piae::diagnosis
