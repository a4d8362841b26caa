#include "twin/options.hpp"

namespace piae::twin {

const char* to_string(Keep keep) { return keep == Keep::best ? "best" : "final"; }

const char* to_string(Positive positive) {
  return positive == Positive::softplus ? "softplus" : "exponential";
}

void bind(const cli::Options& command, TwinOptions& o) {
  command.add("--epochs", o.epochs, "passes over the known windows").check(cli::positive_number());
  command.add("--batch", o.batch, "windows in a batch").check(cli::positive_number());
  command.choose("--batches", o.batches,
                 {{"mixed", Batches::mixed}, {"class", Batches::of_one_class}},
                 "windows of a batch: from all classes (mixed), or from one class (paper 4.5.5)");
  command.add("--learning-rate", o.learning_rate, "learning rate of Adam at the start")
      .check(cli::positive_number());
  command.add("--decay-every", o.decay_every, "epochs between decays of the learning rate")
      .check(cli::positive_number());
  command.add("--decay", o.decay, "factor on the learning rate at each decay").check(cli::share());
  command.add("--max-gradient-norm", o.max_gradient_norm, "gradients are clipped to this norm")
      .check(cli::positive_number());
  command.add("--depth", o.depth, "layers of encoder, decoder and physics module")
      .check(cli::whole_number(1, 32));
  command.add("--width", o.width, "units of a hidden dense layer").check(cli::positive_number());
  command
      .add("--stage-epochs", o.stage_epochs, "epochs in Stage 1 (eq. 24), then in Stage 2 (eq. 25)")
      .check(cli::positive_number());
  command.choose(
      "--loss-weights", o.loss_weights,
      {{"adaptive", LossWeights::adaptive},
       {"adaptive-without-log", LossWeights::adaptive_without_log},
       {"stationary", LossWeights::stationary},
       {"fixed", LossWeights::fixed}},
      "alpha, beta, gamma of eq. 23: adaptive, adaptive-without-log (without the term that keeps "
      "them above zero), stationary (1 / (2 L) of the previous epoch), or fixed (at 1)");
  command
      .add("--weight-learning-rate", o.weight_learning_rate,
           "learning rate of Adam for ln alpha, ln beta, ln gamma at the start (paper, eq. 25)")
      .check(cli::positive_number());
  command.choose(
      "--unit", o.unit, {{"rms", Unit::rms}, {"peak", Unit::peak}, {"recording", Unit::recording}},
      "divisor of the windows of a class: its RMS, its peak, or 1 (recording); open in the "
      "paper");
  command.choose("--positive", o.positive,
                 {{to_string(Positive::softplus), Positive::softplus},
                  {to_string(Positive::exponential), Positive::exponential}},
                 "function that makes k and c positive in eq. 16; open in the paper");
  command.choose("--squares", o.squares, {{"mean", Squares::mean}, {"sum", Squares::sum}},
                 "squared norms of eqs 20 to 22: mean or sum over the samples of a window");
  command.choose("--mmd", o.mmd, {{"squared", Mmd::squared}, {"root", Mmd::root}},
                 "MMD of eqs 20 and 21: the squared discrepancy, or its root (eq. 27)");
  command.choose("--residual", o.residual,
                 {{"squared", Residual::squared}, {"absolute", Residual::absolute}},
                 "norm of the residual of eq. 22: squared or absolute; open in the paper");
  command.choose(
      "--derivatives", o.derivatives,
      {{"central", Derivatives::central}, {"spectral", Derivatives::spectral}},
      "derivatives of eq. 21: central differences, or spectral (of the band-limited signal)");
  command.choose(
      "--contact", o.contact,
      {{"standing", ContactInterpretation::standing},
       {"defect-alone", ContactInterpretation::defect_alone},
       {"passing", ContactInterpretation::passing},
       {"expected", ContactInterpretation::expected}},
      "delta of eq. 22: clearance and depth always (standing; eq. 11), the depth alone (eq. 22), "
      "clearance and the depth while a ball passes (eq. 9), or its expected value over all angles");
  command.add("--space-bins", o.space_bins, "bins of the digital twin space along k and along c")
      .check(cli::whole_number(1, 1000));
  command.choose("--keep", o.keep,
                 {{to_string(Keep::best), Keep::best}, {to_string(Keep::final), Keep::final}},
                 "model that generates: best (lowest training loss) or final (paper 4.3, Table 4)");
  command.add("--mass-kg", o.mass_kg, "mass M of eq. 22, kg").check(cli::positive_number());
  command.add("--load-n", o.load_n, "load W of eq. 22, N").check(cli::positive_number());
  command.add("--clearance-um", o.clearance_um, "radial clearance of eq. 11, micrometres")
      .check(cli::non_negative_number());
}

void bind_space(const cli::Options& command, TwinOptions& o) {
  command.choose(
      "--space", o.space, {{"all", SpaceOf::all_classes}, {"class", SpaceOf::each_class}},
      "windows whose histogram supplies the (k, c) of a class: all (paper 4.4.2), or those "
      "of the class (paper 3.4)");
}

}  // namespace piae::twin
