#include "raw/tdms_types.hpp"

#include <algorithm>
#include <array>

#include "raw/bytes.hpp"

namespace piae::raw {

namespace {

constexpr std::array tdms_types{
    TdmsType{0x00, 0, "void", nullptr},
    TdmsType{0x01, 1, "int8", double_at<std::int8_t>},
    TdmsType{0x02, 2, "int16", double_at<std::int16_t>},
    TdmsType{0x03, 4, "int32", double_at<std::int32_t>},
    TdmsType{0x04, 8, "int64", double_at<std::int64_t>},
    TdmsType{0x05, 1, "uint8", double_at<std::uint8_t>},
    TdmsType{0x06, 2, "uint16", double_at<std::uint16_t>},
    TdmsType{0x07, 4, "uint32", double_at<std::uint32_t>},
    TdmsType{0x08, 8, "uint64", double_at<std::uint64_t>},
    TdmsType{0x09, 4, "single", double_at<float>},
    TdmsType{0x0A, 8, "double", double_at<double>},
    TdmsType{0x0B, unstated_size, "extended float", nullptr},
    TdmsType{0x19, 4, "single with a unit", double_at<float>},
    TdmsType{0x1A, 8, "double with a unit", double_at<double>},
    TdmsType{0x1B, unstated_size, "extended float with a unit", nullptr},
    TdmsType{tdms_text, 0, "text", nullptr},
    TdmsType{0x21, 1, "boolean", nullptr},
    TdmsType{0x44, 16, "time stamp", nullptr},
    TdmsType{0x4F, unstated_size, "fixed point", nullptr},
    TdmsType{0x08000C, 8, "complex single", nullptr},
    TdmsType{0x10000D, 16, "complex double", nullptr},
    TdmsType{0xFFFFFFFF, unstated_size, "NI-DAQmx raw data", nullptr},
};

}  // namespace

const TdmsType* tdms_type(std::uint32_t id) {
  const auto* const found = std::ranges::find(tdms_types, id, &TdmsType::id);
  return found == tdms_types.end() ? nullptr : found;
}

}  // namespace piae::raw
