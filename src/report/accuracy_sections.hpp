#pragma once

#include <vector>

#include "report/classifier_rows.hpp"
#include "report/document.hpp"

namespace piae::report {

/// The means of all methods side by side; then Tables 6 to 11 of the paper and the gains that it
/// draws in Figs 15 and 18, or the same for another dataset, with the published numbers beside
/// ours. Of these the first is without generated windows and has a run in each row. Accuracies and
/// gains of the compared methods, and those of the ablations, have a block for each method, in
/// which each ratio has a row. Tables without a row are left out. Every table of
/// accuracies has the bar, too, where it is known.
std::vector<Section> accuracy_sections(const ClassifierRows& of_classifier,
                                       const Published& published);

}  // namespace piae::report
