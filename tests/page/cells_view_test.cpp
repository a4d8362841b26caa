#include "page/cells_view.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <iterator>

namespace piae::page {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Diagnoses at two ratios. The accuracy of a seed is its last two digits.
std::vector<DatasetContents> with_cells(std::int64_t seeds) {
  DatasetContents contents{.name = "cwru"};
  for (const char* ratio : {"10to1", "2to1"}) {
    std::vector<run::Diagnosis> cells;
    for (std::int64_t seed = 0; seed < seeds; ++seed) {
      run::Diagnosis cell{.method = "vae", .ratio = ratio, .seed = seed};
      cell.accuracy = static_cast<double>(seed % 100) / 100;
      contents.diagnosis_digests.emplace_back(64, 'a');
      cells.push_back(cell);
    }
    std::ranges::copy(cells, std::back_inserter(contents.results.diagnoses));
    contents.rows.push_back(report::accuracy_row("cwru", cells));
  }
  return {contents};
}

TEST(CellsView, HasARowForEachCell) {
  const std::string view = cells_view(with_cells(3)).text();
  EXPECT_THAT(view, HasSubstr("cwru/seed2/vae/2to1/wdcnn/diagnosis.h5"));
  EXPECT_THAT(view, HasSubstr("Diagnoses: 6"));
}

TEST(CellsView, CombinesSeedsIfThereAreTooManyRows) {
  const std::string view = cells_view(with_cells(2000)).text();
  EXPECT_LT(view.size(), 10'000U);
  EXPECT_THAT(view, HasSubstr("The means above were made from 4000 cells."));
  EXPECT_THAT(view, HasSubstr("Diagnoses by method, classifier and ratio: 2"));
  EXPECT_THAT(view, HasSubstr(">99.00</td>"));
  EXPECT_THAT(view, HasSubstr("0 to 1999"));
  EXPECT_THAT(view, Not(HasSubstr("seed7/")));
}

}  // namespace
}  // namespace piae::page
