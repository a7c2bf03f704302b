// shlmbench_micro: times the steps of both methods separately with Google Benchmark.
#include <benchmark/benchmark.h>

#include <nlohmann/json.hpp>

#include "bench/experiments/micro/subjects.h"
#include "bench/setup/provenance.h"
#include "common/core/input_error.h"

namespace {

using namespace bench::micro;

void add_context(const SharedInputs& inputs) {
    const nlohmann::ordered_json facts = bench::provenance();
    for (const char* key : {"machine", "instruction_set", "compiler", "flags", "commit"})
        benchmark::AddCustomContext(key, facts[key].get<std::string>());
    benchmark::AddCustomContext("scene", inputs.loaded().name);
    benchmark::AddCustomContext("seed", std::to_string(micro_seed));
}

void run_all() {
    SharedInputs inputs(SHLMBENCH_MICRO_SCENE);
    add_context(inputs);
    register_sh_benchmarks(inputs);
    register_trace_benchmarks(inputs);
    register_accumulate_benchmarks(inputs);
    register_sums_benchmarks(inputs);
    register_append_benchmarks(inputs);
    register_build_benchmarks(inputs);
    register_gather_benchmarks(inputs);
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}

}  // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    try {
        run_all();
        return 0;
    } catch (const common::InputError& e) {
        fmt::print(stderr, "shlmbench_micro: {}\n", e.what());
        return 2;
    }
}
