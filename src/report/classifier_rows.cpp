#include "report/classifier_rows.hpp"

#include <algorithm>
#include <iterator>

#include "augment/catalogue.hpp"
#include "diagnosis/catalogue.hpp"

namespace piae::report {

namespace {

bool is_bar(const AccuracyRow& row) {
  return row.method == augment::no_method && row.classifier == diagnosis::bar_classifier;
}

}  // namespace

std::vector<ClassifierRows> by_classifier(const std::vector<AccuracyRow>& rows) {
  const auto bar = std::ranges::find_if(rows, is_bar);
  std::vector<ClassifierRows> blocks;
  for (const diagnosis::Classifier& classifier : diagnosis::classifiers()) {
    ClassifierRows block{.classifier = classifier.name, .rows = rows_by(rows, classifier.name)};
    const bool is_of_bar = std::ranges::any_of(block.rows, is_bar);
    const bool stands_beside_others = is_of_bar && block.rows.size() == 1 && !blocks.empty();
    if (block.rows.empty() || stands_beside_others) continue;
    if (bar != rows.end() && !is_of_bar) block.bar = *bar;
    blocks.push_back(std::move(block));
  }
  return blocks;
}

std::vector<AccuracyRow> rows_by(const std::vector<AccuracyRow>& rows,
                                 const std::string& classifier) {
  std::vector<AccuracyRow> own;
  std::ranges::copy_if(rows, std::back_inserter(own),
                       [&](const AccuracyRow& row) { return row.classifier == classifier; });
  return own;
}

std::string bar_label(const AccuracyRow& bar) { return run::name_by(bar.method, bar.classifier); }

}  // namespace piae::report
