#pragma once

#include <span>
#include <vector>

#include "figures/numbers.hpp"
#include "figures/picture.hpp"
#include "figures/source.hpp"

namespace piae::figures {

/// A figure, drawn by pipeline/figures/NAME.gp. It has either one picture, with the files NAME.csv,
/// NAME.svg and NAME.pdf, or several: NAME@PART.csv and so on. A figure of accuracies is NAME for
/// the paper's classifier, and NAME@CLASSIFIER for each other classifier of the run.
struct Figure {
  const char* name;                       ///< content, after the paper's number if it has one
  const char* paper;                      ///< "Fig. 7"; empty if the paper lacks it
  const char* title;                      ///< short description
  const char* caption;                    ///< how to interpret it, in sentences
  const char* from;                       ///< artefacts of a run that give its numbers
  Numbers (*numbers)(Source&) = nullptr;  ///< for a figure with one picture
  /// Numbers of a figure of accuracies, for one classifier.
  Numbers (*accuracies)(Source&, const report::ClassifierRows&) = nullptr;
  std::vector<Picture> (*pictures)(Source&) = nullptr;  ///< for a figure with several pictures
};

/// Returns all figures in the order in which they are shown. Only this table knows all of them; the
/// stage `figures` and the report read it.
std::span<const Figure> catalogue();

}  // namespace piae::figures
