// Requests to stop (Ctrl-C, SIGTERM, a closed terminal), which long work polls between two steps.
#pragma once

namespace common {

/// Installs handlers that only record the first SIGINT or SIGTERM; a second one ends the process as usual.
/// SIGHUP is recorded however often it comes, unless the parent process had it ignored.
void note_interrupts();

[[nodiscard]] bool interrupted();

}  // namespace common
