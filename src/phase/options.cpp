#include "phase/options.hpp"

#include <CLI/CLI.hpp>

namespace piae::phase {

void bind(CLI::App& app, PhaseOptions& options) {
  twin::bind(app, options.twin);
  bind(app, options.inference, "piae-dt-phase");
}

}  // namespace piae::phase
