#include "common/image/exr_headers.h"

#include <bit>
#include <cstdint>
#include <fstream>
#include <string>

#include "common/core/input_error.h"

namespace common {
namespace {

constexpr std::streamoff magic_and_version = 8;

[[noreturn]] void cut_off() {
    throw InputError("it is cut off within its header");
}

/// Reads up to the next zero byte, which is not part of the result.
std::string next_word(std::istream& file) {
    std::string word;
    if (!std::getline(file, word, '\0') || file.eof()) cut_off();
    return word;
}

/// Skips name, type, size and value of an attribute. Returns false for the empty name that ends a header.
bool skip_attribute(std::istream& file, std::streamoff end) {
    if (next_word(file).empty()) return false;
    (void)next_word(file);
    static_assert(std::endian::native == std::endian::little);
    std::int32_t size = 0;
    if (!file.read(reinterpret_cast<char*>(&size), sizeof size)) cut_off();
    if (size < 0 || size > end - file.tellg()) cut_off();
    file.seekg(size, std::ios::cur);
    return true;
}

}  // namespace

void check_exr_headers(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    if (!file) throw InputError("it cannot be opened");
    const std::streamoff end = file.tellg();
    if (end <= magic_and_version) cut_off();
    std::int32_t magic_and_flags[2] = {};
    file.seekg(0);
    file.read(reinterpret_cast<char*>(magic_and_flags), magic_and_version);
    constexpr std::int32_t has_parts = 0x1000;
    if ((magic_and_flags[1] & has_parts) == 0) {
        while (skip_attribute(file, end)) {
        }
        return;
    }
    // Headers follow each other until one without attributes.
    while (skip_attribute(file, end))
        while (skip_attribute(file, end)) {
        }
}

}  // namespace common
