#include "signal/recordings.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/sha256.hpp"
#include "signal/ranges.hpp"

namespace piae::signal {

namespace {

const std::string records_group = "/records";
const std::string pieces_group = "/pieces";
const std::string speeds_group = "/speeds";

void write_record(artefact::Writer& writer, const Record& record, const DatasetInfo& info) {
  if (!ranges::is_plain_name(record.name)) {
    throw std::logic_error("'" + record.name + "' cannot name a record");
  }
  const std::string path = records_group + "/" + record.name;
  writer.numbers(path, record.signal);
  writer.attribute(path, "label", std::int64_t{record.label});
  writer.attribute(path, "original_sample_rate_hz", record.original_sample_rate_hz);
  writer.attribute(path, "shaft_speed_rpm", record.shaft_speed_rpm);
  if (record.condition != every_condition) {
    const auto condition = static_cast<std::size_t>(record.condition);
    writer.attribute(path, "condition", info.conditions.at(condition).name);
  }
  if (record.defect_size_mm) writer.attribute(path, "defect_size_mm", *record.defect_size_mm);
  if (record.snapshot_interval_s) {
    writer.attribute(path, "snapshot_interval_s", *record.snapshot_interval_s);
  }
  writer.attribute(path, "source", record.source);
  writer.attribute(path, "source_sha256", record.source_sha256);
  if (record.parameters) {
    writer.attribute(path, "stiffness_n_per_m", record.parameters->stiffness_n_per_m);
    writer.attribute(path, "damping_ns_per_m", record.parameters->damping_ns_per_m);
  }
}

/// Reads the lengths of the pieces of a record; empty for a record in one piece.
std::vector<std::size_t> read_pieces(const artefact::Reader& reader, const std::string& name,
                                     std::size_t samples) {
  const std::string path = pieces_group + "/" + name;
  if (!reader.has(pieces_group) || !reader.has(path)) return {};
  std::vector<std::size_t> pieces;
  std::size_t left = samples;
  for (const std::int64_t length : reader.numbers<std::int64_t>(path, {0}).values) {
    if (length < 1 || static_cast<std::size_t>(length) > left) {
      reader.refuse(path, "holds lengths of pieces that do not add up to the record");
    }
    pieces.push_back(static_cast<std::size_t>(length));
    left -= pieces.back();
  }
  if (left != 0) reader.refuse(path, "holds lengths of pieces that do not add up to the record");
  return pieces;
}

/// Reads the speed of a record over its time; nothing if it was not recorded.
std::optional<SpeedCourse> read_speeds(const artefact::Reader& reader, const std::string& name,
                                       double duration_s) {
  const std::string path = speeds_group + "/" + name;
  if (!reader.has(speeds_group) || !reader.has(path)) return std::nullopt;
  SpeedCourse speeds{.block_s = reader.real(path, "block_s", ranges::speed_block_s),
                     .rpm = reader.numbers<double>(path, {0}).values};
  reader.require_all(path, speeds.rpm, ranges::shaft_speed_rpm);
  const double blocks = duration_s / speeds.block_s;
  if (speeds.rpm.empty() || std::abs(static_cast<double>(speeds.rpm.size()) - blocks) > 1) {
    reader.refuse(path, fmt::format("holds {} blocks of {:g} s, but the record lasts {:g} s",
                                    speeds.rpm.size(), speeds.block_s, duration_s));
  }
  return speeds;
}

std::int32_t read_condition(const artefact::Reader& reader, const std::string& path,
                            const DatasetInfo& info) {
  if (!reader.has_attribute(path, "condition")) return every_condition;
  const std::int32_t condition = info.condition_called(reader.text(path, "condition"));
  if (condition == every_condition) reader.refuse(path, "has a condition that is not listed");
  return condition;
}

Record read_record(const artefact::Reader& reader, const std::string& name,
                   const DatasetInfo& info) {
  const std::size_t classes = info.classes.size();
  const std::string path = records_group + "/" + name;
  Record record;
  record.name = name;
  if (!ranges::is_plain_name(name)) {
    reader.refuse(records_group,
                  "has a record with an invalid name: it " + ranges::plain_name_rule);
  }
  record.signal = reader.numbers<double>(path, {0}).values;
  if (record.signal.empty()) reader.refuse(path, "holds no sample");
  reader.require_all(path, record.signal, ranges::acceleration);
  record.pieces = read_pieces(reader, name, record.signal.size());
  record.speeds =
      read_speeds(reader, name, static_cast<double>(record.signal.size()) / info.sample_rate_hz);
  const std::int64_t label = reader.integer(path, "label");
  if (label < 0 || label >= static_cast<std::int64_t>(classes)) {
    reader.refuse(path, "has label " + std::to_string(label) + ", but there are " +
                            std::to_string(classes) + " classes");
  }
  record.label = static_cast<Label>(label);
  record.original_sample_rate_hz =
      reader.real(path, "original_sample_rate_hz", ranges::described_rate_hz);
  record.shaft_speed_rpm = reader.real(path, "shaft_speed_rpm", ranges::shaft_speed_rpm);
  record.condition = read_condition(reader, path, info);
  if (reader.has_attribute(path, "defect_size_mm")) {
    record.defect_size_mm = reader.real(path, "defect_size_mm", ranges::defect_size_mm);
  }
  if (reader.has_attribute(path, "snapshot_interval_s")) {
    record.snapshot_interval_s =
        reader.real(path, "snapshot_interval_s", ranges::snapshot_interval_s);
  }
  record.source = reader.text(path, "source");
  record.source_sha256 = reader.text(path, "source_sha256");
  if (reader.has_attribute(path, "stiffness_n_per_m")) {
    record.parameters =
        DynamicParameters{reader.real(path, "stiffness_n_per_m", ranges::stiffness_n_per_m),
                          reader.real(path, "damping_ns_per_m", ranges::damping_ns_per_m)};
  }
  return record;
}

void require_a_record_for_each_class(const artefact::Reader& reader, const Recordings& recordings) {
  std::vector<bool> seen(recordings.info.classes.size(), false);
  for (const Record& record : recordings.records) {
    seen[index_of(record.label)] = true;
  }
  for (const Label label : recordings.info.labels()) {
    if (!seen[index_of(label)]) {
      reader.refuse(records_group,
                    "has no record of class " + recordings.info.class_of(label).name);
    }
  }
}

}  // namespace

std::string sha256_of(const std::vector<SourceFile>& files) {
  if (files.size() == 1) return files.front().sha256;
  Sha256 sum;
  for (const SourceFile& file : files) sum.update(file.sha256 + "  " + file.name + '\n');
  return sum.finish_hex();
}

std::vector<std::size_t> Record::piece_lengths() const {
  return pieces.empty() ? std::vector{signal.size()} : pieces;
}

double Record::speed_rpm(std::size_t first, std::size_t count, double rate_hz) const {
  return speeds ? speeds->mean_rpm(first, count, rate_hz) : shaft_speed_rpm;
}

bool Recordings::have_parameters() const {
  return std::ranges::all_of(records, [](const Record& r) { return r.parameters.has_value(); });
}

bool Recordings::have_sizes() const {
  return std::ranges::any_of(records, [](const Record& r) { return r.defect_size_mm.has_value(); });
}

bool Recordings::have_speeds() const {
  constexpr double equal_within = 0.01;  // more than the speeds of simulated records scatter
  return std::ranges::any_of(records, [&](const Record& r) {
    return r.speeds || std::abs(r.shaft_speed_rpm / info.shaft_speed_rpm - 1) > equal_within;
  });
}

std::size_t Recordings::samples() const {
  std::size_t samples = 0;
  for (const Record& record : records) samples += record.signal.size();
  return samples;
}

RecordingsWriter::RecordingsWriter(artefact::Writer& writer, const DatasetInfo& info)
    : writer_(writer), info_(info) {
  write(writer_, info_);
  writer_.group(records_group);
}

void RecordingsWriter::add(const Record& record) {
  write_record(writer_, record, info_);
  samples_ += record.signal.size();
  if (record.pieces.size() > 1) pieces_.emplace_back(record.name, record.pieces);
  if (record.speeds) speeds_.emplace_back(record.name, *record.speeds);
}

void RecordingsWriter::finish() {
  if (!pieces_.empty()) writer_.group(pieces_group);
  for (const auto& [name, pieces] : pieces_) {
    const std::vector<std::int64_t> lengths(pieces.begin(), pieces.end());
    writer_.numbers(fmt::format("{}/{}", pieces_group, name), lengths);
  }
  if (!speeds_.empty()) writer_.group(speeds_group);
  for (const auto& [name, speeds] : speeds_) {
    const std::string path = fmt::format("{}/{}", speeds_group, name);
    writer_.numbers(path, speeds.rpm);
    writer_.attribute(path, "block_s", speeds.block_s);
  }
}

void write(artefact::Writer& writer, const Recordings& recordings) {
  RecordingsWriter all(writer, recordings.info);
  for (const Record& record : recordings.records) all.add(record);
  all.finish();
}

Recordings read_recordings(const artefact::Reader& reader) {
  Recordings recordings;
  recordings.info = read_dataset_info(reader);
  if (!reader.has(records_group)) reader.refuse(records_group, "is missing");
  for (const std::string& name : reader.list(records_group)) {
    recordings.records.push_back(read_record(reader, name, recordings.info));
  }
  require_a_record_for_each_class(reader, recordings);
  return recordings;
}

}  // namespace piae::signal
