#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "classification/record.hpp"
#include "report/document.hpp"
#include "run/grid.hpp"
#include "run/layout.hpp"

namespace piae::report {

/// A labelled record of a data set.
struct JudgedRecord {
  std::string name;
  std::string true_class;
  bool is_faulty = true;
  std::string grade = {};  ///< how clearly it shows its fault, if somebody graded it: "Y1"
};

/// Verdicts of a kept classifier, or of somebody else, on the records of a data set.
struct Judge {
  std::string name;  ///< "exclusion-rule", "piae-dt-zero by symptom-net"
  run::Combination combination = {};
  std::vector<std::int64_t> seeds = {};  ///< none for somebody else
  /// [seeds][records]; empty for somebody else.
  std::vector<std::vector<classification::Named>> verdicts = {};
  std::vector<std::vector<bool>> right = {};  ///< [seeds][records]; one row for somebody else

  /// Returns the number of these records on which the judge is right: its mean over the seeds.
  [[nodiscard]] double count_right(const std::vector<std::size_t>& records) const;
};

/// Verdicts of all judges on each record.
struct RecordVerdicts {
  std::string dataset;
  std::vector<JudgedRecord> records = {};
  std::vector<Judge> judges = {};  ///< somebody else first, then the classifiers of the grid
};

/// Reads classification.h5 of each cell. `others`, if not empty, is a CSV file with a line for each
/// faulty record: record,grade and for each other judge `right` or `wrong`. Throws
/// artefact::Refusal if a classification is missing, is one of another cell, or has other records
/// than the first; Error(bad_input) if `others` does not name each faulty record once.
RecordVerdicts record_verdicts(const run::Layout& layout, const run::Grid& grid,
                               const std::filesystem::path& others);

/// Returns a line for each record and seed of each judge:
/// dataset,judge,method,classifier,ratio,seed,record,class,faulty,grade,named,right,share,evidence.
/// `faulty` and `right` are 1 or 0. Other judges have only a name, `right` and what is known of the
/// record.
std::string verdicts_csv(const RecordVerdicts& verdicts);

/// Returns tables: the number of right verdicts by grade and by class, and each verdict.
Document verdicts_document(const RecordVerdicts& verdicts);

}  // namespace piae::report
