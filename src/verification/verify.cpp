#include "verification/verify.hpp"

#include <algorithm>
#include <exception>
#include <map>
#include <new>

#include "augment/stored_model.hpp"
#include "classification/record.hpp"
#include "diagnosis/any_bearing.hpp"
#include "diagnosis/catalogue.hpp"
#include "diagnosis/trust.hpp"
#include "scoring/diagnosis_record.hpp"
#include "scoring/quality_record.hpp"
#include "signal/recordings.hpp"
#include "signal/roles.hpp"
#include "signal/window_set.hpp"
#include "trend/healthy.hpp"

namespace piae::verification {

namespace {

using artefact::Reader;
using artefact::RefusalReason;

/// Windows of each split among the files, by dataset, protocol and seed.
using Splits = std::map<std::string, std::vector<signal::RoleSet>>;

void check_records(const Reader& reader, Splits& /*splits*/) {
  (void)signal::read_recordings(reader);
}

void check_windows(const Reader& reader, Splits& splits) {
  const signal::Role role = signal::read_role(reader);
  if (role == signal::Role::generated) {
    signal::require_belonging(reader, role, signal::read_window_set(reader));
    (void)signal::read_origin(reader);
    (void)signal::read_method(reader);
    return;
  }
  signal::RoleSet set = signal::read_role_set(reader);
  signal::require_belonging(reader, role, set.windows);
  const std::string split =
      set.windows.info.name + " " + to_string(set.protocol) + " " + std::to_string(set.seed);
  set.windows.samples.clear();  // check_roles() needs only the places of the windows
  splits[split].push_back(std::move(set));
}

void check_score(const Reader& reader, Splits& /*splits*/) { (void)scoring::read_quality(reader); }

void check_diagnosis(const Reader& reader, Splits& /*splits*/) {
  const std::string classifier = scoring::read_diagnosis(reader).classifier;
  if (diagnosis::find_classifier(classifier) == nullptr) {
    reader.refuse("/, attribute classifier",
                  "is '" + classifier + "'; it must be one of " + diagnosis::list_of_classifiers());
  }
}

void check_classifier(const Reader& reader, Splits& /*splits*/) {
  const diagnosis::KeptClassifier kept(reader);
  (void)diagnosis::read_trust(reader, kept.info());
}

void check_any_bearing(const Reader& reader, Splits& /*splits*/) {
  diagnosis::require_any_bearing(reader);
}

void check_classification(const Reader& reader, Splits& /*splits*/) {
  classification::require_classification(reader);
}

void check_baseline(const Reader& reader, Splits& /*splits*/) {
  (void)trend::read_baseline(reader);
}

void check_model(const Reader& reader, Splits& /*splits*/) { augment::require_usable(reader); }

/// Checks nothing: only the training that left a checkpoint knows its contents.
void check_nothing_more(const Reader& /*reader*/, Splits& /*splits*/) {}

/// A kind of artefact, and the check of its contents.
struct Kind {
  const char* name;
  void (*check)(const Reader& reader, Splits& splits);
};

/// Add a new kind of artefact here, with its check.
constexpr Kind kinds[] = {
    {"records", check_records},
    {"windows", check_windows},
    {"model", check_model},
    {"score", check_score},
    {"diagnosis", check_diagnosis},
    {"checkpoint", check_nothing_more},
    {"classifier", check_classifier},
    {"classification", check_classification},
    {"any-bearing", check_any_bearing},
    {"baseline", check_baseline},
};

void check_content(const Reader& reader, Splits& splits) {
  const auto* const kind = std::ranges::find(kinds, reader.kind(), &Kind::name);
  if (kind == std::end(kinds)) {
    throw artefact::Refusal(
        Exit::bad_input, RefusalReason::wrong_kind,
        reader.path().string() + ": is of kind '" + reader.kind() + "', which no stage makes");
  }
  try {
    reader.require_finite();
    kind->check(reader, splits);
  } catch (const artefact::Refusal&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;  // not the file's fault
  } catch (const std::exception& error) {
    throw artefact::Refusal(Exit::bad_input, RefusalReason::bad_content,
                            reader.path().string() + ": " + error.what());
  }
}

}  // namespace

std::vector<Finding> verify(const std::vector<std::filesystem::path>& files) {
  std::vector<Finding> findings;
  Splits splits;
  for (const std::filesystem::path& file : files) {
    try {
      check_content(Reader(file, ""), splits);
    } catch (const artefact::Refusal& refusal) {
      findings.push_back({refusal.reason(), refusal.what()});
    }
  }
  for (const auto& [name, roles] : splits) {
    for (const std::string& line : signal::check_roles(roles)) {
      findings.push_back({RefusalReason::roles_overlap, line});
    }
  }
  return findings;
}

int exit_code_of(const std::vector<Finding>& findings) {
  int code = 0;
  for (const Finding& finding : findings) code |= static_cast<int>(finding.reason);
  return code;
}

}  // namespace piae::verification
