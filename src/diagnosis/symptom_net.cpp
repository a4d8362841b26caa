#include "diagnosis/symptom_net.hpp"

#include <utility>

namespace piae::diagnosis {

SymptomNet::SymptomNet(const artefact::Reader& reader, const signal::DatasetInfo& info)
    : SymptomNet(SymptomScale(reader, learned, info.sample_rate_hz), std::ssize(info.classes),
                 Stream("overwritten")) {
  network_.read(reader, learned);
}

Training SymptomNet::train(const Stream& stream, const EpochDone& epoch_done) {
  return train_on_symptoms(network_, scale_.training(), scale_.labels(), {}, stream, epoch_done);
}

Outputs SymptomNet::outputs(const signal::WindowSet& windows, const std::string& what) {
  const SymptomRows rows = scale_.rows_of(windows, what);
  Outputs all;
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const SymptomNetwork::Outputs outputs = network_.outputs(rows.row(i));
    append_outputs(outputs, {outputs.logits.data(), outputs.logits.data() + classes_}, all);
  }
  return all;
}

void SymptomNet::write(artefact::Writer& writer) const {
  scale_.write(writer, learned);
  network_.write(writer, learned);
}

Learned train_symptom_net(const signal::WindowSet& normal, const signal::WindowSet& training,
                          double prewhitening, const Stream& stream, const EpochDone& epoch_done) {
  auto net =
      std::make_unique<SymptomNet>(SymptomScale(normal, training, prewhitening),
                                   std::ssize(training.info.classes), stream.child("initial"));
  Training course = net->train(stream, epoch_done);
  return {.trained = std::move(net), .training = std::move(course)};
}

std::unique_ptr<Trained> read_symptom_net(const artefact::Reader& reader,
                                          const signal::DatasetInfo& info, std::size_t /*length*/) {
  return std::make_unique<SymptomNet>(reader, info);
}

}  // namespace piae::diagnosis
