// Ctrl-C, SIGTERM and a closed terminal as a question that long work asks between two steps.
#pragma once

namespace common {

/// From now on the first SIGINT or SIGTERM is only noted; a second one ends the process as usual. SIGHUP is
/// noted however often it comes, unless whoever started the process had it ignored.
void note_interrupts();

[[nodiscard]] bool interrupted();

}  // namespace common
