#include "common/tracer/embree_scene.h"

#include <gtest/gtest.h>

#include "common/tracer/embree.h"

namespace {

/// Returns the instruction set of a device that may use no wider vectors than `isa`, one of Embree's names.
std::string instruction_set_within(const char* isa) {
    const common::EmbreeDevice device(rtcNewDevice(isa));
    return common::instruction_set(device.get());
}

TEST(EmbreeScene, NamesTheInstructionSetThatEmbreeUses) {
#if defined(__x86_64__)
    EXPECT_EQ(instruction_set_within("isa=sse4.2"), "SSE4.2");
    if (__builtin_cpu_supports("avx2")) {
        EXPECT_EQ(instruction_set_within("isa=avx2"), "AVX2");
    }
    if (__builtin_cpu_supports("avx512vl")) {
        EXPECT_EQ(instruction_set_within("isa=avx512"), "AVX-512");
    }
#else
    EXPECT_NE(instruction_set_within(""), "");
#endif
}

}  // namespace
