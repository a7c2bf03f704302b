// Shared by the tests of the glTF loader: a fixture that writes files and loads them.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "common/core/input_error.h"
#include "common/gltf/load_gltf.h"
#include "tests/support/gltf_text.h"

namespace gltf_text {

using common::Rgb;
using common::Scene;
using common::Vec2;
using common::Vec3;

inline constexpr float nan_value = std::numeric_limits<float>::quiet_NaN();

inline void expect_near(const Vec3& value, const Vec3& expected, float tolerance = 1e-6f) {
    EXPECT_LE((value - expected).length(), tolerance) << value << " instead of " << expected;
}

inline bool has_warning(const Scene& scene, const std::string& part) {
    for (const std::string& warning : scene.warnings) {
        if (warning.find(part) != std::string::npos) return true;
    }
    return false;
}

/// Makes one triangle with both sets of texture coordinates and a matt material without textures.
inline GltfFile textured_triangle() {
    GltfFile file = one_triangle();
    file.primitive()["attributes"]["TEXCOORD_0"] = file.add_accessor<float>({0, 0, 1, 0, 0, 1}, f32, "VEC2");
    file.primitive()["attributes"]["TEXCOORD_1"] = file.primitive()["attributes"]["TEXCOORD_0"];
    file.document["textures"] = {{{"source", 0}}};
    file.document["images"] = {{{"uri", "red green.png"}}};
    return file;
}

class LoadGltf : public testing::Test {
  protected:
    [[nodiscard]] Scene load(const GltfFile& file) const { return common::load_gltf(file.write(directory)); }

    /// Returns the message with which `file` is refused.
    [[nodiscard]] static std::string error_of(const std::filesystem::path& file) {
        try {
            (void)common::load_gltf(file);
        } catch (const common::InputError& error) {
            return error.what();
        }
        return "loaded";
    }
    void expect_error(const std::filesystem::path& file, const std::string& part) const {
        const std::string error = error_of(file);
        EXPECT_NE(error.find(part), std::string::npos) << error;
        EXPECT_EQ(error.find(file.string()), 0u) << error;
        EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    }
    void expect_error(const GltfFile& file, const std::string& part) const {
        expect_error(file.write(directory), part);
    }

    /// Expects that the textured triangle is refused if one value is replaced at the JSON pointer `place`.
    void expect_change_refused(const char* place, const Json& value, const std::string& part) const {
        GltfFile file = textured_triangle();
        file.document[Json::json_pointer(place)] = value;
        expect_error(file, part);
    }

    TemporaryDirectory directory;
};

using LoadGltfGeometry = LoadGltf;
using LoadGltfNodes = LoadGltf;
using LoadGltfMaterials = LoadGltf;
using LoadGltfTextures = LoadGltf;
using LoadGltfLights = LoadGltf;
using LoadGltfCameras = LoadGltf;
using LoadGltfErrors = LoadGltf;

/// Returns the positions of the triangles' corners.
inline std::vector<std::array<Vec3, 3>> triangles_of(const Scene& scene) {
    std::vector<std::array<Vec3, 3>> triangles;
    for (const auto& [a, b, c] : scene.triangle)
        triangles.push_back({scene.position[a], scene.position[b], scene.position[c]});
    return triangles;
}

}  // namespace gltf_text
