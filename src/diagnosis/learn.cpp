#include "diagnosis/learn.hpp"

#include <string>
#include <utility>

#include "diagnosis/wdcnn.hpp"
#include "scoring/diagnosis_record.hpp"

namespace piae::diagnosis {

Learned learn(const Classifier& classifier, const signal::WindowSet& normal,
              const signal::WindowSet& training, const WdcnnOptions& options, const Stream& stream,
              const MakeWdcnnBackend& make_backend, const EpochDone& epoch_done) {
  const std::string name = classifier.name;
  // Of the paper's classifier the name is what it was when there was no other.
  const Stream own = name == scoring::paper_classifier ? stream : stream.child(name);
  if (classifier.learn != nullptr) return classifier.learn(normal, training, own, epoch_done);
  LabelledWindows shown = classifier.represent(training, "training set");
  const std::size_t length = shown.length;
  TrainedWdcnn wdcnn = train_wdcnn(std::move(shown), options, own, make_backend, epoch_done);
  return {.trained = std::make_unique<WdcnnOfWindows>(std::move(wdcnn.network), length,
                                                      classifier.represent),
          .training = std::move(wdcnn.training)};
}

std::unique_ptr<Trained> read_learned(const Classifier& classifier, const artefact::Reader& reader,
                                      const signal::DatasetInfo& info, std::size_t length) {
  if (classifier.read != nullptr) return classifier.read(reader, info, length);
  return std::make_unique<WdcnnOfWindows>(reader, info, classifier.represent);
}

std::int64_t epochs_of(const Classifier& classifier, const WdcnnOptions& options) {
  return classifier.represent != nullptr ? options.epochs : classifier.own_epochs;
}

}  // namespace piae::diagnosis
