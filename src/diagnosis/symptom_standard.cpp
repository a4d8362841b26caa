#include "diagnosis/symptom_standard.hpp"

#include <span>

namespace piae::diagnosis {

namespace {

constexpr double farthest = 4;            // limit of a symptom, in standard deviations
constexpr double least_deviation = 1e-6;  // if all training windows are the same

}  // namespace

SymptomStandard::SymptomStandard(const SymptomRows& training)
    : mean_(training.colwise().mean()),
      deviation_(((training.rowwise() - mean_).colwise().squaredNorm() /
                  static_cast<double>(training.rows()))
                     .cwiseSqrt()
                     .array() +
                 least_deviation) {}

SymptomStandard::SymptomStandard(const artefact::Reader& reader, const std::string& group) {
  const auto read = [&](const char* name) {
    const auto values =
        reader.numbers<double>(group + "/" + name, {symptoms::number_of_symptoms}).values;
    return Eigen::RowVectorXd(
        Eigen::Map<const Eigen::RowVectorXd>(values.data(), std::ssize(values)));
  };
  mean_ = read("mean");
  deviation_ = read("deviation");
  if (!(deviation_.minCoeff() > 0)) {
    reader.refuse(group + "/deviation", "has a value that is not above 0");
  }
}

SymptomRows SymptomStandard::scaled(const SymptomRows& rows) const {
  return ((rows.rowwise() - mean_).array().rowwise() / deviation_.array())
      .max(-farthest)
      .min(farthest);
}

void SymptomStandard::write(artefact::Writer& writer, const std::string& group) const {
  writer.numbers(group + "/mean", std::span<const double>(mean_.data(), mean_.size()),
                 {symptoms::number_of_symptoms});
  writer.numbers(group + "/deviation",
                 std::span<const double>(deviation_.data(), deviation_.size()),
                 {symptoms::number_of_symptoms});
}

}  // namespace piae::diagnosis
