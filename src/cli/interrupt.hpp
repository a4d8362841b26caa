#pragma once

namespace piae::cli {

/// Stops SIGTERM, SIGINT, SIGUSR1 and SIGHUP from ending the program. They make interrupted() true
/// instead, so that the program can write a checkpoint first. Unblocks them, too. srun passes USR1
/// on. HUP stays ignored under nohup. `train` calls this before Stage::run(), which reports its
/// start: from then on it may receive signals.
void catch_interrupts();
/// Blocks these signals before the program is replaced by another one, which calls
/// catch_interrupts(), too. Signals that have arrived, or arrive until then, are delivered to the
/// new program.
void hold_interrupts();
[[nodiscard]] bool interrupted();

}  // namespace piae::cli
