#pragma once

namespace piae::cli {

/// From now on SIGTERM and SIGINT do not end the program but make interrupted() true, so that it
/// can write a checkpoint first.
void catch_interrupts();
[[nodiscard]] bool interrupted();

}  // namespace piae::cli
