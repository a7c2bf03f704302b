// Reads any bytes as a light map's file: either completely, or with one line that says what is wrong.
#include <cstdlib>

#include "tests/fuzz/broken_file.h"
#include "tests/fuzz/scratch_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const fuzz::ScratchFile file(".exr", std::span(data, size));
    if (fuzz::trouble_of_checkpoint(file.path()).find('\n') != std::string::npos) std::abort();
    return 0;
}
