#include "twin/options.hpp"

namespace piae::twin {

const char* to_string(Keep keep) { return keep == Keep::best ? "best" : "final"; }

void bind(const cli::Options& command, TwinOptions& o) {
  command.add("--epochs", o.epochs, "passes over the known windows").check(cli::positive_number());
  command.add("--batch", o.batch, "windows in a batch").check(cli::positive_number());
  command.add("--learning-rate", o.learning_rate, "of Adam, at the start")
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
       {"fixed", LossWeights::fixed}},
      "alpha, beta, gamma of eq. 23: adaptive, adaptive-without-log (the term that holds them "
      "above zero), or fixed (at 1)");
  command.add("--space-bins", o.space_bins, "bins of the digital twin space, for k and for c")
      .check(cli::whole_number(1, 1000));
  command.choose("--keep", o.keep,
                 {{to_string(Keep::best), Keep::best}, {to_string(Keep::final), Keep::final}},
                 "model that generates: best (lowest training loss) or final");
  command.add("--mass-kg", o.mass_kg, "M of eq. 22, kg").check(cli::positive_number());
  command.add("--load-n", o.load_n, "W of eq. 22, N").check(cli::positive_number());
  command.add("--clearance-um", o.clearance_um, "radial clearance of eq. 11, micrometres")
      .check(cli::non_negative_number());
}

}  // namespace piae::twin
