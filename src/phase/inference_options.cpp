#include "phase/inference_options.hpp"

namespace piae::phase {

void bind(const cli::Options& command, InferenceOptions& o) {
  const auto add = [&](const std::string& name, auto& value, const std::string& help) {
    command.add(name, value, help).check(cli::positive_number());
  };
  add("--stiffness-from-n-per-m", o.stiffness_from_n_per_m,
      "least stiffness to search, N/m; the largest is load / clearance");
  add("--damping-from-ns-per-m", o.damping_from_ns_per_m, "least damping to search, N s/m");
  add("--damping-to-ns-per-m", o.damping_to_ns_per_m, "largest damping to search, N s/m");
  add("--simulations", o.simulations,
      "simulated windows of each class that train the inference of (k, c)");
  add("--inference-epochs", o.epochs, "passes over the simulated windows in each of two rounds");
  add("--inference-batch", o.batch, "simulated windows in a batch");
  add("--inference-width", o.width, "units of each hidden layer of the inference network");
  add("--inference-learning-rate", o.learning_rate,
      "learning rate of Adam for the inference at the start");
  add("--snr-to-db", o.snr_to_db,
      "largest signal-to-noise ratio of simulated windows, dB; drawn from 0 dB to this");
}

}  // namespace piae::phase
