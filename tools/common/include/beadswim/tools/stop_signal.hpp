#pragma once

namespace beadswim {

/// Makes the signals SIGINT, SIGTERM and SIGUSR1 request a stop, which stop_signal() returns, instead of
/// ending the program. SIGPIPE is ignored.
void catch_stop_signals();

/// Returns the number of the signal that this rank has received; 0 if it has received none.
int stop_signal();

}  // namespace beadswim
