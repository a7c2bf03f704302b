#include "bench/setup/run_options.h"

#include <thread>

#include "bench/setup/command.h"
#include "bench/setup/numbers.h"
#include "common/core/input_error.h"

namespace bench {

void add_seed_option(Command& command, std::uint64_t& seed) {
    command.whole_number("--seed", seed, "Another seed, other random numbers");
}

void add_threads_option(Command& command, int& threads) {
    command.whole_number("--threads", threads, "0: all");
}

void RunOptions::add_to(Command& command) {
    add_threads_option(command, threads);
    add_seed_option(command, seed);
}

int RunOptions::thread_count() const {
    if (threads < 0 || threads > 1024)
        throw common::InputError("--threads: from 0, which means all, to 1024");
    return threads > 0 ? threads : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

}  // namespace bench
