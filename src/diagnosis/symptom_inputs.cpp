#include "diagnosis/symptom_inputs.hpp"

#include <string>

#include "diagnosis/standardise.hpp"

namespace piae::diagnosis {

namespace {

using Eigen::Index;
using symptoms::Measures;

constexpr double farthest = 4;            // limit of a symptom, in standard deviations
constexpr double least_deviation = 1e-6;  // if all training windows are the same

signal::WindowSet fault_windows(const signal::WindowSet& training) {
  const Label healthy = training.info.healthy_label();
  signal::WindowSet faults;
  faults.info = training.info;
  faults.length = training.length;
  for (std::size_t i = 0; i < training.size(); ++i) {
    if (training.labels[i] != healthy) faults.append(training, i);
  }
  return faults;
}

auto row(const symptoms::Symptoms& symptoms) {
  return Eigen::Map<const Eigen::RowVectorXd>(symptoms.data(), std::ssize(symptoms));
}

/// Returns the symptoms of windows; `novelty` gives the novelty of window i against its baseline.
template <class NoveltyOf>
SymptomRows symptom_rows(const signal::WindowSet& windows, const std::vector<Measures>& measures,
                         symptoms::Baselines& baselines, const NoveltyOf& novelty) {
  SymptomRows rows(windows.size(), SymptomRows::ColsAtCompileTime);
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const symptoms::Baseline& baseline = baselines.at(windows.speed_rpm(i));
    rows.row(static_cast<Index>(i)) = row(symptoms_of(measures[i], baseline, novelty(baseline, i)));
  }
  return rows;
}

}  // namespace

SymptomScale::SymptomScale(const signal::WindowSet& normal, const signal::WindowSet& training)
    : SymptomScale(normal, training, symptoms::measure(normal, "--normal")) {}

SymptomScale::SymptomScale(const signal::WindowSet& normal, const signal::WindowSet& training,
                           const std::vector<Measures>& of_normal)
    : baselines_(normal, of_normal), labels_(normal.labels) {
  const signal::WindowSet faults = fault_windows(training);
  require_speeds(faults, "symptom-net");
  const SymptomRows healthy = symptom_rows(
      normal, of_normal, baselines_, [&](const symptoms::Baseline& /*baseline*/, std::size_t i) {
        return baselines_.left_out(i);
      });
  const SymptomRows faulty = raw_rows_of(faults, "training set");
  SymptomRows rows(healthy.rows() + faulty.rows(), SymptomRows::ColsAtCompileTime);
  rows << healthy, faulty;
  labels_.insert(labels_.end(), faults.labels.begin(), faults.labels.end());
  mean_ = rows.colwise().mean();
  deviation_ = ((rows.rowwise() - mean_).colwise().squaredNorm() / static_cast<double>(rows.rows()))
                   .cwiseSqrt()
                   .array() +
               least_deviation;
  training_ = scaled(rows);
}

SymptomScale::SymptomScale(const artefact::Reader& reader, const std::string& group, double rate_hz)
    : baselines_(symptoms::Baselines::read(reader, group, rate_hz)) {
  const auto read = [&](const char* name) {
    const auto values =
        reader.numbers<double>(group + "/" + name, {symptoms::number_of_symptoms}).values;
    return Row(Eigen::Map<const Row>(values.data(), std::ssize(values)));
  };
  mean_ = read("mean");
  deviation_ = read("deviation");
  if (!(deviation_.minCoeff() > 0)) {
    reader.refuse(group + "/deviation", "has a value that is not above 0");
  }
}

SymptomRows SymptomScale::raw_rows_of(const signal::WindowSet& windows, const std::string& what) {
  const std::vector<Measures> measures = symptoms::measure(windows, what);
  return symptom_rows(windows, measures, baselines_,
                      [&](const symptoms::Baseline& baseline, std::size_t i) {
                        return baseline.novelty().of(measures[i].shape_db);
                      });
}

SymptomRows SymptomScale::scaled(const SymptomRows& rows) const {
  return ((rows.rowwise() - mean_).array().rowwise() / deviation_.array())
      .max(-farthest)
      .min(farthest);
}

SymptomRows SymptomScale::rows_of(const signal::WindowSet& windows, const std::string& what) {
  return scaled(raw_rows_of(windows, what));
}

void SymptomScale::write(artefact::Writer& writer, const std::string& group) const {
  baselines_.write(writer, group);
  writer.numbers(group + "/mean", std::span<const double>(mean_.data(), mean_.size()),
                 {symptoms::number_of_symptoms});
  writer.numbers(group + "/deviation",
                 std::span<const double>(deviation_.data(), deviation_.size()),
                 {symptoms::number_of_symptoms});
}

}  // namespace piae::diagnosis
