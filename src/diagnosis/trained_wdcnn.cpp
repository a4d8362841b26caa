#include "diagnosis/trained_wdcnn.hpp"

#include "base/range.hpp"
#include "diagnosis/wdcnn.hpp"
#include "diagnosis/wdcnn_evaluation.hpp"
#include "diagnosis/wdcnn_layers.hpp"

namespace piae::diagnosis {

namespace {

constexpr const char* input_length = "input_length";
constexpr Range possible_length{.low = WdcnnLayers::shortest_window, .high = 1e6};

}  // namespace

WdcnnOfWindows::WdcnnOfWindows(const artefact::Reader& reader, const signal::DatasetInfo& info,
                               Represent represent)
    : length_(static_cast<std::size_t>(reader.integer(learned, input_length, possible_length))),
      represent_(represent) {
  network_ = wdcnn_of(read_wdcnn_weights(reader, learned, static_cast<std::int64_t>(length_),
                                         static_cast<std::int64_t>(info.classes.size())));
}

WdcnnOutputs WdcnnOfWindows::outputs(const signal::WindowSet& windows, const std::string& what) {
  return ask_wdcnn(*network_, length_, represent_(windows, what));
}

void WdcnnOfWindows::write(artefact::Writer& writer) const {
  diagnosis::write(writer, learned, network_->weights());
  writer.attribute(learned, input_length, static_cast<std::int64_t>(length_));
}

}  // namespace piae::diagnosis
