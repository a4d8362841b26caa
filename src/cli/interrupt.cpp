#include "cli/interrupt.hpp"

#include <array>
#include <csignal>

namespace piae::cli {

namespace {

constexpr std::array stopping{SIGHUP, SIGINT, SIGUSR1, SIGTERM};

volatile std::sig_atomic_t caught = 0;

void remember(int /*signal*/) { caught = 1; }

/// Blocks or unblocks the signals. exec keeps blocked signals and their mask, but not handlers.
void mask(int how) {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : stopping) sigaddset(&signals, signal);
  sigprocmask(how, &signals, nullptr);
}

}  // namespace

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = remember;
  for (const int signal : stopping) {
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    if (signal == SIGHUP && before.sa_handler == SIG_IGN) continue;
    sigaction(signal, &action, nullptr);
  }
  mask(SIG_UNBLOCK);
}

void hold_interrupts() {
  mask(SIG_BLOCK);
  if (interrupted()) std::raise(SIGTERM);
}

bool interrupted() { return caught != 0; }

}  // namespace piae::cli
