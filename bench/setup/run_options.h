// Options for the threads and the random numbers of a run.
#pragma once

#include <cstdint>

#include "bench/setup/command.h"

namespace bench {

/// --seed: any whole number from 0 to 2^64 - 1.
void add_seed_option(Command& command, std::uint64_t& seed);

/// --threads: 0 means all.
void add_threads_option(Command& command, int& threads);

struct RunOptions {
    int threads = 0;  ///< 0: as many as the machine has
    std::uint64_t seed = 1;

    void add_to(Command& command);

    /// Throws InputError for a number of threads that no machine has.
    [[nodiscard]] int thread_count() const;
};

}  // namespace bench
