#pragma once

#include <string>
#include <vector>

#include "readings/measure.hpp"
#include "report/document.hpp"
#include "report/published.hpp"
#include "scoring/statistics.hpp"

namespace piae::readings {

/// One quantity of one reading over the seeds.
struct Row {
  std::string reading;
  std::string quantity;
  std::string ratio;
  scoring::Summary summary;
};

/// `by_seed` are what measure() gave for the seeds of one reading.
std::vector<Row> rows_of(const Reading& reading, const std::vector<std::vector<Measured>>& by_seed);

/// The accuracies that the paper publishes of its method, as those of a reading called "published".
/// Empty for a data set that the paper does not have.
std::vector<Row> published_rows(const run::Grid& grid, const report::Published& published);

/// readings.csv: dataset,reading,quantity,ratio,seeds,mean,std; `seeds` is how many there are.
std::string csv(const std::string& dataset, const std::vector<Row>& rows);

/// The same for people: accuracy, the quality of windows, losses and their weights, the twin's
/// states.
report::Document document(const Readings& readings, const std::vector<Row>& rows);

}  // namespace piae::readings
