#include "common/core/interrupt.h"

#include <csignal>

namespace common {
namespace {

// A signal handler can reach nothing but a global.
volatile std::sig_atomic_t noted = 0;

void note(int signal) {
    noted = 1;
    // A closing terminal may cause several SIGHUPs: one from the shell and one from the kernel.
    if (signal != SIGHUP) std::signal(signal, SIG_DFL);
}

}  // namespace

void note_interrupts() {
    std::signal(SIGINT, note);
    std::signal(SIGTERM, note);
    if (std::signal(SIGHUP, note) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);  // so that nohup works
}

bool interrupted() {
    return noted != 0;
}

}  // namespace common
