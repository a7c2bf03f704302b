// shlmbench: compares photon maps with spherical harmonic light maps.
#include <new>
#include <string>

#include "bench/setup/command.h"
#include "bench/setup/ending.h"
#include "common/core/input_error.h"
#include "common/core/interrupt.h"
#include "common/core/standard_streams.h"
#include "common/tracer/photon_source.h"

namespace {

constexpr int bound_exceeded = 1;
constexpr int bad_input = 2;
constexpr int stopped_by_user = 130;  // as shells have it for SIGINT

void complain(const std::string& text) {
    common::say("shlmbench: " + text);
}

/// Runs run_command(), and returns an exit code for whatever may be thrown.
int run_guarded(int argc, char** argv) {
    try {
        return bench::run_command(argc, argv, complain);
    } catch (const common::NoLight& e) {
        complain(std::string(e.what()) + "; add one with --sky R,G,B or --sun X,Y,Z,R,G,B");
        return bad_input;
    } catch (const common::InputError& e) {
        complain(e.what());
        return bad_input;
    } catch (const bench::BoundExceeded& e) {
        complain(e.what());
        return bound_exceeded;
    } catch (const bench::Interrupted& e) {
        complain(e.what());
        return stopped_by_user;
    } catch (const std::bad_alloc&) {
        complain("out of memory");
        return bad_input;
    } catch (const std::exception& e) {
        complain(e.what());
        return 1;
    }
}

}  // namespace

int main(int argc, char** argv) {
    common::secure_standard_streams();
    common::note_interrupts();
    const int exit_code = run_guarded(argc, argv);
    if (common::results_are_written()) return exit_code;
    complain("the result could not be written to standard output");
    return exit_code == 0 ? bad_input : exit_code;
}
