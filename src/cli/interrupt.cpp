#include "cli/interrupt.hpp"

#include <csignal>
#include <initializer_list>

namespace piae::cli {

namespace {

volatile std::sig_atomic_t caught = 0;

void remember(int /*signal*/) { caught = 1; }

}  // namespace

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = remember;
  struct sigaction before {};
  sigaction(SIGHUP, nullptr, &before);
  if (before.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);
  for (const int signal : {SIGINT, SIGUSR1, SIGTERM}) sigaction(signal, &action, nullptr);
}

bool interrupted() { return caught != 0; }

}  // namespace piae::cli
