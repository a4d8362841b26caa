#pragma once

namespace piae::cli {

/// After this call SIGTERM, SIGINT, SIGUSR1 and SIGHUP no longer end the program. They make
/// interrupted() true, so that the program can write a checkpoint before it ends. USR1 is what srun
/// passes on. HUP stays without effect where nohup has made it so. A stage of the grid
/// calls it before Stage::run(), which says that it has started: from then on it is told to stop.
void catch_interrupts();
/// Before the program is replaced by another, which calls catch_interrupts() too: a signal that has
/// come, or comes until then, is kept for that one.
void hold_interrupts();
[[nodiscard]] bool interrupted();

}  // namespace piae::cli
