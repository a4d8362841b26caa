#include "diagnosis/classify.hpp"

#include <string>

#include "scoring/diagnosis_record.hpp"

namespace piae::diagnosis {

WdcnnResult classify(const Classifier& classifier, const signal::WindowSet& normal,
                     const signal::WindowSet& training, const signal::WindowSet& test,
                     const WdcnnOptions& options, const Stream& stream,
                     const MakeWdcnnBackend& make_backend, const EpochDone& epoch_done) {
  const std::string name = classifier.name;
  // Of the paper's classifier the name is what it was when there was no other.
  const Stream own = name == scoring::paper_classifier ? stream : stream.child(name);
  if (classifier.ask != nullptr) {
    return classifier.ask(normal, training, test, own, epoch_done);
  }
  return train_and_test(classifier.represent(training, "training set"),
                        classifier.represent(test, "--test"), options, own, make_backend,
                        epoch_done);
}

std::int64_t epochs_of(const Classifier& classifier, const WdcnnOptions& options) {
  return classifier.represent != nullptr ? options.epochs : classifier.own_epochs;
}

}  // namespace piae::diagnosis
