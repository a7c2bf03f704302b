// shlmbench: photon maps against spherical harmonic light maps.
#include <CLI/CLI.hpp>
#include <string>

#include "bench/app/diff.h"
#include "bench/app/ending.h"
#include "bench/app/info.h"
#include "bench/app/merge.h"
#include "bench/app/reference.h"
#include "bench/app/render.h"
#include "bench/app/trace.h"
#include "bench/bases/bases.h"
#include "bench/compare/compare.h"
#include "bench/fit/fit.h"
#include "bench/limit/limit.h"
#include "bench/stability/stability.h"
#include "bench/study/study.h"
#include "common/core/input_error.h"
#include "common/core/interrupt.h"
#include "common/core/standard_streams.h"

namespace {

constexpr int bound_exceeded = 1;
constexpr int bad_input = 2;
constexpr int stopped_by_user = 130;  // as shells have it for SIGINT

void complain(const std::string& text) {
    common::say("shlmbench: " + text);
}

/// A value that is empty is a variable of a script that has none; to leave the option out says that nothing
/// is asked for.
void refuse_empty_values(CLI::App& app) {
    const auto is_empty = [](const std::string& text) { return text.empty() ? "has no value" : ""; };
    for (CLI::App* command : app.get_subcommands({}))
        for (CLI::Option* option : command->get_options())
            if (option->get_items_expected_max() > 0) option->check(is_empty);
}

int run(int argc, char** argv) {
    CLI::App app(
        "Photon maps against spherical harmonic light maps: memory, speed and error, measured side by side");
    app.require_subcommand(1);
    bench::add_info_command(app);
    bench::add_render_command(app);
    bench::add_trace_command(app);
    bench::add_merge_command(app);
    bench::add_reference_command(app);
    bench::add_compare_command(app);
    bench::add_study_command(app);
    bench::add_diff_command(app);
    bench::add_bases_command(app);
    bench::add_limit_command(app);
    bench::add_fit_command(app);
    bench::add_stability_command(app);
    refuse_empty_values(app);
    try {
        app.parse(argc, argv);
        return 0;
    } catch (const CLI::Success& e) {
        return app.exit(e);
    } catch (const CLI::ParseError& e) {
        complain(e.what());
        return bad_input;
    }
}

/// As run(), with an exit code for whatever may be thrown.
int run_guarded(int argc, char** argv) {
    try {
        return run(argc, argv);
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
