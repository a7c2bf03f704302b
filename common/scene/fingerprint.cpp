#include "common/scene/fingerprint.h"

#include <fmt/format.h>

#include <span>
#include <type_traits>

#include "common/core/fnv.h"

namespace common {
namespace {

class Hash {
  public:
    /// Only for numbers and arrays of numbers: padding would add undefined bytes.
    template <class T>
    void add(const T& value) {
        static_assert(std::is_standard_layout_v<T>);  // Imath's vectors are not trivially copyable
        add_bytes(&value, sizeof(T));
    }

    template <class T>
    void add_all(std::span<const T> values) {
        add(values.size());
        add_bytes(values.data(), values.size_bytes());
    }

    [[nodiscard]] std::uint64_t value() const { return value_; }

  private:
    void add_bytes(const void* bytes, std::size_t count) {
        for (const std::uint8_t byte : std::span(static_cast<const std::uint8_t*>(bytes), count))
            value_ = fnv_step(value_, byte);
    }

    std::uint64_t value_ = fnv_start;
};

void add_geometry(Hash& hash, const Scene& scene) {
    hash.add_all(std::span<const Vec3>(scene.position));
    hash.add_all(std::span<const Vec3>(scene.normal));
    for (const auto& texcoord : scene.texcoord) hash.add_all(std::span<const Vec2>(texcoord));
    hash.add_all(std::span<const Vec3>(scene.tangent));
    hash.add_all(std::span<const float>(scene.tangent_sign));
    hash.add_all(std::span<const TriangleVertices>(scene.triangle));
    // Absent features are left out, so that a scene keeps its fingerprint when a feature is introduced.
    if (!scene.color.empty()) {
        hash.add_all(std::span<const Rgb>(scene.color));
        hash.add_all(std::span<const float>(scene.alpha));
    }
    if (scene.origin != Imath::V3d(0, 0, 0)) hash.add(scene.origin);
    hash.add(scene.instance.size());
    for (const MeshInstance& instance : scene.instance) {
        hash.add(instance.first_triangle);
        hash.add(instance.triangle_count);
        hash.add(instance.material);
    }
}

void add_use(Hash& hash, const TextureUse& use) {
    hash.add(use.texture);
    hash.add(use.texcoord_set);
    if (use.transform != TexcoordTransform{}) {
        hash.add(use.transform.offset);
        hash.add(use.transform.along_u);
        hash.add(use.transform.along_v);
    }
}

void add_material(Hash& hash, const Material& material) {
    hash.add(material.kind);
    hash.add(material.base_color);
    add_use(hash, material.base_color_texture);
    add_use(hash, material.normal_texture);
    hash.add(material.normal_scale);
    hash.add(material.emitted_radiance);
    add_use(hash, material.emissive_texture);
    hash.add(material.index_of_refraction);
    hash.add(material.double_sided);
    if (material.alpha_mode != AlphaMode::opaque) {
        hash.add(material.alpha_mode);
        hash.add(material.alpha);
        hash.add(material.alpha_cutoff);
    }
}

void add_texture(Hash& hash, const Texture& texture) {
    hash.add(texture.width());
    hash.add(texture.height());
    hash.add(texture.color_space());
    hash.add(texture.wrap());
    hash.add_all(texture.rgb());
    if (texture.has_alpha()) hash.add_all(texture.alpha());
    if (!texture.rgb_16().empty()) hash.add_all(texture.rgb_16());
    if (texture.filtering() != Filter::linear) hash.add(texture.filtering());
}

void add_lights(Hash& hash, const Scene& scene) {
    hash.add(scene.point_light.size());
    for (const PointLight& light : scene.point_light) {
        hash.add(light.position);
        hash.add(light.intensity);
    }
    hash.add(scene.spot_light.size());
    for (const SpotLight& light : scene.spot_light) {
        hash.add(light.position);
        hash.add(light.axis);
        hash.add(light.intensity);
        hash.add(static_cast<float>(light.cos_inner_angle));
        hash.add(static_cast<float>(light.cos_outer_angle));
        if (light.is_narrow()) {
            hash.add(light.cos_inner_angle);
            hash.add(light.cos_outer_angle);
        }
    }
    hash.add(scene.directional_light.size());
    for (const DirectionalLight& light : scene.directional_light) {
        hash.add(light.direction);
        hash.add(light.irradiance);
    }
    hash.add(scene.sky ? scene.sky->radiance : Rgb(0, 0, 0));
}

}  // namespace

std::string fingerprint(const Scene& scene) {
    Hash hash;
    add_geometry(hash, scene);
    hash.add(scene.material.size());
    for (const Material& material : scene.material) add_material(hash, material);
    hash.add(scene.texture.size());
    for (const Texture& texture : scene.texture) add_texture(hash, texture);
    add_lights(hash, scene);
    return fmt::format("{:016x}", hash.value());
}

}  // namespace common
