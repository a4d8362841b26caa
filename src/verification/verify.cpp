#include "verification/verify.hpp"

#include <map>
#include <set>

#include "scoring/diagnosis_record.hpp"
#include "scoring/quality_record.hpp"
#include "signal/recordings.hpp"
#include "signal/roles.hpp"
#include "signal/window_set.hpp"

namespace piae::verification {

namespace {

using artefact::Fault;
using artefact::Reader;

/// Roles of one split, by dataset, protocol and seed.
using Splits = std::map<std::string, std::vector<signal::RoleSet>>;

void check_windows(const Reader& reader, Splits& splits) {
  const std::string role = reader.text("/", "role");
  if (role == "E") {
    signal::require_classes(reader, role, signal::read_window_set(reader));
    return;
  }
  signal::RoleSet set = signal::read_role_set(reader);
  signal::require_classes(reader, role, set.windows);
  const std::string split =
      set.windows.info.name + " " + set.protocol + " " + std::to_string(set.seed);
  set.windows.samples.clear();  // the proof needs their places alone
  splits[split].push_back(std::move(set));
}

void require_known_kind(const Reader& reader) {
  static const std::set<std::string> known{"records", "windows",   "model",
                                           "score",   "diagnosis", "checkpoint"};
  if (known.contains(reader.kind())) return;
  throw artefact::Refusal(
      Exit::bad_input, Fault::wrong_kind,
      reader.path().string() + ": is of kind '" + reader.kind() + "', which no stage makes");
}

void check_content(const Reader& reader, Splits& splits) {
  require_known_kind(reader);
  reader.require_finite();
  if (reader.kind() == "records") (void)signal::read_recordings(reader);
  if (reader.kind() == "windows") check_windows(reader, splits);
  if (reader.kind() == "score") (void)scoring::read_quality(reader);
  if (reader.kind() == "diagnosis") (void)scoring::read_diagnosis(reader);
}

}  // namespace

std::vector<Finding> verify(const std::vector<std::filesystem::path>& files) {
  std::vector<Finding> findings;
  Splits splits;
  for (const std::filesystem::path& file : files) {
    try {
      check_content(Reader(file, ""), splits);
    } catch (const artefact::Refusal& refusal) {
      findings.push_back({refusal.fault(), refusal.what()});
    } catch (const std::exception& error) {
      findings.push_back({Fault::bad_content, file.string() + ": " + error.what()});
    }
  }
  for (const auto& [name, roles] : splits) {
    for (const std::string& line : signal::check_roles(roles)) {
      findings.push_back({Fault::roles_overlap, line});
    }
  }
  return findings;
}

int status_of(const std::vector<Finding>& findings) {
  int status = 0;
  for (const Finding& finding : findings) status |= static_cast<int>(finding.fault);
  return status;
}

}  // namespace piae::verification
