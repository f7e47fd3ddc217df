#pragma once

namespace beadswim {

/// Installs handlers by which SIGINT, SIGTERM and SIGUSR1 request a stop instead of killing the program.
/// Ignores SIGPIPE.
void catch_stop_signals();

/// Returns the signal that requested this rank to stop, or 0.
int stop_signal();

}  // namespace beadswim
