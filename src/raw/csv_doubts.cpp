#include "raw/csv_doubts.hpp"

#include <spdlog/fmt/fmt.h>

#include <optional>

#include "raw/csv_fields.hpp"

namespace piae::raw {

namespace {

/// True for a damaged time. Times of day, thousands and dashes, for missing times, are not damaged.
bool is_damaged_time(std::string_view field) {
  return !number_in_field(field) && !is_date_or_time(field) &&
         remedy_for_thousands(field).empty() && field.find_first_not_of('-') != field.npos;
}

/// True if a number between the commas of a line has a decimal point.
bool holds_decimal_point(std::string_view line) {
  if (line.find('.') == line.npos) return false;
  for (std::optional rest = line; rest;) {
    const std::string_view field = take_field(rest, ',');
    if (field.find('.') != field.npos && number_in_field(field)) return true;
  }
  return false;
}

bool is_word(std::string_view field) { return holds_letters(field) && !number_in_field(field); }

}  // namespace

void CsvDoubts::Others::add(bool differs, std::size_t number, std::string_view text) {
  if (!differs) {
    ++usual;
  } else if (count++ == 0) {
    field = text;
    line = number;
  }
}

void CsvDoubts::look_at(std::size_t line, const CsvRow& row, std::string_view all) {
  if (row.requested_field.find(',') != std::string_view::npos) {
    look_at_comma(line, row.requested_field, all);
  }
  if (layout_.separator == ' ' && layout_.fields == 2 && !layout_.has_name) {
    const std::string_view low = layout_.column == 0 ? row.next : row.requested_field;
    const bool is_group = low.size() == 3 && is_digits(low);
    all_in_groups_ = all_in_groups_ && is_group && row.first.find('.') == low.npos;
    any_padded_ = any_padded_ || low.starts_with('0');
  }
  if (layout_.separator == ',') {
    has_points_ = has_points_ || holds_decimal_point(all);
    if (layout_.column > 0) before_.add(line, row.previous, row.requested_field);
    if (layout_.column + 1 < layout_.fields) behind_.add(line, row.requested_field, row.next);
  }
  decimals_.add(line, row.requested_field);
  may_be_cut_ = row.requested_field.end() == all.end() && !layout_.numbers.ends_with('\n');
  if (layout_.times.is_named && !row.time.empty()) {
    times_.add(is_damaged_time(row.time), line, row.time);
  }
  if (layout_.column != 0 && !row.first.empty()) words_.add(is_word(row.first), line, row.first);
}

void CsvDoubts::require_none() const {
  if (commas_ > 0 && commas_ == in_thousands_) {
    refuse_csv_line(file_, comma_line_,
                    "holds " + csv_field_in_quotes(comma_) +
                        ", where the comma may precede decimals or thousands; write decimal points "
                        "and no thousands separators");
  }
  require_no_decimal_commas();
  if (all_in_groups_ && any_padded_) {
    refuse_csv_line(file_, layout_.first_line,
                    "seems to have blanks between thousands; remove them");
  }
  if (const auto number = decimals_.short_end(); number && may_be_cut_) {
    refuse_cut_number(file_, number->line, number->text);
  }
  if (const auto number = decimals_.whole_number()) {
    refuse_csv_line(file_, number->line,
                    "column " + column_ + " holds " + csv_field_in_quotes(number->text) +
                        ", a whole number among numbers with decimals; it seems not to be a "
                        "sample: remove the line");
  }
  if (words_.are_few()) {
    refuse_csv_line(
        file_, words_.line,
        "begins with " + csv_field_in_quotes(words_.field) +
            ", where other lines have a number; if another table begins here, save it in "
            "a file of its own");
  }
  if (times_.are_few()) {
    refuse_csv_line(file_, times_.line,
                    "holds the time " + csv_field_in_quotes(times_.field) +
                        ", which is not a number, so lines may be missing; repair the line, or get "
                        "the file again");
  }
}

void CsvDoubts::require_no_decimal_commas() const {
  const std::string why =
      ": the numbers seem to have decimal commas, and the fields commas between them; write "
      "decimal points, or separate the fields by semicolons";
  const bool has_few_names = layout_.names < layout_.fields && layout_.fields <= 2 * layout_.names;
  for (const TornDecimals* pair : {&before_, &behind_}) {
    if (const auto evidence = pair->evidence(layout_.has_name, has_points_)) {
      refuse_csv_line(
          file_, evidence->line,
          fmt::format("holds {},{}{}{}", evidence->field, evidence->next, why,
                      layout_.has_name ? "" : ", or name each column if they are whole numbers"));
    }
    if (has_few_names && !has_points_ && pair->may_be_decimals()) {
      refuse_csv_line(
          file_, layout_.first_line,
          fmt::format("has {} fields below a header of {}{}", layout_.fields, layout_.names, why));
    }
  }
}

void CsvDoubts::look_at_comma(std::size_t line, std::string_view field, std::string_view all) {
  for (std::optional rest = all; rest;) {
    const std::string_view other = take_field(rest, layout_.separator);
    if (other.find('.') == other.npos || !number_in_field(other)) continue;
    refuse_csv_line(
        file_, line,
        "holds " + csv_field_in_quotes(field) + " and " + csv_field_in_quotes(other) +
            ", with two decimal signs; write decimal points and no thousands separators");
  }
  if (commas_++ == 0) {
    comma_ = field;
    comma_line_ = line;
  }
  if (field.starts_with('-') || field.starts_with('+')) field.remove_prefix(1);
  const std::size_t comma = field.find(',');
  const bool is_grouped = comma >= 1 && comma <= 3 && field.front() != '0' &&
                          field.size() == comma + 4 &&
                          field.find_first_not_of("0123456789,") == field.npos;
  if (is_grouped) ++in_thousands_;
}

}  // namespace piae::raw
