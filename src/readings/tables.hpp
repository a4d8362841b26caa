#pragma once

#include <string>
#include <vector>

#include "readings/measure.hpp"
#include "report/document.hpp"
#include "report/paper.hpp"
#include "scoring/statistics.hpp"

namespace piae::readings {

/// One quantity of one interpretation over the seeds.
struct Row {
  std::string reading;
  std::string quantity;
  std::string ratio;
  scoring::Summary summary;
};

/// `by_seed` holds the results of measure() for the seeds of one interpretation.
std::vector<Row> rows_of(const Reading& reading, const std::vector<std::vector<Measured>>& by_seed);

/// Returns the paper's accuracies of its method, as an interpretation named "published". Empty for
/// a data set that the paper does not use.
std::vector<Row> published_rows(const run::Grid& grid, const report::Published& published);

/// Returns readings.csv: dataset,reading,quantity,ratio,seeds,mean,std. `seeds` is their number.
std::string csv(const std::string& dataset, const std::vector<Row>& rows);

/// Returns the tables for people: accuracy, quality of windows, losses and their weights, the
/// twin's states.
report::Document document(const Readings& readings, const std::vector<Row>& rows);

}  // namespace piae::readings
