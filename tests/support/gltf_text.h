// Small glTF files that tests build in memory.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "common/gltf/container.h"

namespace gltf_text {

using Json = nlohmann::json;
using Bytes = std::vector<std::uint8_t>;

inline constexpr int u8 = 5121, i16 = 5122, u16 = 5123, u32 = 5125, f32 = 5126;

template <class T>
Bytes bytes_of(const std::vector<T>& values) {
    Bytes bytes(values.size() * sizeof(T));
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

/// A directory of the running test, removed with the object.
class TemporaryDirectory {
  public:
    TemporaryDirectory() {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        std::string name = std::string("gltf_") + test->test_suite_name() + "_" + test->name() + "_XXXXXX";
        std::replace(name.begin(), name.end(), '/', '_');  // of tests with parameters
        std::string path = (std::filesystem::temp_directory_path() / name).string();
        if (mkdtemp(path.data()) == nullptr) throw std::runtime_error("no temporary directory");
        path_ = path;
    }
    ~TemporaryDirectory() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryDirectory(const TemporaryDirectory&) = delete;
    TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    std::filesystem::path write(const std::string& name, std::span<const std::uint8_t> bytes) const {
        std::ofstream stream(path_ / name, std::ios::binary);
        stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        return path_ / name;
    }
    std::filesystem::path write(const std::string& name, const std::string& text) const {
        return write(name, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
    }

  private:
    std::filesystem::path path_;
};

/// A glTF document with one buffer. Tests change `document` at will before they write it.
struct GltfFile {
    Json document = {{"asset", {{"version", "2.0"}}}};
    Bytes buffer;

    /// These functions return the index of what they add.
    int add_view(const Bytes& bytes) {
        const std::size_t offset = buffer.size();
        buffer.insert(buffer.end(), bytes.begin(), bytes.end());
        buffer.resize((buffer.size() + 3) / 4 * 4);
        document["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", bytes.size()}});
        return static_cast<int>(document["bufferViews"].size()) - 1;
    }
    template <class T>
    int add_accessor(const std::vector<T>& values, int component_type, const std::string& type) {
        const std::size_t width = type == "SCALAR" ? 1 : static_cast<std::size_t>(type.back() - '0');
        document["accessors"].push_back({{"bufferView", add_view(bytes_of(values))},
                                         {"componentType", component_type},
                                         {"count", values.size() / width},
                                         {"type", type}});
        return static_cast<int>(document["accessors"].size()) - 1;
    }

    Json& primitive() { return document["meshes"][0]["primitives"][0]; }
    Json& node(std::size_t i = 0) { return document["nodes"][i]; }
    Json& accessor(int i) { return document["accessors"][static_cast<std::size_t>(i)]; }
    Json& view(int i) { return document["bufferViews"][static_cast<std::size_t>(i)]; }
    /// Returns the only material, which the only primitive uses.
    Json& material() {
        primitive()["material"] = 0;
        return document["materials"][0];
    }

    /// Writes a .gltf file with its buffer beside it, and returns its path.
    [[nodiscard]] std::filesystem::path write(const TemporaryDirectory& directory) const {
        directory.write("data.bin", buffer);
        Json text = document;
        if (!buffer.empty() && !text.contains("buffers"))
            text["buffers"] = {{{"byteLength", buffer.size()}, {"uri", "data.bin"}}};
        return directory.write("scene.gltf", text.dump());
    }
    /// Returns the bytes of a .glb file.
    [[nodiscard]] Bytes glb() const {
        Json text = document;
        text["buffers"] = {{{"byteLength", buffer.size()}}};
        return common::gltf::make_glb(text.dump(), buffer);
    }
};

/// Returns a white Lambertian material, since glTF's default is a metal.
inline Json matt() {
    return {{"pbrMetallicRoughness", {{"metallicFactor", 0}}}};
}

/// Makes one unindexed triangle (0,0,0), (1,0,0), (0,1,0) that faces +z: accessor 0, mesh 0, node 0, scene 0,
/// with the matt material 0.
inline GltfFile one_triangle() {
    GltfFile file;
    const int position = file.add_accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, f32, "VEC3");
    file.document["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", position}}}}}}}};
    file.material() = matt();
    file.document["nodes"] = {{{"mesh", 0}}};
    file.document["scenes"] = {{{"nodes", {0}}}};
    file.document["scene"] = 0;
    return file;
}

/// Returns a PNG of two pixels side by side, red and green.
inline Bytes red_green_png() {
    return {0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A, 0x00, 0x00, 0x00, 0x0D, 0x49, 0x48, 0x44,
            0x52, 0x00, 0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x01, 0x08, 0x02, 0x00, 0x00, 0x00, 0x7B,
            0x40, 0xE8, 0xDD, 0x00, 0x00, 0x00, 0x0F, 0x49, 0x44, 0x41, 0x54, 0x78, 0xDA, 0x63, 0xF8,
            0xCF, 0xC0, 0xC0, 0xF0, 0x9F, 0x01, 0x00, 0x07, 0xFF, 0x01, 0xFF, 0xB8, 0x04, 0x35, 0xE0,
            0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4E, 0x44, 0xAE, 0x42, 0x60, 0x82};
}

/// Returns a PNG of one pixel with 16 bits per channel: 65535, 32800 and 1, which round to 255, 128 and 0 of
/// 255.
inline Bytes sixteen_bit_png() {
    return {0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A, 0x00, 0x00, 0x00, 0x0D, 0x49, 0x48, 0x44,
            0x52, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x10, 0x02, 0x00, 0x00, 0x00, 0xC0,
            0xE7, 0x8F, 0x9D, 0x00, 0x00, 0x00, 0x0F, 0x49, 0x44, 0x41, 0x54, 0x78, 0xDA, 0x63, 0xF8,
            0xFF, 0xBF, 0x41, 0x81, 0x81, 0x11, 0x00, 0x0D, 0x5D, 0x02, 0xA0, 0xD7, 0x77, 0xB6, 0x2F,
            0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4E, 0x44, 0xAE, 0x42, 0x60, 0x82};
}

/// Returns a PNG of two pixels side by side, red with alpha 255 and green with alpha 128.
inline Bytes half_clear_png() {
    return {0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A, 0x00, 0x00, 0x00, 0x0D, 0x49, 0x48, 0x44,
            0x52, 0x00, 0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x01, 0x08, 0x06, 0x00, 0x00, 0x00, 0xF4,
            0x22, 0x7F, 0x8A, 0x00, 0x00, 0x00, 0x0F, 0x49, 0x44, 0x41, 0x54, 0x78, 0xDA, 0x63, 0xF8,
            0xCF, 0xC0, 0xF0, 0x1F, 0x08, 0x1B, 0x00, 0x10, 0x79, 0x03, 0x7E, 0xC4, 0x18, 0x72, 0x90,
            0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4E, 0x44, 0xAE, 0x42, 0x60, 0x82};
}

}  // namespace gltf_text
