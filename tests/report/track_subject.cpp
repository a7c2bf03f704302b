// Google Benchmarks of known instruction counts, for track_counts_test.py to count under callgrind.
#include <benchmark/benchmark.h>

namespace {

/// Eight instructions and the loop's own.
void work(std::int64_t rounds) {
    for (std::int64_t i = 0; i < rounds; ++i) asm volatile("nop\nnop\nnop\nnop\nnop\nnop\nnop\nnop\n");
}

void plain(benchmark::State& state) {
    for (auto _ : state) work(state.range(0));
}

/// A million rounds outside the clock.
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
