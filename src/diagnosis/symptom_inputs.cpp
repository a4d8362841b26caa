#include "diagnosis/symptom_inputs.hpp"

#include <string>
#include <utility>

#include "diagnosis/standardise.hpp"

namespace piae::diagnosis {

namespace {

using Eigen::Index;
using symptoms::Measures;

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

SymptomScale::SymptomScale(const signal::WindowSet& normal, const signal::WindowSet& training,
                           double prewhitening)
    : SymptomScale(normal, training, prewhitening,
                   symptoms::measure(normal, "--normal", prewhitening)) {}

SymptomScale::SymptomScale(const signal::WindowSet& normal, const signal::WindowSet& training,
                           double prewhitening, const std::vector<Measures>& of_normal)
    : baselines_(normal, of_normal, prewhitening),
      labels_(normal.labels),
      training_(training_rows(normal, training, of_normal)),
      standard_(training_) {
  training_ = standard_.scaled(training_);
}

SymptomScale::SymptomScale(const signal::WindowSet& normal, SymptomStandard standard,
                           double prewhitening)
    : baselines_(normal, symptoms::measure(normal, "healthy windows", prewhitening), prewhitening),
      standard_(std::move(standard)) {}

SymptomScale::SymptomScale(const artefact::Reader& reader, const std::string& group, double rate_hz)
    : baselines_(symptoms::Baselines::read(reader, group, rate_hz)), standard_(reader, group) {}

SymptomRows SymptomScale::training_rows(const signal::WindowSet& normal,
                                        const signal::WindowSet& training,
                                        const std::vector<Measures>& of_normal) {
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
  return rows;
}

SymptomRows SymptomScale::raw_rows_of(const signal::WindowSet& windows, const std::string& what) {
  const std::vector<Measures> measures =
      symptoms::measure(windows, what, baselines_.prewhitening());
  return symptom_rows(windows, measures, baselines_,
                      [&](const symptoms::Baseline& baseline, std::size_t i) {
                        return baseline.novelty().of(measures[i].shape_db);
                      });
}

SymptomRows SymptomScale::rows_of(const signal::WindowSet& windows, const std::string& what) {
  return standard_.scaled(raw_rows_of(windows, what));
}

void SymptomScale::write(artefact::Writer& writer, const std::string& group) const {
  baselines_.write(writer, group);
  standard_.write(writer, group);
}

}  // namespace piae::diagnosis
