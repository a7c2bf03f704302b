// Loads any bytes as a scene and gives it texels, or reports in one line what is wrong.
#include <cstdlib>
#include <cstring>

#include "tests/fuzz/broken_file.h"
#include "tests/fuzz/mutate_gltf.h"
#include "tests/fuzz/scratch_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const fuzz::ScratchFile file(".glb", std::span(data, size));
    if (fuzz::trouble_of_scene(file.path()).find('\n') != std::string::npos) std::abort();
    return 0;
}

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
    if (seed % 4 == 0) return LLVMFuzzerMutate(data, size, max_size);
    try {
        const auto mutated = fuzz::mutated_gltf(std::span(data, size), seed);
        if (mutated.size() > max_size) return LLVMFuzzerMutate(data, size, max_size);
        std::memcpy(data, mutated.data(), mutated.size());
        return mutated.size();
    } catch (const common::InputError&) {
        return LLVMFuzzerMutate(data, size, max_size);
    }
}
