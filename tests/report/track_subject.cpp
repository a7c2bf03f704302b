// Google Benchmarks of known instruction counts, for track_counts_test.py to count under callgrind.
#include <benchmark/benchmark.h>

namespace {

/// Executes eight instructions and those of the loop itself.
void work(std::int64_t rounds) {
    for (std::int64_t i = 0; i < rounds; ++i) asm volatile("nop\nnop\nnop\nnop\nnop\nnop\nnop\nnop\n");
}

void plain(benchmark::State& state) {
    for (auto _ : state) work(state.range(0));
}

/// Executes a million rounds outside the timed part.
void paused(benchmark::State& state) {
    for (auto _ : state) {
        work(state.range(0) / 2);
        state.PauseTiming();
        work(1'000'000);
        state.ResumeTiming();
        work(state.range(0) / 2);
    }
}

void failing(benchmark::State& state) {
    state.SkipWithError("as it should");
    for (auto _ : state) {
    }
}

}  // namespace

BENCHMARK(plain)->Arg(1'000)->Arg(101'000);
BENCHMARK(paused)->Arg(1'000)->Arg(101'000);
BENCHMARK(failing);
BENCHMARK_MAIN();
