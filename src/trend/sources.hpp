#pragma once

#include <filesystem>
#include <string>

#include "cli/stage.hpp"
#include "trend/options.hpp"
#include "trend/session.hpp"

namespace piae::trend {

/// Files of a trend: where its windows come from, and what is written.
struct Sources {
  double healthy_h = 0;                 ///< first hours of the signal; 0: not given
  std::filesystem::path baseline;       ///< kept baseline instead of the first hours
  std::filesystem::path records;        ///< records.h5 instead of a stream
  std::string record;                   ///< its record; empty: the only one
  std::filesystem::path description;    ///< with the bearing of a stream
  double window_s = 0;                  ///< 0: 1 s, or a whole snapshot
  std::filesystem::path keep_baseline;  ///< to write
  std::filesystem::path picture;        ///< to write
  TrendOptions options;
};

void bind(cli::Stage& stage, Sources& sources);

/// Properties of a stream, from the options of monitor.
struct StreamProperties {
  double sample_rate_hz = 0;  ///< 0: not given
  double speed_rpm = 0;       ///< 0: not given
  double every_s = 1;
};

/// Throws Error(usage) unless exactly one of classifier, healthy hours and baseline is given, and
/// for options that need another one.
void require_possible(const Sources& sources, bool has_classifier);

/// Opens the baseline, if one is given, and makes the session of a stream. Throws Error(usage) for
/// a missing rate, and Error(bad_input) if the baseline is for another rate.
Session session_of_stream(cli::Stage& stage, const Sources& sources, const StreamProperties& stream,
                          const std::string& name);

/// Opens the records and makes the session of one. Throws like session_of_stream() and window_of().
Session session_of_record(cli::Stage& stage, const Sources& sources);

/// Writes baseline and picture, as requested, if the healthy hours are over.
void save(cli::Stage& stage, const Sources& sources, const Session& session);

}  // namespace piae::trend
