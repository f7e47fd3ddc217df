#pragma once

namespace beadswim {

/// Installs handlers for SIGINT, SIGTERM and SIGUSR1. These signals then request a stop, which stop_signal()
/// returns, and do not kill the program. SIGPIPE is ignored.
void catch_stop_signals();

/// Returns the number of the signal that this rank has received; 0 if it has received none.
int stop_signal();

}  // namespace beadswim
