#include "common/gltf/container.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <system_error>

#include "common/core/input_error.h"

namespace common::gltf {
namespace {

constexpr std::uint32_t magic = 0x46546C67;       // "glTF"
constexpr std::uint32_t json_chunk = 0x4E4F534A;  // "JSON"
constexpr std::uint32_t bin_chunk = 0x004E4942;   // "BIN\0"
constexpr std::size_t header_size = 12;
constexpr std::size_t chunk_header_size = 8;

using Bytes = std::span<const std::uint8_t>;

std::uint32_t little_endian_u32(Bytes bytes, std::size_t offset) {
    return static_cast<std::uint32_t>(bytes[offset]) | static_cast<std::uint32_t>(bytes[offset + 1]) << 8 |
           static_cast<std::uint32_t>(bytes[offset + 2]) << 16 |
           static_cast<std::uint32_t>(bytes[offset + 3]) << 24;
}

struct Chunk {
    std::uint32_t type;
    Bytes data;
};

/// Returns the chunk that starts at `offset`, and moves `offset` past it.
Chunk next_chunk(Bytes glb, std::size_t& offset) {
    if (glb.size() - offset < chunk_header_size)
        throw InputError("is truncated: a GLB chunk header is cut off");
    const std::size_t length = little_endian_u32(glb, offset);
    const std::uint32_t type = little_endian_u32(glb, offset + 4);
    offset += chunk_header_size;
    if (glb.size() - offset < length)
        throw InputError(
            fmt::format("is truncated: a GLB chunk of {} bytes has {} left", length, glb.size() - offset));
    const Bytes data = glb.subspan(offset, length);
    offset += length;
    return {type, data};
}

Container split_glb(Bytes file) {
    if (file.size() < header_size) throw InputError("is truncated: the GLB header is cut off");
    const std::uint32_t version = little_endian_u32(file, 4);
    if (version != 2) throw InputError(fmt::format("is GLB version {}; version 2 is needed", version));
    const std::size_t length = little_endian_u32(file, 8);
    if (length > file.size())
        throw InputError(
            fmt::format("is truncated: its header says {} bytes, the file has {}", length, file.size()));
    if (length < header_size) throw InputError("has a GLB header with an impossible length");

    const Bytes glb = file.first(length);
    std::size_t offset = header_size;
    const Chunk first = next_chunk(glb, offset);
    if (first.type != json_chunk) throw InputError("is a GLB whose first chunk is not JSON");
    Container container{std::string(first.data.begin(), first.data.end()), {}};
    // Only the chunk right after JSON can be the binary buffer; chunks of other types are to be ignored.
    if (offset < glb.size()) {
        const Chunk second = next_chunk(glb, offset);
        if (second.type == bin_chunk) container.binary.assign(second.data.begin(), second.data.end());
    }
    return container;
}

void append_u32(std::vector<std::uint8_t>& bytes, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

std::size_t padded(std::size_t size) {
    return (size + 3) / 4 * 4;
}

template <class Data>
void append_chunk(std::vector<std::uint8_t>& glb, std::uint32_t type, const Data& data,
                  std::uint8_t padding) {
    append_u32(glb, static_cast<std::uint32_t>(padded(data.size())));
    append_u32(glb, type);
    glb.insert(glb.end(), data.begin(), data.end());
    glb.insert(glb.end(), padded(data.size()) - data.size(), padding);
}

}  // namespace

std::vector<std::uint8_t> read_file(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) throw InputError("does not exist");
    if (!std::filesystem::is_regular_file(file, error)) throw InputError("is not a file");
    std::ifstream stream(file, std::ios::binary | std::ios::ate);
    if (!stream) throw InputError("cannot be opened");
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(stream.tellg()));
    stream.seekg(0);
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!stream) throw InputError("cannot be read");
    return bytes;
}

Container parse_container(std::span<const std::uint8_t> file) {
    if (file.size() >= 4 && little_endian_u32(file, 0) == magic) return split_glb(file);
    return {std::string(file.begin(), file.end()), {}};
}

Container read_container(const std::filesystem::path& file) {
    return parse_container(read_file(file));
}

std::vector<std::uint8_t> make_glb(std::string_view json, std::span<const std::uint8_t> binary) {
    std::size_t size = header_size + chunk_header_size + padded(json.size());
    if (!binary.empty()) size += chunk_header_size + padded(binary.size());
    if (size > std::numeric_limits<std::uint32_t>::max()) throw InputError("is larger than 4 GiB");

    std::vector<std::uint8_t> glb;
    glb.reserve(size);
    append_u32(glb, magic);
    append_u32(glb, 2);
    append_u32(glb, static_cast<std::uint32_t>(size));
    append_chunk(glb, json_chunk, json, ' ');
    if (!binary.empty()) append_chunk(glb, bin_chunk, binary, 0);
    return glb;
}

}  // namespace common::gltf
