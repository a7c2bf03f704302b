// shlmbench: photon maps against spherical harmonic light maps.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

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

namespace {

constexpr int bound_exceeded = 1;
constexpr int bad_input = 2;
constexpr int stopped_by_user = 130;  // as shells have it for SIGINT

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
    try {
        app.parse(argc, argv);
        return 0;
    } catch (const CLI::Success& e) {
        return app.exit(e);
    } catch (const CLI::ParseError& e) {
        fmt::print(stderr, "shlmbench: {}\n", e.what());
        return bad_input;
    }
}

}  // namespace

int main(int argc, char** argv) {
    common::note_interrupts();
    try {
        return run(argc, argv);
    } catch (const common::InputError& e) {
        fmt::print(stderr, "shlmbench: {}\n", e.what());
        return bad_input;
    } catch (const bench::BoundExceeded& e) {
        fmt::print(stderr, "shlmbench: {}\n", e.what());
        return bound_exceeded;
    } catch (const bench::Interrupted& e) {
        fmt::print(stderr, "shlmbench: {}\n", e.what());
        return stopped_by_user;
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "shlmbench: out of memory\n");
        return bad_input;
    } catch (const std::exception& e) {
        fmt::print(stderr, "shlmbench: {}\n", e.what());
        return 1;
    }
}
