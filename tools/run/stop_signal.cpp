#include "stop_signal.hpp"

#include <csignal>
#include <initializer_list>

namespace beadswim {
namespace {

volatile std::sig_atomic_t received = 0;

void note(int signal) {
  received = signal;
}

}  // namespace

void catch_stop_signals() {
  std::signal(SIGPIPE, SIG_IGN);  // a reader that goes away is an error of writing, and no sudden death
  for (const int signal : {SIGINT, SIGTERM, SIGUSR1}) std::signal(signal, note);
}

int stop_signal() {
  return received;
}

}  // namespace beadswim
