#include "bench/app/run_options.h"

#include <CLI/CLI.hpp>
#include <thread>

#include "common/core/input_error.h"

namespace bench {

void add_seed_option(CLI::App& command, std::uint64_t& seed) {
    // CLI11 would take -1 for 2^64 - 1.
    command.add_option("--seed", seed, "Another seed, other random numbers")
        ->check([](const std::string& text) {
            return std::string(text.starts_with('-') ? "must not be negative" : "");
        })
        ->capture_default_str();
}

void RunOptions::add_to(CLI::App& command) {
    command.add_option("--threads", threads, "0: all")->capture_default_str();
    add_seed_option(command, seed);
}

int RunOptions::thread_count() const {
    if (threads < 0 || threads > 1024)
        throw common::InputError("--threads: from 0, which means all, to 1024");
    return threads > 0 ? threads : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

}  // namespace bench
