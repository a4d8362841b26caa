#include "report/record_verdicts.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <span>
#include <utility>

#include "augment/catalogue.hpp"
#include "base/error.hpp"
#include "diagnosis/catalogue.hpp"
#include "report/columns.hpp"
#include "report/labels.hpp"
#include "run/verdicts.hpp"
#include "text/csv.hpp"

namespace piae::report {

namespace {

using classification::Named;
using Indices = std::vector<std::size_t>;

/// Records that a table counts together.
struct RecordGroup {
  std::string heading;
  Indices records = {};
};

std::string name_of_judge(const run::Combination& cell) {
  return cell.method == augment::no_method ? diagnosis::marked_name(cell.classifier)
                                           : run::name_by(cell.method, cell.classifier);
}

/// Reads the verdicts of a cell, on the same records as the cells before.
std::vector<Named> read_verdicts(const run::Layout& layout, const run::Combination& cell,
                                 std::int64_t seed, RecordVerdicts& all) {
  run::Verdicts verdicts = run::read_verdicts(layout, cell, seed);
  std::vector<JudgedRecord> records;
  records.reserve(verdicts.records.size());
  for (const Named& each : verdicts.records) {
    records.push_back({.name = each.recording,
                       .true_class = each.true_class,
                       .is_faulty = verdicts.is_faulty(each)});
  }
  if (all.records.empty()) all.records = records;
  if (!std::ranges::equal(records, all.records, {}, &JudgedRecord::name, &JudgedRecord::name)) {
    throw Error(Exit::bad_input,
                layout.classification(cell.method, cell.ratio, seed, cell.classifier).string() +
                    ": names other records than that of the first classifier; run `make verdicts` "
                    "again");
  }
  return std::move(verdicts.records);
}

Judge judge_of(const run::Layout& layout, const run::Grid& grid, const run::Combination& cell,
               RecordVerdicts& all) {
  Judge judge{.name = name_of_judge(cell), .combination = cell, .seeds = grid.seeds};
  for (const std::int64_t seed : grid.seeds) {
    std::vector<Named> verdicts = read_verdicts(layout, cell, seed, all);
    std::vector<bool> right;
    right.reserve(verdicts.size());
    for (const Named& each : verdicts) right.push_back(each.fault == each.true_class);
    judge.verdicts.push_back(std::move(verdicts));
    judge.right.push_back(std::move(right));
  }
  return judge;
}

bool is_right(const text::CsvLine& line, std::size_t column) {
  const std::string& word = line.fields[column];
  if (word != "right" && word != "wrong") line.refuse("'" + word + "' must be right or wrong");
  return word == "right";
}

/// Adds the grades and the verdicts of others.
void add_others(const std::filesystem::path& file, RecordVerdicts& all) {
  const std::vector<text::CsvLine> lines = text::read_csv(file);
  const text::CsvLine& header = lines.front();
  if (header.fields.size() < 2 || header.fields[0] != "record" || header.fields[1] != "grade") {
    header.refuse("the header must begin with record,grade");
  }
  std::vector<Judge> others;
  for (std::size_t column = 2; column < header.fields.size(); ++column) {
    others.push_back(
        {.name = header.fields[column], .right = {std::vector<bool>(all.records.size(), false)}});
  }
  for (const text::CsvLine& line : std::span(lines).subspan(1)) {
    const auto record = std::ranges::find(all.records, line.fields[0], &JudgedRecord::name);
    if (record == all.records.end())
      line.refuse("names an unknown record, '" + line.fields[0] + "'");
    if (!record->grade.empty()) line.refuse("names record '" + line.fields[0] + "' again");
    if (line.fields[1].empty()) line.refuse("lacks a grade");
    record->grade = line.fields[1];
    const auto at = static_cast<std::size_t>(record - all.records.begin());
    for (std::size_t i = 0; i < others.size(); ++i) others[i].right[0][at] = is_right(line, i + 2);
  }
  for (const JudgedRecord& record : all.records) {
    if (!record.is_faulty || !record.grade.empty()) continue;
    throw Error(Exit::bad_input, file.string() + ": lacks a line for record '" + record.name + "'");
  }
  all.judges.insert(all.judges.begin(), others.begin(), others.end());
}

Indices records_with(const RecordVerdicts& verdicts,
                     const std::function<bool(const JudgedRecord&)>& wanted) {
  Indices indices;
  for (std::size_t i = 0; i < verdicts.records.size(); ++i) {
    if (wanted(verdicts.records[i])) indices.push_back(i);
  }
  return indices;
}

/// Returns a group for each word, in the order of `words`, without empty ones.
template <class Key>
std::vector<RecordGroup> groups_by(const RecordVerdicts& verdicts, Key key) {
  std::vector<RecordGroup> groups;
  for (std::size_t i = 0; i < verdicts.records.size(); ++i) {
    const std::string word = key(verdicts.records[i]);
    auto group = std::ranges::find(groups, word, &RecordGroup::heading);
    if (group == groups.end()) group = groups.insert(groups.end(), {.heading = word});
    group->records.push_back(i);
  }
  return groups;
}

/// Returns the groups of faulty records by the letter of their grades: "Y1, Y2".
std::vector<RecordGroup> groups_by_grade(const RecordVerdicts& verdicts) {
  std::map<char, std::vector<std::string>> grades;  // by their letter
  for (const JudgedRecord& record : verdicts.records) {
    if (record.grade.empty()) continue;
    std::vector<std::string>& those = grades[record.grade.front()];
    if (std::ranges::count(those, record.grade) == 0) those.push_back(record.grade);
  }
  std::vector<RecordGroup> groups;
  for (auto& of_letter : grades) {
    std::vector<std::string>& those = of_letter.second;
    std::ranges::sort(those);
    groups.push_back({.heading = fmt::format("{}", fmt::join(those, ", ")),
                      .records = records_with(verdicts, [&](const JudgedRecord& record) {
                        return std::ranges::count(those, record.grade) > 0;
                      })});
  }
  std::ranges::reverse(groups);  // Y, P, N: from clear to none
  return groups;
}

/// True for all records of our classifiers, and the faulty ones of others.
bool judges_record(const Judge& judge, const JudgedRecord& record) {
  return record.is_faulty || !judge.verdicts.empty();
}

text::Cell count_right_cell(const Judge& judge, const Indices& records) {
  const double count = judge.count_right(records);
  const bool is_whole = judge.right.size() == 1;
  return labelled_cell(count, fmt::format("{:.{}f}", count, is_whole ? 0 : 1));
}

/// Returns a row for each judge with the number of right verdicts in each group and in all.
text::Table count_table(const RecordVerdicts& verdicts, std::vector<RecordGroup> groups) {
  const Indices faulty = records_with(verdicts, &JudgedRecord::is_faulty);
  groups.push_back({.heading = "all faults", .records = faulty});
  text::Table table;
  table.column({.heading = "judge"});
  for (const RecordGroup& group : groups) {
    table.column({.heading = fmt::format("{} ({})", group.heading, group.records.size()),
                  .is_number = true});
  }
  for (const Judge& judge : verdicts.judges) {
    text::Cells cells{judge.name};
    for (const RecordGroup& group : groups) {
      const bool is_judged = std::ranges::any_of(group.records, [&](std::size_t record) {
        return judges_record(judge, verdicts.records[record]);
      });
      cells.push_back(is_judged ? count_right_cell(judge, group.records) : text::Cell(no_number));
    }
    table.row(std::move(cells));
  }
  return table;
}

/// Returns "right", or the wrong class. With several seeds that differ, returns "right 7/10".
std::string word_of(const Judge& judge, std::size_t record) {
  const auto right = std::ranges::count_if(
      judge.right, [&](const std::vector<bool>& of_seed) { return of_seed[record]; });
  const auto seeds = std::ssize(judge.right);
  if (right == seeds) return "right";
  if (right > 0) return fmt::format("right {}/{}", right, seeds);
  return judge.verdicts.empty() ? "wrong" : judge.verdicts.front()[record].fault;
}

text::Table record_table(const RecordVerdicts& verdicts) {
  std::vector<std::string> headings{"record", "class", "grade"};
  for (const Judge& judge : verdicts.judges) headings.push_back(judge.name);
  text::Table table(headings, 3);
  for (std::size_t i = 0; i < verdicts.records.size(); ++i) {
    const JudgedRecord& record = verdicts.records[i];
    text::Cells cells{record.name, record.true_class,
                      record.grade.empty() ? no_number : record.grade};
    for (const Judge& judge : verdicts.judges) {
      cells.emplace_back(judges_record(judge, record) ? word_of(judge, i) : no_number);
    }
    table.row(std::move(cells));
  }
  return table;
}

}  // namespace

double Judge::count_right(const std::vector<std::size_t>& records) const {
  double count = 0;
  for (const std::vector<bool>& of_seed : right) {
    for (const std::size_t record : records) count += of_seed[record] ? 1 : 0;
  }
  return count / static_cast<double>(right.size());
}

RecordVerdicts record_verdicts(const run::Layout& layout, const run::Grid& grid,
                               const std::filesystem::path& others) {
  RecordVerdicts verdicts{.dataset = grid.dataset};
  for (const run::Combination& cell : grid.combinations) {
    verdicts.judges.push_back(judge_of(layout, grid, cell, verdicts));
  }
  if (!others.empty()) add_others(others, verdicts);
  return verdicts;
}

std::string verdicts_csv(const RecordVerdicts& verdicts) {
  struct Line {
    const Judge* judge;
    std::size_t seed;
    std::size_t record;

    [[nodiscard]] const Named* verdict() const {
      return judge->verdicts.empty() ? nullptr : &judge->verdicts[seed][record];
    }
  };
  std::vector<Line> lines;
  for (const Judge& judge : verdicts.judges) {
    for (std::size_t seed = 0; seed < judge.right.size(); ++seed) {
      for (std::size_t record = 0; record < verdicts.records.size(); ++record) {
        if (judges_record(judge, verdicts.records[record])) {
          lines.push_back({&judge, seed, record});
        }
      }
    }
  }
  const auto record_of = [&](const Line& line) -> const JudgedRecord& {
    return verdicts.records[line.record];
  };
  const auto of_classifier = [](auto text_of) {
    return [text_of](const Line& line) {
      return text::Cell(line.verdict() == nullptr ? "" : text_of(line));
    };
  };
  Columns<Line> columns;
  columns.field("dataset", [&](const Line&) { return verdicts.dataset; })
      .field("judge",
             [](const Line& line) {
               const run::Combination& cell = line.judge->combination;
               const bool has_made_windows =
                   line.verdict() != nullptr && cell.method != augment::no_method;
               return has_made_windows ? cell.method + '/' + cell.classifier : line.judge->name;
             })
      .field("method",
             [](const Line& line) {
               return line.verdict() == nullptr ? line.judge->name : line.judge->combination.method;
             })
      .field("classifier",
             of_classifier([](const Line& line) { return line.judge->combination.classifier; }))
      .field("ratio", of_classifier([](const Line& line) { return line.judge->combination.ratio; }))
      .field("seed", of_classifier([](const Line& line) {
               return std::to_string(line.judge->seeds[line.seed]);
             }))
      .field("record", [=](const Line& line) { return record_of(line).name; })
      .field("class", [=](const Line& line) { return record_of(line).true_class; })
      .field("faulty",
             [=](const Line& line) { return std::string(record_of(line).is_faulty ? "1" : "0"); })
      .field("grade", [=](const Line& line) { return record_of(line).grade; })
      .field("named", of_classifier([](const Line& line) { return line.verdict()->fault; }))
      .field("right",
             [](const Line& line) {
               return std::string(line.judge->right[line.seed][line.record] ? "1" : "0");
             })
      .field("share",
             of_classifier([](const Line& line) { return four_decimals(line.verdict()->share); }))
      .field("evidence", of_classifier([](const Line& line) {
               // The script of the figure divides lines at commas.
               std::string evidence = line.verdict()->evidence;
               std::ranges::replace(evidence, ',', ';');
               return evidence;
             }));
  return columns.table(lines).csv();
}

Document verdicts_document(const RecordVerdicts& verdicts) {
  Document document{
      .key = verdicts.dataset + "-verdicts",
      .title = verdicts.dataset + ": one verdict on each record",
      .paragraphs = {
          "Each record is judged by the windows in it: the class with the greatest mean "
          "probability, or unknown if most windows resemble nothing that was trained. The healthy "
          "records taught the judges what is healthy, so verdicts on them say nothing about false "
          "alarms."}};
  const std::vector<RecordGroup> by_grade = groups_by_grade(verdicts);
  if (!by_grade.empty()) {
    document.sections.push_back(
        {.key = "by-grade",
         .title = "Right verdicts, by how clearly a record shows its fault",
         .note = "Number of records. Grades and the verdicts of judges that are not ours are "
                 "published ones.",
         .table = count_table(verdicts, by_grade)});
  }
  document.sections.push_back(
      {.key = "by-class",
       .title = "Right verdicts, by class",
       .note = "",
       .table = count_table(verdicts, groups_by(verdicts, [](const JudgedRecord& record) {
                              return record.true_class;
                            }))});
  document.sections.push_back(
      {.key = "records",
       .title = "Each record",
       .note = "A wrong verdict is shown by the class that was named. verdicts.csv has the "
               "evidence: the height of the fault's line in the envelope spectrum.",
       .table = record_table(verdicts)});
  return document;
}

}  // namespace piae::report
