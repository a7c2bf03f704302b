#include "common/gltf/uri.h"

#include <array>
#include <charconv>
#include <string_view>

#include "common/core/input_error.h"
#include "common/gltf/container.h"

namespace common::gltf {
namespace {

constexpr std::uint8_t no_digit = 0xFF;

/// Values of the letters of base64 (RFC 4648, section 4).
constexpr std::array<std::uint8_t, 256> base64_digits() {
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::array<std::uint8_t, 256> digits{};
    digits.fill(no_digit);
    for (std::size_t i = 0; i < letters.size(); ++i)
        digits[static_cast<unsigned char>(letters[i])] = static_cast<std::uint8_t>(i);
    return digits;
}

std::vector<std::uint8_t> base64_decoded(std::string_view text) {
    static constexpr std::array<std::uint8_t, 256> digits = base64_digits();
    while (text.ends_with('=')) text.remove_suffix(1);
    std::vector<std::uint8_t> bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    int bit_count = 0;
    for (const char letter : text) {
        const std::uint8_t digit = digits[static_cast<unsigned char>(letter)];
        if (digit == no_digit) throw InputError("has a data uri that is not base64");
        bits = bits << 6 | digit;
        bit_count += 6;
        if (bit_count < 8) continue;
        bit_count -= 8;
        bytes.push_back(static_cast<std::uint8_t>(bits >> bit_count));
    }
    return bytes;
}

std::vector<std::uint8_t> read_data_uri(const std::string& uri) {
    const std::size_t comma = uri.find(',');
    if (comma == std::string::npos) throw InputError("has a data uri without data");
    const std::string data = percent_decoded(uri.substr(comma + 1));
    if (std::string_view(uri).substr(0, comma).ends_with(";base64")) return base64_decoded(data);
    return {data.begin(), data.end()};
}

}  // namespace

bool is_data_uri(const std::string& uri) {
    return uri.starts_with("data:");
}

std::string percent_decoded(const std::string& uri) {
    std::string name;
    name.reserve(uri.size());
    for (std::size_t i = 0; i < uri.size(); ++i) {
        unsigned char byte = 0;
        const char* digits = uri.data() + i + 1;
        if (uri[i] == '%' && i + 2 < uri.size() &&
            std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
            name += static_cast<char>(byte);
            i += 2;
        } else {
            name += uri[i];
        }
    }
    return name;
}

std::vector<std::uint8_t> read_uri(const std::string& uri, const std::filesystem::path& directory) {
    return is_data_uri(uri) ? read_data_uri(uri) : read_file(directory / percent_decoded(uri));
}

}  // namespace common::gltf
