#include "signal/check.hpp"

#include "signal/amplitude.hpp"
#include "signal/split.hpp"
#include "signal/stride.hpp"

namespace piae::signal {

namespace {

void note(DatasetCheck& check, Exit exit) {
  if (check.exit != Exit::bad_input) check.exit = exit;
}

ClassCheck check_class(const Description& description, const DatasetCheck& check, Label label) {
  ClassCheck result{.label = label};
  std::vector<std::size_t> lengths;
  for (const RecordCheck& record : check.records) {
    if (record.source.label != label) continue;
    ++result.records;
    if (record.problem.empty()) lengths.push_back(record.samples);
  }
  if (lengths.size() < result.records) return result;  // the record has the problem
  const SplitOptions split;
  try {
    result.stride = largest_stride(description.info.class_of(label).name, lengths,
                                   {.window = split.window,
                                    .max_stride = split.max_stride,
                                    .windows = split.windows_per_class,
                                    .blocks = 0,
                                    .guard = 0});
  } catch (const Error& error) {
    result.problem = error.what();
  }
  return result;
}

}  // namespace

DatasetCheck check(const Description& description, const std::filesystem::path& data_dir,
                   const RecordsDone& done) {
  DatasetCheck check;
  RecordReader reader(description, data_dir);
  for (const RecordSource& source : description.records) {
    RecordCheck result{.source = source};
    try {
      const Record record = reader.read(source);
      result.samples = record.signal.size();
      result.rms = rms_of(record.signal);
    } catch (const Error& error) {
      result.problem = error.what();
      note(check, error.exit());
    }
    check.records.push_back(result);
    if (done) done(check.records.size());
  }
  for (const Label label : description.info.labels()) {
    check.classes.push_back(check_class(description, check, label));
    if (!check.classes.back().problem.empty()) note(check, Exit::bad_input);
  }
  return check;
}

}  // namespace piae::signal
