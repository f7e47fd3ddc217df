#pragma once

namespace beadswim {

/// From now on SIGINT, SIGTERM and SIGUSR1 ask the run to stop instead of killing it, and a
/// closed pipe does neither.
void catch_stop_signals();

/// The signal that has asked this rank to stop, or 0.
int stop_signal();

}  // namespace beadswim
