#include "report/verification.hpp"

#include <map>

#include "scoring/diagnosis_record.hpp"
#include "scoring/quality_record.hpp"
#include "signal/recordings.hpp"
#include "signal/roles.hpp"
#include "signal/window_set.hpp"

namespace piae::report {

namespace {

using artefact::Fault;
using artefact::Reader;

/// Roles of one split, by dataset, protocol and seed.
using Splits = std::map<std::string, std::vector<signal::RoleSet>>;

/// A must hold every class, B the healthy one, C, D and E every class with a defect.
void require_classes(const Reader& reader, const std::string& role,
                     const signal::WindowSet& windows) {
  for (std::size_t label = 0; label < windows.info.classes.size(); ++label) {
    const signal::ClassInfo& c = windows.info.classes[label];
    const bool healthy = c.defect == signal::Defect::none;
    const bool wanted = role == "A" || healthy == (role == "B");
    const bool present = windows.count_of(static_cast<int>(label)) > 0;
    if (wanted && !present) reader.refuse("/labels", "has no window of class " + c.name);
    if (!wanted && present) {
      reader.refuse("/labels",
                    "has windows of class " + c.name + ", which role " + role + " must not have");
    }
  }
}

void check_windows(const Reader& reader, Splits& splits) {
  const std::string role = reader.text("/", "role");
  if (role == "E") {
    require_classes(reader, role, signal::read_window_set(reader));
    return;
  }
  signal::RoleSet set = signal::read_role_set(reader);
  require_classes(reader, role, set.windows);
  const std::string split =
      set.windows.info.name + " " + set.protocol + " " + std::to_string(set.seed);
  set.windows.samples.clear();  // the proof needs their places alone
  splits[split].push_back(std::move(set));
}

void check_content(const Reader& reader, Splits& splits) {
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

}  // namespace piae::report
