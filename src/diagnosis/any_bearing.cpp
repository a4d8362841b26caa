#include "diagnosis/any_bearing.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "diagnosis/fault_types.hpp"
#include "diagnosis/symptom_inputs.hpp"

namespace piae::diagnosis {

namespace {

SymptomRows rows_of_lessons(const std::vector<symptoms::Symptoms>& lessons) {
  SymptomRows rows(lessons.size(), SymptomRows::ColsAtCompileTime);
  for (std::size_t i = 0; i < lessons.size(); ++i) {
    std::ranges::copy(lessons[i], rows.row(static_cast<Eigen::Index>(i)).begin());
  }
  return rows;
}

/// The network on one machine.
class FittedNetwork final : public Trained {
 public:
  /// Reads the network from its own file or from that of a kept classifier.
  FittedNetwork(SymptomScale scale, const artefact::Reader& reader)
      : scale_(std::move(scale)), network_(AnyBearingNetwork::outputs, 1, Stream("overwritten")) {
    network_.read(reader, learned);
  }

  Outputs outputs(const signal::WindowSet& windows, const std::string& what) override {
    const SymptomRows rows = scale_.rows_of(windows, what);
    const std::size_t classes = windows.info.classes.size();
    Outputs all;
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
      const SymptomNetwork::Outputs one = network_.outputs(rows.row(i));
      std::vector<float> logits(classes);
      for (const Label label : windows.info.labels()) {
        const signal::Defect defect = windows.info.class_of(label).defect;
        const std::size_t place =
            defect == signal::Defect::none ? 0 : 1 + place_among_types(defect);
        logits[index_of(label)] =
            static_cast<float>(one.logits(0, static_cast<Eigen::Index>(place)));
      }
      append_outputs(one, logits, all);
    }
    return all;
  }
  void write(artefact::Writer& writer) const override {
    scale_.write(writer, learned);
    network_.write(writer, learned);
  }

 private:
  SymptomScale scale_;
  SymptomNetwork network_;
};

}  // namespace

AnyBearingNetwork::AnyBearingNetwork(const std::vector<symptoms::Symptoms>& lessons,
                                     const std::vector<Label>& labels, double prewhitening,
                                     const Stream& stream, const EpochDone& epoch_done)
    : prewhitening_(prewhitening),
      rows_(rows_of_lessons(lessons)),
      standard_(rows_),
      network_(outputs, SymptomTraining::batch, stream.child("initial")),
      training_(train_on_symptoms(network_, standard_.scaled(rows_), labels, settings, stream,
                                  epoch_done)) {
  rows_.resize(0, SymptomRows::ColsAtCompileTime);
}

void AnyBearingNetwork::write(artefact::Writer& writer) const {
  standard_.write(writer, learned);
  network_.write(writer, learned);
  writer.attribute(learned, symptoms::prewhitening_name, prewhitening_);
}

void require_any_bearing(const artefact::Reader& reader) {
  (void)reader.real(learned, symptoms::prewhitening_name, symptoms::possible_prewhitening);
  (void)SymptomStandard(reader, learned);
  SymptomNetwork(AnyBearingNetwork::outputs, 1, Stream("overwritten")).read(reader, learned);
}

std::unique_ptr<Trained> fit_any_bearing(const artefact::Reader& network,
                                         const signal::WindowSet& normal) {
  require_fault_types(normal.info);
  SymptomScale scale(
      normal, SymptomStandard(network, learned),
      network.real(learned, symptoms::prewhitening_name, symptoms::possible_prewhitening));
  return std::make_unique<FittedNetwork>(std::move(scale), network);
}

std::unique_ptr<Trained> read_any_bearing(const artefact::Reader& reader,
                                          const signal::DatasetInfo& info, std::size_t /*length*/) {
  require_fault_types(info);
  return std::make_unique<FittedNetwork>(SymptomScale(reader, learned, info.sample_rate_hz),
                                         reader);
}

}  // namespace piae::diagnosis
