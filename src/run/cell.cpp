#include "run/cell.hpp"

#include <set>

#include "scoring/diagnosis_record.hpp"
#include "scoring/type_accuracy.hpp"

namespace piae::run {

namespace {

bool has_fault_types(const signal::DatasetInfo& info) {
  std::set<signal::Defect> fault_types;
  for (const signal::ClassInfo& each : info.classes) fault_types.insert(each.defect);
  return !info.conditions.empty() && fault_types.size() < info.classes.size();
}

std::optional<double> type_accuracy_of(const scoring::DiagnosisRecord& record) {
  if (!has_fault_types(record.info)) return std::nullopt;
  return scoring::type_accuracy(record.confusion(), record.info.classes);
}

std::optional<double> speed_ratio_of(const signal::DatasetInfo& info) {
  if (!signal::is_transfer(info.conditions)) return std::nullopt;
  return info.tested_speed_rpm() / info.known_speed_rpm();
}

/// Returns the names of the conditions that have this role.
std::vector<std::string> names_of(const signal::DatasetInfo& info, bool signal::Condition::*role) {
  std::vector<std::string> names;
  if (!signal::is_transfer(info.conditions)) return names;
  for (const signal::Condition& each : info.conditions) {
    if (each.*role) names.push_back(each.name);
  }
  return names;
}

/// Labels that differ from the test windows' show that the diagnosis belongs to another split.
std::vector<scoring::DecisionRates> decisions_of(const artefact::Reader& reader,
                                                 const scoring::DiagnosisRecord& record,
                                                 const TestedWindows* tested) {
  if (tested == nullptr) return {};
  if (record.labels != tested->labels) {
    reader.refuse("/labels",
                  "are not those of A.h5 of this seed, so other windows were tested; rerun the "
                  "diagnosis, or remove that A.h5");
  }
  return scoring::decision_rates(record.labels, record.scores, record.info.classes.size(),
                                 tested->places);
}

}  // namespace

Diagnosis read_diagnosis_cell(const artefact::Reader& reader, const std::string& dataset,
                              const Combination& combination, std::int64_t seed,
                              const TestedWindows* tested) {
  const scoring::DiagnosisRecord record = scoring::read_diagnosis(reader);
  require_same(reader, "the data set", record.info.name, dataset);
  require_same(reader, "the method", record.method, combination.method);
  require_same(reader, "the ratio", record.ratio, combination.ratio);
  require_same(reader, "the classifier", record.classifier, combination.classifier);
  require_same(reader, "the seed", std::to_string(record.seed), std::to_string(seed));
  return {.method = record.method,
          .ratio = record.ratio,
          .classifier = record.classifier,
          .seed = record.seed,
          .generated_per_class = record.generated_per_class,
          .true_ratio = record.true_ratio,
          .any_known = record.any_known,
          .protocol = record.protocol,
          .accuracy = record.accuracy(),
          .type_accuracy = type_accuracy_of(record),
          .speed_ratio = speed_ratio_of(record.info),
          .known_at = names_of(record.info, &signal::Condition::known),
          .tested_at = names_of(record.info, &signal::Condition::test),
          .confidence = scoring::confidence_of(record),
          .classes = record.info.classes,
          .confusion = record.confusion(),
          .decisions = decisions_of(reader, record, tested)};
}

scoring::QualityRecord read_score_cell(const artefact::Reader& reader, const std::string& dataset,
                                       const std::string& method, std::int64_t seed) {
  scoring::QualityRecord record = scoring::read_quality(reader);
  require_same(reader, "the data set", record.info.name, dataset);
  require_same(reader, "the method", record.method, method);
  require_same(reader, "the seed", std::to_string(record.seed), std::to_string(seed));
  return record;
}

void require_same(const artefact::Reader& reader, const std::string& what, const std::string& holds,
                  const std::string& needed) {
  if (holds != needed) reader.refuse("/", what + " is " + holds + ", here it must be " + needed);
}

}  // namespace piae::run
