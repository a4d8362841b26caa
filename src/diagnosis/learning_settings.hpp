#pragma once

#include <optional>

#include "artefact/reader.hpp"
#include "diagnosis/wdcnn_backend.hpp"
#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// Settings of a training that concern some classifiers only.
struct LearningSettings {
  WdcnnOptions wdcnn = {};
  MakeWdcnnBackend make_backend = {};  ///< for a WDCNN that does not adapt
  /// D, for a classifier that adapts; its labels are not used.
  const signal::WindowSet* unlabelled = nullptr;
  const artefact::Reader* network = nullptr;  ///< for a classifier that fits one
  /// Prewhitening of symptoms, from 0 to 1 (symptoms::measure()); empty for the classifier's own.
  std::optional<double> prewhitening = {};
};

}  // namespace piae::diagnosis
