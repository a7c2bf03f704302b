// The benchmarks by subject. Each function registers its own with Google Benchmark; `inputs` must outlive the
// run.
#pragma once

#include "bench/experiments/micro/shared_inputs.h"

namespace bench::micro {

void register_sh_benchmarks(SharedInputs& inputs);
void register_trace_benchmarks(SharedInputs& inputs);
void register_accumulate_benchmarks(SharedInputs& inputs);
void register_sums_benchmarks(SharedInputs& inputs);
void register_append_benchmarks(SharedInputs& inputs);
void register_build_benchmarks(SharedInputs& inputs);
void register_gather_benchmarks(SharedInputs& inputs);

}  // namespace bench::micro
