#pragma once

namespace piae::cli {

/// After this call SIGTERM, SIGINT, SIGUSR1 and SIGHUP no longer end the program. They make
/// interrupted() true, so that the program can write a checkpoint before it ends. USR1 is what srun
/// passes on. HUP stays without effect where nohup has made it so.
void catch_interrupts();
[[nodiscard]] bool interrupted();

}  // namespace piae::cli
