#include "beadswim/tools/stop_signal.hpp"

#include <csignal>
#include <initializer_list>

namespace beadswim {
namespace {

volatile std::sig_atomic_t received = 0;

void store_signal(int signal) {
  received = signal;
}

}  // namespace

void catch_stop_signals() {
  std::signal(SIGPIPE, SIG_IGN);  // writing to a closed pipe then fails with an error
  for (const int signal : {SIGINT, SIGTERM, SIGUSR1}) std::signal(signal, store_signal);
}

int stop_signal() {
  return received;
}

}  // namespace beadswim
