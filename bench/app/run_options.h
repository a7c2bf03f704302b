// How much to trace, with how many threads and which random numbers.
#pragma once

#include <cstdint>

namespace CLI {
class App;
}

namespace bench {

/// --seed: any number that is not negative.
void add_seed_option(CLI::App& command, std::uint64_t& seed);

struct RunOptions {
    int threads = 0;  ///< 0: as many as the machine has
    std::uint64_t seed = 1;

    void add_to(CLI::App& command);

    /// Throws InputError for a number of threads that no machine has.
    [[nodiscard]] int thread_count() const;
};

}  // namespace bench
