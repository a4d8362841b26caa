#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "artefact/reader.hpp"
#include "diagnosis/trained.hpp"
#include "signal/dataset_info.hpp"

namespace piae::diagnosis {

/// Windows as WDCNN sees them, in which `what` names the set in errors.
using Represent = LabelledWindows (*)(const signal::WindowSet& windows, const std::string& what);

/// A trained WDCNN with what it is shown of a window.
class WdcnnOfWindows final : public Trained {
 public:
  /// `length` is that of what it is shown.
  WdcnnOfWindows(std::unique_ptr<Wdcnn> network, std::size_t length, Represent represent)
      : network_(std::move(network)), length_(length), represent_(represent) {}
  WdcnnOfWindows(const artefact::Reader& reader, const signal::DatasetInfo& info,
                 Represent represent);

  WdcnnOutputs outputs(const signal::WindowSet& windows, const std::string& what) override;
  void write(artefact::Writer& writer) const override;

 private:
  std::unique_ptr<Wdcnn> network_;
  std::size_t length_;
  Represent represent_;
};

}  // namespace piae::diagnosis
