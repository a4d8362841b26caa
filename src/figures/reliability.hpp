#pragma once

#include "figures/numbers.hpp"
#include "figures/source.hpp"
#include "report/accuracies.hpp"

namespace piae::figures {

/// Returns reliability diagrams, which compare accuracy and score: the test windows of all seeds in
/// ten bins by the score of the predicted class, for each method at its ratio with the most
/// generated windows. Columns:
/// method,ceiling,ratio,kind,score_from,score_to,windows,share,mean_score,accuracy,gap, all but
/// `windows` in percent. `share` is the part of all windows, `gap` the distance of accuracy and
/// mean score; an empty bin has none. After the rows of `kind` "bin" follows one of kind "all",
/// whose gap is the expected calibration error. Throws LeftOut if the classifier gives a class
/// without a score.
Numbers reliabilities(Source& source, const report::ClassifierRows& shown);

}  // namespace piae::figures
