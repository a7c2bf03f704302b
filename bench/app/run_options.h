// How much to trace, with how many threads and which random numbers.
#pragma once

#include <cstdint>

namespace CLI {
class App;
}

namespace bench {

/// --seed: any whole number from 0 to 2^64 - 1.
void add_seed_option(CLI::App& command, std::uint64_t& seed);

/// --threads: 0 means all.
void add_threads_option(CLI::App& command, int& threads);

struct RunOptions {
    int threads = 0;  ///< 0: as many as the machine has
    std::uint64_t seed = 1;

    void add_to(CLI::App& command);

    /// Throws InputError for a number of threads that no machine has.
    [[nodiscard]] int thread_count() const;
};

}  // namespace bench
