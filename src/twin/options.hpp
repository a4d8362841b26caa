#pragma once

#include "cli/options.hpp"

namespace piae::twin {

/// Choice of alpha, beta and gamma of eq. 23 (paper 4.5.5, Fig. 19c).
enum class LossWeights {
  adaptive,              ///< learned by eq. 23 as printed
  adaptive_without_log,  ///< learned by eq. 23 without its logarithms, so that they only shrink
  stationary,            ///< minimum of eq. 23: 1 / (2 L), with the means of the epoch before
  fixed,                 ///< not learned: all three stay at 1
};
/// True if steps of Adam change the weights, as in eq. 25.
inline bool are_learned(LossWeights weights) {
  return weights == LossWeights::adaptive || weights == LossWeights::adaptive_without_log;
}
/// True if L_total has the logarithms of eq. 23.
inline bool have_logarithms(LossWeights weights) {
  return weights == LossWeights::adaptive || weights == LossWeights::stationary;
}

/// Division of the known windows into batches.
enum class Batches {
  mixed,         ///< windows of all classes, in random order
  of_one_class,  ///< paper 4.5.5: a batch of five "encompasses all five available samples per
                 ///< class"; a larger batch holds several whole classes
};

/// Windows whose histogram a class is drawn from.
enum class SpaceOf {
  all_classes,  ///< paper 4.4.2, Figs 9 and 10
  each_class,   ///< paper 3.4: "for each fault type"
};

/// Interpretation of delta in the contact of eq. 22. The start angle of a window is unknown.
enum class ContactInterpretation {
  standing,      ///< eq. 11 over the whole window: the clearance and the defect's depth
  defect_alone,  ///< eq. 22 literally: delta_n is the "column vector of defect size"
  passing,   ///< eqs 9 to 11: the depth is added while a ball is in the defect; starts at angle 0
  expected,  ///< like `passing`, averaged over all angles
};

/// Differentiation in eq. 21.
enum class Derivatives {
  central,   ///< central differences of second order
  spectral,  ///< derivative of the band-limited signal, from 33 samples
};

/// Function of eq. 16 that makes k~ and c~ positive; open in the paper.
enum class Positive { softplus, exponential };

/// Interpretation of |x|^2 in eqs 20 to 22, averaged over the windows of a batch. It determines the
/// relative weight of the MMD.
enum class Squares {
  mean,  ///< mean over the samples of a window
  sum,   ///< sum over the samples of a window, as eqs 20 and 21 print it
};

/// Interpretation of MMD in eqs 20 and 21.
enum class Mmd {
  squared,  ///< the squared discrepancy, as usual in losses
  root,     ///< the discrepancy itself, as eq. 27 prints it
};

/// Norm of eq. 22's residual to minimise; unlike eqs 20 and 21, eq. 22 does not print a norm.
/// Squares cannot find the damping: over a window of steady vibration the energy is in balance, and
/// an equation without the impacts' force has its least squares at c = 0.
enum class Residual {
  squared,   ///< its square
  absolute,  ///< its absolute value, which gives the few samples of an impact less weight
};

/// Divisor of the windows of a class before they enter the networks; open in the paper.
enum class Unit {
  rms,        ///< the RMS of the class's known windows
  peak,       ///< their largest absolute value
  recording,  ///< the unit of the recordings
};

/// Parameters of a training that the generation uses.
enum class Keep {
  best,   ///< after the epoch whose batches had the lowest mean of L_Rec + L_DDL + L_DT
  final,  ///< after the last epoch
};

/// Return the word on the command line and in a stored model, where `keep` also names the group of
/// the weights.
const char* to_string(Keep keep);
const char* to_string(Positive positive);

/// Settings of PIAE-DT. "Table 4" is a table of the paper; "open" means that the paper does not
/// specify the value.
struct TwinOptions {
  int epochs = 200;  ///< Table 4
  int batch = 5;     ///< Table 4
  Batches batches = Batches::of_one_class;
  double learning_rate = 5e-4;     ///< Table 4, eta_1 = eta_2 of eqs 24 and 25
  int decay_every = 50;            ///< epochs, Table 4 (StepLR step)
  double decay = 0.5;              ///< factor, Table 4 (StepLR gamma)
  double max_gradient_norm = 1.0;  ///< Table 4
  int depth = 3;                   ///< layers of each network (paper 4.5.5: 3 to 4)
  int width = 256;                 ///< units of a hidden dense layer; open in the paper
  int stage_epochs = 1;            ///< epochs in Stage 1, then in Stage 2; open in the paper
  int space_bins = 10;             ///< bins of the histogram, for k and for c; open in the paper
  Unit unit = Unit::rms;
  Positive positive = Positive::softplus;
  Squares squares = Squares::mean;
  Mmd mmd = Mmd::squared;
  Residual residual = Residual::squared;
  Derivatives derivatives = Derivatives::central;
  ContactInterpretation contact = ContactInterpretation::expected;
  SpaceOf space = SpaceOf::all_classes;
  LossWeights loss_weights = LossWeights::adaptive;
  double weight_learning_rate = 5e-4;  ///< for ln alpha, ln beta and ln gamma; also decays
  Keep keep = Keep::best;  ///< open: the paper trains both and does not specify which one generates
  double mass_kg = 1.0;    ///< M of eq. 22; open, working set of the project's notes
  double load_n = 1000.0;  ///< W of eq. 22; open, working set
  double clearance_um = 2.0;  ///< gamma of eq. 11; open, working set
};

void bind(const cli::Options& command, TwinOptions& options);

/// Binds only `space`, which piae-dt-phase does not have: it always draws class by class.
void bind_space(const cli::Options& command, TwinOptions& options);

}  // namespace piae::twin
