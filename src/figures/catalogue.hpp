#pragma once

#include <span>
#include <vector>

#include "figures/numbers.hpp"
#include "figures/picture.hpp"
#include "figures/source.hpp"

namespace piae::figures {

/// One figure, drawn by pipeline/figures/NAME.gp. It has either one picture, whose files are
/// NAME.csv, NAME.svg and NAME.pdf, or several: NAME@PART.csv and so on. A figure of accuracies has
/// NAME for the paper's classifier, and NAME@CLASSIFIER for each other that the run holds.
struct Figure {
  const char* name;     ///< what it shows, after the paper's number where the paper has it
  const char* paper;    ///< "Fig. 7"; empty for what the paper lacks
  const char* title;    ///< what it shows, in a few words
  const char* caption;  ///< how to read it, in sentences
  const char* from;     ///< the artefacts of a run that its numbers come from
  Numbers (*numbers)(Source&) = nullptr;  ///< of a figure with one picture
  /// Of a figure of accuracies, by one classifier.
  Numbers (*accuracies)(Source&, const report::ClassifierRows&) = nullptr;
  std::vector<Picture> (*pictures)(Source&) = nullptr;  ///< of one with several
};

/// All figures in the order in which they are shown. This is the one place that knows them: the
/// stage `figures` and the report look here.
std::span<const Figure> catalogue();

}  // namespace piae::figures
