#pragma once

#include <functional>
#include <optional>
#include <string>

#include "signal/recordings.hpp"
#include "trend/history.hpp"
#include "trend/trend.hpp"

namespace piae::trend {

/// A trend with all that is reported of it: lines, picture, baseline, summary.
class Session {
 public:
  /// `machine` is the name of the record or the stream.
  Session(Trend trend, std::string machine)
      : trend_(std::move(trend)), names_(trend_.meter().names()), machine_(std::move(machine)) {}

  /// Takes also the record to watch.
  Session(Trend trend, std::string machine, signal::Record record)
      : Session(std::move(trend), std::move(machine)) {
    record_ = std::move(record);
  }

  /// Watches the record, and writes a line of JSON for each point.
  void watch_record(const std::function<void(const std::string&)>& write);

  [[nodiscard]] Trend& trend() { return trend_; }
  /// Returns the callback that remembers points for the picture.
  [[nodiscard]] Trend::Report remember();

  [[nodiscard]] bool has_baseline() const { return trend_.healthy().has_value(); }
  /// Throws Error(bad_input) if the healthy hours are not over.
  void require_baseline() const;
  /// Need a baseline: the picture (SVG), and the content of the artefact of the kind "baseline".
  [[nodiscard]] std::string picture() const;
  void write_baseline(artefact::Writer& writer) const;
  /// Returns windows, hours and alarms in a line.
  [[nodiscard]] std::string summary() const;
  /// Returns the end of such a line, with time and cause of the first alarm; empty without one.
  [[nodiscard]] std::string first_alarm() const;

 private:
  Trend trend_;
  std::vector<std::string> names_;
  std::string machine_;
  signal::Record record_;
  History history_;
  std::optional<TrendPoint> first_alarm_;
};

}  // namespace piae::trend
