#include "bench/app/run_options.h"

#include <CLI/CLI.hpp>
#include <thread>

#include "bench/app/number_options.h"
#include "common/core/input_error.h"

namespace bench {

void add_seed_option(CLI::App& command, std::uint64_t& seed) {
    add_whole_number(command, "--seed", seed, "Another seed, other random numbers");
}

void add_threads_option(CLI::App& command, int& threads) {
    add_whole_number(command, "--threads", threads, "0: all");
}

void RunOptions::add_to(CLI::App& command) {
    add_threads_option(command, threads);
    add_seed_option(command, seed);
}

int RunOptions::thread_count() const {
    if (threads < 0 || threads > 1024)
        throw common::InputError("--threads: from 0, which means all, to 1024");
    return threads > 0 ? threads : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

}  // namespace bench
