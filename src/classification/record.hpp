#pragma once

#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "classification/verdict.hpp"

namespace piae::classification {

/// Writes classification.h5 (kind "classification"): what DatasetInfo writes; the root attributes
/// `classifier` and its digest; a row for each recording in /recordings/name, /class (by its
/// description, or empty), /label, /probability, /share, /share_unknown, /unknown (0 or 1) and
/// /evidence (as in the table); a row for each window in /windows/recording (index), /start_s,
/// /label, /probabilities float32 [n, classes] and /strangeness.
void write(artefact::Writer& writer, const std::vector<Verdict>& verdicts,
           const diagnosis::KeptClassifier& classifier, const std::string& classifier_digest);

/// Throws artefact::Refusal for content that write() cannot have written.
void require_classification(const artefact::Reader& reader);

/// Verdict on one recording in classification.h5.
struct Named {
  std::string recording;
  std::string true_class;  ///< by its description; empty without one
  std::string fault;       ///< name of the class, or "unknown"
  std::string evidence;    ///< height of the fault's line, as evidence_of() writes it
  double share = 0;        ///< of the windows predicted as this class
};

/// Returns an entry for each recording. Throws as require_classification() does.
std::vector<Named> read_named(const artefact::Reader& reader);

}  // namespace piae::classification
