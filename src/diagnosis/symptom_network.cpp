#include "diagnosis/symptom_network.hpp"

#include <vector>

#include "nets/stored_parameters.hpp"

namespace piae::diagnosis {

namespace {

constexpr auto symptoms_seen = static_cast<std::int64_t>(symptoms::number_of_symptoms);

std::vector<nets::ParameterSpec> both_layers(std::int64_t classes) {
  std::vector<nets::ParameterSpec> specs =
      nets::dense_chain_specs("hidden", symptoms_seen, SymptomNetwork::hidden, {.depth = 1});
  append(specs, nets::dense_chain_specs("classes", SymptomNetwork::hidden, classes, {.depth = 1}));
  return specs;
}

/// Returns 0 for dropped units, and a factor above 1 for the others.
nets::RowArray<double> drawn_dropout(std::int64_t rows, Stream& dropped) {
  nets::RowArray<double> factors(rows, SymptomNetwork::hidden);
  for (double& factor : factors.reshaped<Eigen::RowMajor>()) {
    const bool drop = dropped.uniform(0, 1) < SymptomNetwork::dropout;
    factor = drop ? 0 : 1 / (1 - SymptomNetwork::dropout);
  }
  return factors;
}

}  // namespace

SymptomNetwork::SymptomNetwork(std::int64_t classes, std::int64_t most_rows, const Stream& initial)
    : classes_(classes),
      parameters_(std::make_shared<nets::Parameters<double>>(both_layers(classes), initial)),
      first_(parameters_, "hidden", most_rows),
      last_(parameters_, "classes", most_rows) {}

SymptomNetwork::Array SymptomNetwork::run_hidden(const SymptomRows& batch) {
  nets::put<double>(batch.array(), first_.input());
  return nets::copied(first_.forward(batch.rows()), batch.rows(), hidden).max(0.0);
}

SymptomNetwork::Outputs SymptomNetwork::outputs(const SymptomRows& batch) {
  Outputs outputs{.hidden = run_hidden(batch), .logits = {}};
  nets::put(outputs.hidden, last_.input());
  outputs.logits = nets::copied(last_.forward(batch.rows()), batch.rows(), classes_);
  return outputs;
}

BatchOutcome SymptomNetwork::step(const SymptomRows& batch, std::span<const Label> labels,
                                  double learning_rate, Stream& dropped) {
  const std::int64_t rows = batch.rows();
  const Array units = run_hidden(batch);
  const Array factors = drawn_dropout(rows, dropped);
  nets::put<double>(units * factors, last_.input());
  const nets::Rows<const double> logits = last_.forward(rows);
  const BatchOutcome outcome =
      cross_entropy(classes_, logits.stride, labels, logits.data, last_.output_gradient().data);
  const nets::Rows<const double> by_units = last_.backward(rows, 1, {.begin = 0, .count = rows});
  const Array passed = (units > 0).select(nets::copied(by_units, rows, hidden) * factors, 0.0);
  nets::put(passed, first_.output_gradient());
  (void)first_.backward(rows, 1, nets::no_rows);
  const nets::AdamStep adam(++steps_, learning_rate);
  for (nets::DenseChain<double>* const layer : {&first_, &last_}) {
    layer->take(adam, 1, {.of_weights = rows, .of_biases = rows});
  }
  return outcome;
}

void SymptomNetwork::write(artefact::Writer& writer, const std::string& group) const {
  nets::write_parameters(writer, group, both_layers(classes_),
                         parameters_->read(nets::Parameters<double>::Kept::value));
}

void SymptomNetwork::read(const artefact::Reader& reader, const std::string& group) {
  parameters_->write(nets::Parameters<double>::Kept::value,
                     nets::read_parameters(reader, group, both_layers(classes_)));
}

void append_outputs(const SymptomNetwork::Outputs& of_window, const std::vector<float>& logits,
                    Outputs& all) {
  std::vector<float> scores(logits.size());
  softmax(std::ssize(logits), logits.data(), scores.data());
  all.hidden.insert(all.hidden.end(), of_window.hidden.data(),
                    of_window.hidden.data() + SymptomNetwork::hidden);
  all.logits.insert(all.logits.end(), logits.begin(), logits.end());
  all.scores.insert(all.scores.end(), scores.begin(), scores.end());
}

}  // namespace piae::diagnosis
