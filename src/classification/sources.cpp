#include "classification/sources.hpp"

#include "base/error.hpp"
#include "cli/checks.hpp"
#include "signal/ranges.hpp"

namespace piae::classification {

void bind(cli::Stage& stage, Sources& sources) {
  stage
      .input_file("--recording", sources.lone.file,
                  "one recording: text, MATLAB, HDF5, NumPy, TDMS, UFF, LabVIEW or sound")
      .required(false);
  stage.options().add("--variable", sources.lone.variable,
                      "variable, dataset, column (name or number) or channel of the recording");
  stage.options()
      .add("--sample-rate-hz", sources.lone.sample_rate_hz, "sample rate of the recording, Hz")
      .check(cli::within(signal::ranges::sample_rate_hz));
  stage.options()
      .add("--speed-rpm", sources.lone.shaft_speed_rpm, "shaft speed of the recording, rpm")
      .check(cli::within(signal::ranges::shaft_speed_rpm));
  stage
      .input_file("--description", sources.description,
                  "Data set description (TOML) of several recordings, instead of --recording")
      .required(false);
  stage.input_file("--data-dir", sources.data_dir, "Folder with the files that --description names")
      .required(false);
  stage
      .input_file("--records", sources.records_file,
                  "recordings that were checked and resampled, records.h5 of ingest or simulate, "
                  "instead of --recording")
      .required(false);
  stage.options().add("--record", sources.records,
                      "records of --description or --records to classify (default: all)");
  stage.options().add("--healthy", sources.healthy,
                      "healthy records of --description or --records, the reference for a network "
                      "for all machines");
  stage.options()
      .add("--speed-search-percent", sources.speed_search_percent,
           "take the shaft speed from the signal, within this range about the given speed; where "
           "the shaft hardly shows, and with 0, the given speed counts")
      .check(cli::within(signal::ranges::speed_search_percent));
}

void require_one(const Sources& sources) {
  const int given =
      !sources.lone.file.empty() + !sources.description.empty() + !sources.records_file.empty();
  if (given != 1) throw Error(Exit::usage, "give one of --recording, --description and --records");
  const bool complete = sources.lone.sample_rate_hz > 0 && sources.lone.shaft_speed_rpm > 0 &&
                        !sources.lone.variable.empty();
  if (!sources.lone.file.empty() && !complete) {
    throw Error(Exit::usage, "--recording needs --variable, --sample-rate-hz and --speed-rpm");
  }
}

void require_no_healthy_records(const Sources& sources) {
  if (sources.healthy.empty()) return;
  throw Error(Exit::usage,
              "--healthy: this classifier was trained on healthy windows of its machine; leave the "
              "option out, or give a network for all machines");
}

std::vector<Recording> read(cli::Stage& stage, const Sources& sources,
                            const diagnosis::Classifier& classifier,
                            const signal::DatasetInfo& trained) {
  const Fit fit{.classifier = classifier,
                .trained = trained,
                .speed_search_percent = sources.speed_search_percent};
  if (!sources.lone.file.empty()) {
    stage.note_input("recording", sources.lone.file);
    return {read_lone_file(sources.lone, fit)};
  }
  if (!sources.records_file.empty()) {
    return read_recorded(stage.open("records", sources.records_file, "records"), sources.records,
                         fit);
  }
  stage.note_input("description", sources.description);
  return read_described(sources.description, sources.data_dir, sources.records, fit,
                        [&](const signal::SourceFile& recording) {
                          stage.note_read(sources.data_dir / recording.name);
                          stage.note_input("recording", recording.name, recording.sha256);
                        });
}

}  // namespace piae::classification
