#include "raw/csv_doubts.hpp"

#include <optional>

#include "raw/csv_fields.hpp"

namespace piae::raw {

namespace {

bool is_word(std::string_view field) {
  return holds_letters(field.substr(0, 1)) && !number_in_field(field, ';');
}

}  // namespace

void CsvDoubts::look_at(std::size_t line, const CsvRow& row, std::string_view all) {
  if (layout_.separator != ',' && row.requested_field.find(',') != std::string_view::npos) {
    look_at_comma(line, row.requested_field, all);
  }
  if (layout_.separator == ' ' && layout_.fields == 2 && !layout_.has_name) {
    const std::string_view low = row.partner;
    const bool is_group = low.size() == 3 && low.find_first_not_of("0123456789") == low.npos;
    all_in_groups_ = all_in_groups_ && is_group && row.requested_field.find('.') == low.npos;
    any_padded_ = any_padded_ || low.starts_with('0');
  }
  if (layout_.column == 0) return;
  if (!is_word(row.first)) {
    ++numbered_;
  } else if (worded_++ == 0) {
    word_ = row.first;
    word_line_ = line;
  }
}

void CsvDoubts::require_none() const {
  if (commas_ > 0 && commas_ == in_thousands_) {
    refuse_csv_line(file_, comma_line_,
                    "holds " + csv_field_in_quotes(comma_) +
                        ", where the comma may precede decimals or thousands; write decimal points "
                        "and no thousands separators");
  }
  if (all_in_groups_ && any_padded_) {
    refuse_csv_line(file_, layout_.first_line,
                    "seems to have blanks between thousands; remove them");
  }
  if (worded_ == 0 || worded_ > numbered_) return;
  refuse_csv_line(file_, word_line_,
                  "begins with " + csv_field_in_quotes(word_) +
                      ", where other lines have a number; if another table begins here, save it in "
                      "a file of its own");
}

void CsvDoubts::look_at_comma(std::size_t line, std::string_view field, std::string_view all) {
  for (std::optional rest = all; rest;) {
    const std::string_view other = take_field(rest, layout_.separator);
    if (other.find('.') == other.npos || !number_in_field(other, layout_.separator)) continue;
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
