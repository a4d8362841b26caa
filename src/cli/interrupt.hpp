#pragma once

namespace piae::cli {

/// After this call SIGTERM and SIGINT no longer end the program. They make interrupted() true, so
/// that the program can write a checkpoint before it ends.
void catch_interrupts();
[[nodiscard]] bool interrupted();

}  // namespace piae::cli
