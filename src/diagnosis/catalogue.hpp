#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "diagnosis/trained.hpp"
#include "diagnosis/trained_wdcnn.hpp"
#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// One entry of the catalogue of classifiers.
struct Classifier {
  const char* name;   ///< the name in CLASSIFIERS, in folders and in tables
  const char* what;   ///< what it is, in one phrase
  const char* input;  ///< what it is shown of a window
  /// Of a WDCNN; null for what is none, which has `learn` and `read` instead.
  Represent represent = nullptr;
  /// Learns from healthy windows alone: it needs no fault window, known or generated, and is run
  /// with `none` only.
  bool rule = false;
  /// How any other learns. `normal` is B, and `training` all that there is to learn from, B first.
  Learned (*learn)(const signal::WindowSet& normal, const signal::WindowSet& training,
                   const Stream& stream, const EpochDone& epoch_done) = nullptr;
  /// What it had written of itself when it had learned from windows of that data set, `length`
  /// samples each.
  std::unique_ptr<Trained> (*read)(const artefact::Reader& reader, const signal::DatasetInfo& info,
                                   std::size_t length) = nullptr;
  std::int64_t own_epochs = 0;  ///< of what is trained and is no WDCNN

  [[nodiscard]] bool trains() const { return represent != nullptr || own_epochs > 0; }
};

/// All classifiers in the order of the tables, the paper's first (scoring/diagnosis_record.hpp).
/// This is the one place that knows them: programs look here, and make asks a program.
std::span<const Classifier> classifiers();

/// The classifier of that name; null when there is none.
const Classifier* find_classifier(const std::string& name);

/// The same. Throws Error(usage), which lists the known names, for any other.
const Classifier& the_classifier(const std::string& name);

/// The names of the rules.
std::vector<std::string> rules();

/// Whose accuracy without any generated window stands beside all others: what needs neither a
/// generator nor a training.
inline constexpr const char* bar_classifier = "nearest";

/// The names of all with what they are, for people: "wdcnn (the paper's, on the waveform), ...".
std::string list_of_classifiers();

}  // namespace piae::diagnosis
