#pragma once

#include "cli/options.hpp"

namespace piae::twin {

/// How alpha, beta and gamma of eq. 23 are found (paper 4.5.5, Fig. 19c).
enum class LossWeights {
  adaptive,              ///< learned by eq. 23 as it stands
  adaptive_without_log,  ///< learned by eq. 23 without its logarithms, so that they only shrink
  stationary,            ///< where eq. 23 is least: 1 / (2 L), of the means of the epoch before
  fixed,                 ///< not learned: all three stay at 1
};
/// Whether steps of Adam move them, as eq. 25 has it.
inline bool are_learned(LossWeights weights) {
  return weights == LossWeights::adaptive || weights == LossWeights::adaptive_without_log;
}
/// Whether L_total has the logarithms of eq. 23.
inline bool have_logarithms(LossWeights weights) {
  return weights == LossWeights::adaptive || weights == LossWeights::stationary;
}

/// How the known windows are parted into batches.
enum class Batches {
  mixed,         ///< windows of all classes, in a random order
  of_one_class,  ///< paper 4.5.5: a batch of five "encompasses all five available samples per
                 ///< class"; a larger one holds as many whole classes as fit
};

/// Whose windows make the histogram that a class is drawn from.
enum class SpaceOf {
  all_classes,  ///< paper 4.4.2, Figs 9 and 10
  each_class,   ///< paper 3.4: "for each fault type"
};

/// What delta is in the contact of eq. 22. The angle at which a window starts is not known.
enum class ContactReading {
  standing,      ///< eq. 11 over the whole window: the clearance and the defect's depth
  defect_alone,  ///< eq. 22 by the letter, delta_n is the "column vector of defect size"
  passing,       ///< eqs 9 to 11: the depth is added while a ball is in the defect; from angle 0
  expected,      ///< the same, averaged over all angles
};

/// How eq. 21 differentiates.
enum class Derivatives {
  central,   ///< central differences of second order
  spectral,  ///< the derivative of the band-limited signal, by 33 samples of it
};

/// How eq. 16 makes k~ and c~ positive; open in the paper.
enum class Positive { softplus, exponential };

/// What |x|^2 is in eqs 20 to 22, averaged over the windows of a batch. It decides what MMD weighs.
enum class Squares {
  mean,  ///< over the samples of a window
  sum,   ///< over the samples of a window, as eqs 20 and 21 have it by the letter
};

/// What MMD is in eqs 20 and 21.
enum class Mmd {
  squared,  ///< the squared discrepancy, as losses usually have it
  root,     ///< the discrepancy itself, as eq. 27 has it by the letter
};

/// What is made small of what eq. 22 leaves over; it writes no norm, as eqs 20 and 21 do. Squares
/// cannot find the damping: over a window in which the vibration neither grows nor dies, energy is
/// in balance, and an equation without the strikes' force has its least squares at c = 0.
enum class Residual {
  squared,   ///< its square
  absolute,  ///< its absolute value, for which the few samples of a strike count less
};

/// What the windows of a class are divided by before the networks see them; open in the paper.
enum class Unit {
  rms,        ///< the RMS of the class's known windows
  peak,       ///< their largest absolute value
  recording,  ///< the unit of the recordings
};

/// Which of its parameters a training hands to the generation.
enum class Keep {
  best,   ///< those after the epoch whose batches had the lowest mean of L_Rec + L_DDL + L_DT
  final,  ///< those after the last epoch
};

/// The word for it on the command line and in a stored model, where it also names the group of the
/// weights.
const char* to_string(Keep keep);
const char* to_string(Positive positive);

/// The settings of PIAE-DT. "Table 4" is a table of the paper; "open" means that the paper does not
/// say.
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
  int space_bins = 10;             ///< of the histogram, for k and for c; open in the paper
  Unit unit = Unit::rms;
  Positive positive = Positive::softplus;
  Squares squares = Squares::mean;
  Mmd mmd = Mmd::squared;
  Residual residual = Residual::squared;
  Derivatives derivatives = Derivatives::central;
  ContactReading contact = ContactReading::expected;
  SpaceOf space = SpaceOf::all_classes;
  LossWeights loss_weights = LossWeights::adaptive;
  double weight_learning_rate = 5e-4;  ///< of ln alpha, ln beta and ln gamma; decays with the other
  Keep keep = Keep::best;     ///< open: the paper trains both and does not say which generates
  double mass_kg = 1.0;       ///< M of eq. 22; open, working set of the project's notes
  double load_n = 1000.0;     ///< W of eq. 22; open, working set
  double clearance_um = 2.0;  ///< gamma of eq. 11; open, working set
};

void bind(const cli::Options& command, TwinOptions& options);

/// `space` alone, which has no meaning for piae-dt-phase: it always draws class by class.
void bind_space(const cli::Options& command, TwinOptions& options);

}  // namespace piae::twin
