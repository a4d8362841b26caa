#include "signal/check.hpp"

#include "signal/amplitude.hpp"
#include "signal/split.hpp"
#include "signal/stride.hpp"

namespace piae::signal {

namespace {

void note(DatasetCheck& check, Exit exit) {
  if (check.exit != Exit::bad_input) check.exit = exit;
}

ClassCheck check_class(const Description& description, const DatasetCheck& check, int label) {
  ClassCheck result{label, 0, 0, ""};
  std::vector<std::size_t> lengths;
  for (const RecordCheck& record : check.records) {
    if (record.source->label != label) continue;
    ++result.records;
    if (record.problem.empty()) lengths.push_back(record.samples);
  }
  if (lengths.size() < result.records) return result;  // its record says why
  const SplitOptions split;
  try {
    result.stride =
        largest_stride(description.info.classes[static_cast<std::size_t>(label)].name, lengths,
                       {split.window, split.max_stride, split.windows_per_class, 0, 0});
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
    RecordCheck result{&source, 0, 0, ""};
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
  for (std::size_t label = 0; label < description.info.classes.size(); ++label) {
    check.classes.push_back(check_class(description, check, static_cast<int>(label)));
    if (!check.classes.back().problem.empty()) note(check, Exit::bad_input);
  }
  return check;
}

}  // namespace piae::signal
