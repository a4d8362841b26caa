#pragma once

#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "classification/verdict.hpp"

namespace piae::classification {

/// Writes classification.h5 (kind "classification"): what DatasetInfo writes; the root attributes
/// `classifier` and its digest; a row for each recording in /recordings/name, /label, /probability,
/// /share, /share_unknown and /unknown (0 or 1); a row for each window in /windows/recording
/// (index), /start_s, /label, /probabilities float32 [n, classes] and /strangeness.
void write(artefact::Writer& writer, const std::vector<Verdict>& verdicts,
           const diagnosis::KeptClassifier& classifier, const std::string& classifier_digest);

/// Throws artefact::Refusal for content that write() cannot have written.
void require_classification(const artefact::Reader& reader);

/// Verdict on one recording in classification.h5.
struct Named {
  std::string recording;
  std::string fault;  ///< name of the class, or "unknown"
};

/// Returns an entry for each recording. Throws as require_classification() does.
std::vector<Named> read_named(const artefact::Reader& reader);

}  // namespace piae::classification
