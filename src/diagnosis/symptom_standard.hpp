#pragma once

#include <Eigen/Core>
#include <string>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "symptoms/symptoms.hpp"

namespace piae::diagnosis {

/// Symptoms as a network's input: a row for each window.
using SymptomRows = Eigen::Matrix<double, Eigen::Dynamic,
                                  static_cast<int>(symptoms::number_of_symptoms), Eigen::RowMajor>;

/// Mean and standard deviation of each symptom over training windows.
class SymptomStandard {
 public:
  explicit SymptomStandard(const SymptomRows& training);

  /// Returns the rows less the mean, divided by the standard deviation, clipped to -4 .. 4.
  [[nodiscard]] SymptomRows scaled(const SymptomRows& rows) const;

  /// Writes /mean and /deviation below a group.
  void write(artefact::Writer& writer, const std::string& group) const;
  /// Throws artefact::Refusal for a deviation that is not above 0.
  SymptomStandard(const artefact::Reader& reader, const std::string& group);

 private:
  Eigen::RowVectorXd mean_;
  Eigen::RowVectorXd deviation_;
};

}  // namespace piae::diagnosis
