#include "diagnosis/symptom_inputs.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"

namespace piae::diagnosis {

namespace {

using Eigen::Index;
using symptoms::Measures;

constexpr double farthest = 4;            // of a symptom, in standard deviations
constexpr double least_deviation = 1e-6;  // where all training windows are the same

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

void require_speeds(const signal::WindowSet& faults) {
  if (std::ranges::none_of(faults.shaft_speed_rpm, [](double rpm) { return std::isnan(rpm); })) {
    return;
  }
  throw Error(Exit::bad_input,
              "--generated: the windows do not say at which speed of the shaft they are, which "
              "symptom-net must know in a data set of several; take a method that says so, such as "
              "strike-twin or piae-dt-zero, or another --classifier");
}

auto row(const symptoms::Symptoms& symptoms) {
  return Eigen::Map<const Eigen::RowVectorXd>(symptoms.data(), std::ssize(symptoms));
}

SymptomRows rows_of_healthy(const signal::WindowSet& normal, const std::vector<Measures>& measures,
                            symptoms::Baselines& baselines) {
  SymptomRows rows(normal.size(), SymptomRows::ColsAtCompileTime);
  for (std::size_t i = 0; i < normal.size(); ++i) {
    rows.row(static_cast<Index>(i)) =
        row(symptoms_of(measures[i], baselines.at(normal.speed_rpm(i)), baselines.left_out(i)));
  }
  return rows;
}

SymptomRows rows_of(const signal::WindowSet& windows, const std::string& what,
                    symptoms::Baselines& baselines) {
  const std::vector<Measures> measures = symptoms::measure(windows, what);
  SymptomRows rows(windows.size(), SymptomRows::ColsAtCompileTime);
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const symptoms::Baseline& baseline = baselines.at(windows.speed_rpm(i));
    rows.row(static_cast<Index>(i)) =
        row(symptoms_of(measures[i], baseline, baseline.novelty().of(measures[i].shape_db)));
  }
  return rows;
}

void standardise(SymptomInputs& inputs) {
  const Eigen::RowVectorXd mean = inputs.training.colwise().mean();
  const Eigen::RowVectorXd deviation = ((inputs.training.rowwise() - mean).colwise().squaredNorm() /
                                        static_cast<double>(inputs.training.rows()))
                                           .cwiseSqrt()
                                           .array() +
                                       least_deviation;
  for (SymptomRows* const rows : {&inputs.training, &inputs.test}) {
    *rows = ((rows->rowwise() - mean).array().rowwise() / deviation.array())
                .max(-farthest)
                .min(farthest);
  }
}

}  // namespace

SymptomInputs symptom_inputs(const signal::WindowSet& normal, const signal::WindowSet& training,
                             const signal::WindowSet& test) {
  const signal::WindowSet faults = fault_windows(training);
  require_speeds(faults);
  const std::vector<Measures> healthy = symptoms::measure(normal, "--normal");
  symptoms::Baselines baselines(normal, healthy);
  SymptomInputs inputs;
  const SymptomRows of_healthy = rows_of_healthy(normal, healthy, baselines);
  const SymptomRows of_faults = rows_of(faults, "training set", baselines);
  inputs.training.resize(of_healthy.rows() + of_faults.rows(), Eigen::NoChange);
  inputs.training << of_healthy, of_faults;
  inputs.labels = normal.labels;
  inputs.labels.insert(inputs.labels.end(), faults.labels.begin(), faults.labels.end());
  inputs.test = rows_of(test, "--test", baselines);
  standardise(inputs);
  return inputs;
}

}  // namespace piae::diagnosis
