#include "phase/options.hpp"

namespace piae::phase {

void bind(const cli::Options& command, PhaseOptions& options) {
  twin::bind(command, options.twin);
  bind(command, options.inference);
}

}  // namespace piae::phase
