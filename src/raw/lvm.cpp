#include "raw/lvm.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "base/numbers.hpp"
#include "base/one_line.hpp"
#include "raw/csv_fields.hpp"
#include "raw/csv_layout.hpp"
#include "raw/file.hpp"
#include "raw/text.hpp"

namespace piae::raw {

namespace {

namespace fs = std::filesystem;
using Fields = std::vector<std::string_view>;

constexpr std::string_view end_of_header = "***End_of_Header***";

class LvmReader {
 public:
  LvmReader(const fs::path& file, std::string_view text)
      : file_(file), text_(text), rest_(text), ends_with_line_end_(text.ends_with('\n')) {}

  Signal run(const std::string& wanted) {
    read_header();  // header of the file
    const bool has_times_for_each = entry("X_Columns", 1) == "Multi";
    step_ = has_times_for_each ? 2 : 1;
    sign_ = DecimalSign(entry("Decimal_Separator", 1));
    require_other_separators();
    has_one_heading_ = entry("Multi_Headings", 1) != "Yes";
    read_header();  // header of the segment
    names_ = fields(take());
    require_no_control_characters(file_, text_, text_.size() - rest_.size());
    if (names_.front() != "X_Value") refuse_line("does not name the channels");
    const auto channels = number_in<std::size_t>(entry("Channels", 1)).value_or(0);
    if (channels == 0 || column(channels - 1) >= names_.size()) {
      refuse_line(fmt::format("does not name the {} channels of its header", channels));
    }
    channel_ = channel(wanted, channels);
    Signal signal{.samples = samples(channels), .sample_rate_hz = rate_hz()};
    signal.may_be_cut = may_be_cut_ && decimals_.has_rare_end();
    return signal;
  }

 private:
  [[noreturn]] void refuse_line(const std::string& what) const {
    refuse_csv_line(file_, line_, what);
  }

  std::string_view take() {
    if (rest_.empty()) refuse_file(file_, "truncated or damaged: it ends within its header");
    ++line_;
    return take_line(rest_);
  }

  [[nodiscard]] Fields fields(std::string_view line) const {
    Fields found;
    for (std::optional rest = line; rest;) found.push_back(take_field(rest, separator_));
    return found;
  }

  static bool is_blank(const Fields& fields) {
    return std::ranges::all_of(fields, [](std::string_view field) { return field.empty(); });
  }

  /// Reads entries up to the end of a header.
  void read_header() {
    constexpr std::string_view key = "Separator";  // its entry is the key and the separator itself
    for (;;) {
      const std::string_view line = take();
      if (line.starts_with(end_of_header)) return;
      if (line.starts_with("***Start_Special***")) skip_special_block();
      if (line.starts_with(key) && line.size() > key.size()) separator_ = line[key.size()];
      Fields found = fields(line);
      entries_.try_emplace(std::string(found.front()), std::move(found));
    }
  }

  /// Refuses a decimal comma between fields that are separated by commas.
  void require_other_separators() const {
    if (separator_ != ',' || !entries_.contains("Decimal_Separator")) return;
    if (entry("Decimal_Separator", 1) == ".") return;
    refuse_line(
        "ends a header with commas as decimal signs and between the fields; write the file with "
        "tabs between the fields");
  }

  void skip_special_block() {
    while (!take().starts_with("***End_Special***")) continue;
  }

  /// Returns a field of an entry; empty if there is none.
  [[nodiscard]] std::string_view entry(const std::string& key, std::size_t column) const {
    const auto found = entries_.find(key);
    if (found == entries_.end() || column >= found->second.size()) return {};
    return found->second[column];
  }

  /// Returns the column of a channel's values and header entries.
  [[nodiscard]] std::size_t column(std::size_t channel) const { return 1 + step_ * channel; }

  [[nodiscard]] std::size_t channel(const std::string& wanted, std::size_t channels) const {
    std::vector<std::string> names;
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < channels; ++i) {
      names.emplace_back(names_[column(i)]);
      if (number_in<std::size_t>(wanted) == i + 1) return i;
      if (names.back() != wanted) continue;
      if (found) refuse_line("has several channels " + wanted + "; name one by its number");
      found = i;
    }
    if (found) return *found;
    if (std::ranges::any_of(names, has_control_characters)) {
      refuse_line(
          fmt::format("has no channel {}; the file is not in UTF-8, so name the channel by its "
                      "number, 1 to {}",
                      wanted, channels));
    }
    refuse_line("has no channel " + wanted + "; it has " + listed(names));
  }

  [[nodiscard]] std::optional<double> rate_hz() const {
    const auto dimension = entry("X_Dimension", column(channel_));
    if (!dimension.empty() && dimension != "Time") {
      refuse_file(file_, fmt::format("channel {} is not sampled over Time, but over {}",
                                     names_[column(channel_)], dimension));
    }
    const auto step = number_in_field(entry("Delta_X", column(channel_)));
    return step && *step > 0 ? std::optional(1 / *step) : std::nullopt;
  }

  /// Returns the number of a channel's values in each packet, from its header.
  [[nodiscard]] std::size_t count_in_packet(std::size_t channel) const {
    const std::string_view field = entry("Samples", column(channel));
    const auto count = number_in<std::size_t>(field);
    if (!count) {
      refuse_line(
          fmt::format("ends a header that declares {} samples of channel {}, not a whole number",
                      csv_field_in_quotes(field), channel + 1));
    }
    return *count;
  }

  /// Packets follow each other without a separator. A slower channel has values in the first rows
  /// of each packet and empty fields in the other rows.
  std::vector<double> samples(std::size_t channels) {
    std::vector<std::size_t> counts(channels);
    for (std::size_t i = 0; i < channels; ++i) counts[i] = count_in_packet(i);
    const std::size_t packet = std::ranges::max(counts);
    std::vector<double> samples;
    std::size_t rows = 0;
    for (; !rest_.empty(); ++rows) {
      const Fields row = fields(take());
      require_row(row);
      if (rows == packet && !has_one_heading_) {
        refuse_line(fmt::format("is one row more than the {} that its header declares", packet));
      }
      // A row that lost a field lacks a later one, so all channels are checked.
      for (std::size_t i = 0; i < channels; ++i) {
        const bool has_value = packet > 0 && rows % packet < counts[i];
        const auto value = value_in(row, i, has_value);
        if (value && i == channel_) samples.push_back(*value);
      }
      note_decimals(row);
    }
    if (rows < packet) {
      refuse_file(file_, fmt::format("truncated: it has {} rows, but its header declares {}", rows,
                                     packet));
    }
    const auto number = decimals_.short_end();
    if (number && may_be_cut_) refuse_cut_number(file_, number->line, number->text);
    return samples;
  }

  void note_decimals(const Fields& row) {
    const std::size_t place = column(channel_);
    const std::string_view field = place < row.size() ? row[place] : std::string_view{};
    if (!field.empty()) decimals_.add(line_, field);
    may_be_cut_ = place + 1 == row.size() && rest_.empty() && !ends_with_line_end_;
  }

  void require_row(const Fields& row) const {
    if (is_blank(row) || row.front().starts_with("***") || row.front() == "Channels") {
      refuse_line(
          "ends the first segment, and another one with its own header follows: time may be "
          "missing between them; save each segment as a file, or write only one header");
    }
    const bool ends_with_separator = row.size() == names_.size() + 1 && row.back().empty();
    if (row.size() > names_.size() && !ends_with_separator) {
      refuse_line(
          fmt::format("has {} fields, but only {} column names", row.size(), names_.size()));
    }
  }

  std::optional<double> value_in(const Fields& row, std::size_t channel, bool has_value) {
    const std::size_t place = column(channel);
    const std::string_view field = place < row.size() ? row[place] : std::string_view{};
    if (!has_value && field.empty()) return std::nullopt;
    const auto holds = [&] {
      return fmt::format("channel {} holds {}", names_[place], csv_field_in_quotes(field));
    };
    if (!has_value) refuse_line(holds() + ", where its header declares no value");
    const auto value = number_in_field(field);
    if (!value) refuse_line(holds() + ", not a number");
    if (separator_ != ',' && !sign_.fits(field)) {
      refuse_line(holds() + ", whose decimal sign is not the one in the header");
    }
    return value;
  }

  const fs::path& file_;
  std::string_view text_;
  std::string_view rest_;
  bool ends_with_line_end_;
  std::size_t line_ = 0;
  char separator_ = '\t';
  std::map<std::string, Fields> entries_;  ///< lines of both headers by their first field
  std::size_t step_ = 1;                   ///< columns from one channel to the next
  DecimalSign sign_;
  bool has_one_heading_ = true;
  Fields names_;  ///< column names
  std::size_t channel_ = 0;
  Decimals decimals_;
  bool may_be_cut_ = false;  ///< true if the channel's last number ends the text
};

}  // namespace

Signal read_lvm(const fs::path& file, const std::string& channel) {
  const std::string text = read_text(file);
  return LvmReader(file, text).run(channel);
}

}  // namespace piae::raw
