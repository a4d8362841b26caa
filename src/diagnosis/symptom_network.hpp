#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "base/random.hpp"
#include "diagnosis/classifier.hpp"
#include "diagnosis/cross_entropy.hpp"
#include "diagnosis/symptom_inputs.hpp"
#include "nets/dense_chain.hpp"
#include "nets/parameters.hpp"
#include "nets/row_array.hpp"

namespace piae::diagnosis {

/// The network symptom-net: 17 symptoms, a hidden layer of 48 with ReLU, the classes. Adam trains
/// it on the cross-entropy.
class SymptomNetwork {
 public:
  static constexpr std::int64_t hidden = 48;
  static constexpr double dropout = 0.2;  ///< of the hidden layer, in training (Srivastava 2014)

  /// Makes a network for batches of up to `most_rows`; initial values come from the stream
  /// (nets/parameters.hpp).
  SymptomNetwork(std::int64_t classes, std::int64_t most_rows, const Stream& initial);

  /// Output for a batch.
  struct Outputs {
    nets::RowArray<double> hidden;  ///< [rows, 48] after ReLU
    nets::RowArray<double> logits;  ///< [rows, classes]
  };
  Outputs outputs(const SymptomRows& batch);

  /// Makes one step of Adam on a batch. The stream draws which hidden units are dropped; the others
  /// are scaled up, so that their sum stays the same on average.
  BatchOutcome step(const SymptomRows& batch, std::span<const Label> labels, double learning_rate,
                    Stream& dropped);

  /// Writes the parameters as <group>/hidden/0/weight and so on, in single precision.
  void write(artefact::Writer& writer, const std::string& group) const;
  /// Throws artefact::Refusal if a parameter is missing or has another shape.
  void read(const artefact::Reader& reader, const std::string& group);

 private:
  using Array = nets::RowArray<double>;
  Array run_hidden(const SymptomRows& batch);

  std::int64_t classes_;
  std::shared_ptr<nets::Parameters<double>> parameters_;
  nets::DenseChain<double> first_;
  nets::DenseChain<double> last_;
  std::int64_t steps_ = 0;
};

/// Appends the output of a network for one window, with the logits of the classes, and their
/// softmax.
void append_outputs(const SymptomNetwork::Outputs& of_window, const std::vector<float>& logits,
                    Outputs& all);

}  // namespace piae::diagnosis
