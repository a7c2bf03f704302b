// Ctrl-C and SIGTERM as a question that long work asks between two steps.
#pragma once

namespace common {

/// From now on the first SIGINT or SIGTERM is only noted; a second one ends the process as usual.
void note_interrupts();

[[nodiscard]] bool interrupted();

}  // namespace common
