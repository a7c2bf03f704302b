#include "bench/export/lit_glb.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <cmath>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>

#include "bench/export/lightmap_files.h"
#include "common/gltf_writing/model_parts.h"
#include "common/image/image.h"

namespace bench {
namespace {

using common::Rgb;
using common::Vec3;
using Imath::V4f;
namespace gltf_writing = common::gltf_writing;
using tinygltf::Value;

/// The same as a value of tinygltf's.
Value to_value(const nlohmann::ordered_json& json) {
    if (json.is_object()) {
        Value::Object object;
        for (const auto& [key, value] : json.items()) object[key] = to_value(value);
        return Value(std::move(object));
    }
    if (json.is_array()) {
        Value::Array array;
        for (const auto& value : json) array.push_back(to_value(value));
        return Value(std::move(array));
    }
    if (json.is_string()) return Value(json.get<std::string>());
    if (json.is_boolean()) return Value(json.get<bool>());
    const double number = json.get<double>();  // tinygltf's integers have 32 bits
    if (json.is_number_integer() && std::abs(number) < 0x1p31) return Value(json.get<int>());
    return Value(number);
}

class GlbBuilder {
  public:
    explicit GlbBuilder(const LitScene& scene) : scene_(scene) {
        model_.asset.version = "2.0";
        model_.asset.generator = "shlmbench export";
        model_.buffers.resize(1);
        model_.scenes.resize(1);
        model_.defaultScene = 0;
    }

    [[nodiscard]] std::string bytes() {
        add_textures();
        const int lightmap = add_lightmap_picture();
        for (const common::Material& material : scene_.loaded.scene.material)
            add_material(material, lightmap);
        add_camera();
        for (const LitPrimitive& primitive : scene_.primitives) add_primitive(primitive);
        add_maps();
        return gltf_writing::glb_bytes(model_, "lit.glb");
    }

  private:
    template <class T>
    int add_view(std::span<const T> items) {
        return gltf_writing::add_view(std::as_bytes(items), 0, model_);
    }

    /// A column that may be empty.
    template <class T>
    void add_column(tinygltf::Primitive& primitive, const std::string& name, const std::vector<T>& items) {
        if (!items.empty()) primitive.attributes[name] = gltf_writing::add_attribute(items, model_);
    }

    // --- textures and materials

    int add_picture(const std::string& name, int width, int height, int components,
                    const std::vector<unsigned char>& pixels, int sampler) {
        const std::vector<std::byte> png = common::encode_png(width, height, components, pixels);
        tinygltf::Image image;  // in the buffer, where binary glTF wants it
        image.name = name;
        image.mimeType = "image/png";
        image.bufferView = add_view(std::span(png));
        tinygltf::Texture texture;
        texture.source = static_cast<int>(model_.images.size());
        texture.sampler = sampler;
        model_.images.push_back(std::move(image));
        model_.textures.push_back(std::move(texture));
        return static_cast<int>(model_.textures.size()) - 1;
    }

    /// Without mipmaps: the program filters the image itself.
    int add_sampler(common::Wrap wrap_u, common::Wrap wrap_v, common::Filter filtering) {
        const auto mode = [](common::Wrap wrap) {
            return wrap == common::Wrap::repeat          ? TINYGLTF_TEXTURE_WRAP_REPEAT
                   : wrap == common::Wrap::clamp_to_edge ? TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE
                                                         : TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT;
        };
        tinygltf::Sampler sampler;
        sampler.magFilter = sampler.minFilter = filtering == common::Filter::linear
                                                    ? TINYGLTF_TEXTURE_FILTER_LINEAR
                                                    : TINYGLTF_TEXTURE_FILTER_NEAREST;
        sampler.wrapS = mode(wrap_u);
        sampler.wrapT = mode(wrap_v);
        model_.samplers.push_back(std::move(sampler));
        return static_cast<int>(model_.samplers.size()) - 1;
    }

    void add_textures() {
        for (const common::Texture& texture : scene_.loaded.scene.texture) {
            const std::size_t pixels = texture.rgb().size() / 3, components = texture.has_alpha() ? 4 : 3;
            std::vector<unsigned char> bytes(pixels * components);
            for (std::size_t p = 0; p < pixels; ++p) {
                std::memcpy(&bytes[p * components], &texture.rgb()[p * 3], 3);
                if (texture.has_alpha()) bytes[p * components + 3] = texture.alpha()[p];
            }
            const auto [wrap_u, wrap_v] = texture.wrap();
            add_picture(texture.name(), texture.width(), texture.height(), static_cast<int>(components),
                        bytes, add_sampler(wrap_u, wrap_v, texture.filtering()));
        }
    }

    /// The first map's irradiance at the texels' own normals; keeps the largest as intensity_.
    int add_lightmap_picture() {
        const StoredTexels& texels = scene_.maps.front().texels;
        const LightAtlas& atlas = scene_.atlas;
        for (const std::uint32_t texel : atlas.shown)
            if (texel != shlm::no_texel)
                intensity_ = std::max(intensity_, common::max_component(texels.own[texel]));
        if (intensity_ == 0) intensity_ = 1;
        std::vector<unsigned char> bytes(3 * atlas.pixel_count());
        for (std::size_t p = 0; p < atlas.pixel_count(); ++p)
            for (std::size_t c = 0; atlas.shown[p] != shlm::no_texel && c < 3; ++c) {
                const float light = texels.own[atlas.shown[p]][static_cast<int>(c)] / intensity_;
                bytes[3 * p + c] =
                    static_cast<unsigned char>(std::lround(255 * std::clamp(light, 0.0f, 1.0f)));
            }
        return add_picture(
            "irradiance", static_cast<int>(atlas.places.width()), static_cast<int>(atlas.places.height()), 3,
            bytes,
            add_sampler(common::Wrap::clamp_to_edge, common::Wrap::clamp_to_edge, common::Filter::linear));
    }

    /// Set 1 is the light map's.
    static int gltf_set(int set) { return set <= 0 ? 0 : set + 1; }

    void add_material(const common::Material& in, int lightmap) {
        using common::SurfaceKind;
        const TexcoordUse use = texcoord_use(in);
        tinygltf::Material out;
        out.name = in.name;
        auto& pbr = out.pbrMetallicRoughness;
        pbr.baseColorFactor = {in.base_color.x, in.base_color.y, in.base_color.z, in.alpha};
        pbr.metallicFactor = in.kind == SurfaceKind::mirror ? 1.0 : 0.0;
        pbr.roughnessFactor = in.kind == SurfaceKind::diffuse ? 1.0 : 0.0;
        pbr.baseColorTexture.index = in.base_color_texture.texture;
        pbr.baseColorTexture.texCoord = gltf_set(use.base_color);
        out.normalTexture.index = in.normal_texture.texture;
        out.normalTexture.texCoord = gltf_set(use.normal);
        out.normalTexture.scale = in.normal_scale;
        out.emissiveTexture.index = in.emissive_texture.texture;
        out.emissiveTexture.texCoord = gltf_set(use.emissive);
        out.alphaMode = in.alpha_mode == common::AlphaMode::opaque ? "OPAQUE"
                        : in.alpha_mode == common::AlphaMode::mask ? "MASK"
                                                                   : "BLEND";
        out.alphaCutoff = in.alpha_cutoff;
        if (in.emits()) gltf_writing::set_emission(in.emitted_radiance, out, model_);
        if (in.kind == SurfaceKind::dielectric || in.kind == SurfaceKind::thin_sheet)
            gltf_writing::set_glass(in.index_of_refraction, in.kind == SurfaceKind::dielectric, out, model_);
        if (in.kind == SurfaceKind::diffuse) {
            Value::Object extension;
            extension["index"] = Value(lightmap);
            extension["texCoord"] = Value(1);
            extension["intensity"] = Value(static_cast<double>(intensity_));
            out.extensions["MOZ_lightmap"] = Value(std::move(extension));
            gltf_writing::use_extension(model_, "MOZ_lightmap");
        }
        model_.materials.push_back(std::move(out));
    }

    // --- nodes

    tinygltf::Node& add_node(const std::string& name) {
        tinygltf::Node node;
        node.name = name;
        model_.scenes.front().nodes.push_back(static_cast<int>(model_.nodes.size()));
        model_.nodes.push_back(std::move(node));
        return model_.nodes.back();
    }

    void add_camera() {
        const common::Camera& in = scene_.loaded.camera;
        constexpr double aspect_ratio = 16.0 / 9.0;
        const float size = scene_.loaded.scene.diagonal();
        tinygltf::Camera camera;
        camera.name = in.name;
        camera.type = "perspective";
        camera.perspective.aspectRatio = aspect_ratio;
        camera.perspective.yfov = in.vertical_fov;
        camera.perspective.znear = 1e-4 * size;
        camera.perspective.zfar = 10.0 * size;
        const Vec3 right = in.forward.cross(in.up).normalized(), up = right.cross(in.forward);
        tinygltf::Node& node = add_node(in.name);
        node.matrix = {right.x,       right.y,       right.z,       0, up.x,     up.y,     up.z,     0,
                       -in.forward.x, -in.forward.y, -in.forward.z, 0, in.eye.x, in.eye.y, in.eye.z, 1};
        node.camera = static_cast<int>(model_.cameras.size());
        model_.cameras.push_back(std::move(camera));
    }

    void add_primitive(const LitPrimitive& in) {
        const common::MeshInstance& instance = scene_.loaded.scene.instance[in.instance];
        tinygltf::Primitive primitive;
        primitive.mode = TINYGLTF_MODE_TRIANGLES;
        primitive.material = material_of(instance.material, in.both_faces);
        primitive.attributes["POSITION"] = gltf_writing::add_positions(in.position, model_);
        add_column(primitive, "NORMAL", in.normal);
        add_column(primitive, "TANGENT", in.tangent);
        for (std::size_t i = 0; i < most_texcoord_sets; ++i)
            add_column(primitive, fmt::format("TEXCOORD_{}", gltf_set(static_cast<int>(i))), in.texcoord[i]);
        add_column(primitive, "TEXCOORD_1", in.light_texcoord);
        // Sets have to be numbered from 0 on.
        if (in.texcoord[0].empty()) primitive.attributes["TEXCOORD_0"] = primitive.attributes["TEXCOORD_1"];
        add_column(primitive, "_LIGHTMAP_RECT", in.light_rectangle);
        add_column(primitive, "COLOR_0", in.color);
        primitive.indices = gltf_writing::add_indices(in.index, model_);
        tinygltf::Mesh mesh;
        mesh.name = instance.name;
        mesh.primitives.push_back(std::move(primitive));
        add_node(instance.name + (in.back ? " (back)" : "")).mesh = static_cast<int>(model_.meshes.size());
        model_.meshes.push_back(std::move(mesh));
    }

    /// One that is shown from both sides is a copy.
    int material_of(std::uint32_t material, bool both_faces) {
        if (!both_faces) return static_cast<int>(material);
        const auto [found, is_new] =
            both_faces_.try_emplace(material, static_cast<int>(model_.materials.size()));
        if (is_new) {
            tinygltf::Material copy = model_.materials[material];
            copy.doubleSided = true;
            model_.materials.push_back(std::move(copy));
        }
        return found->second;
    }

    // --- the maps

    /// A value for each pixel that shows a texel, zero elsewhere.
    template <class T, class Of>
    [[nodiscard]] std::vector<T> picture_of(const T& zero, Of of) const {
        std::vector<T> picture(scene_.atlas.pixel_count(), zero);
        for (std::size_t p = 0; p < picture.size(); ++p)
            if (scene_.atlas.shown[p] != shlm::no_texel) picture[p] = of(std::size_t{scene_.atlas.shown[p]});
        return picture;
    }

    [[nodiscard]] std::vector<shlm::half> layers_of(const StoredTexels& texels) const {
        const std::size_t pixels = scene_.atlas.pixel_count(), layers = (texels.numbers + 3) / 4;
        std::vector<shlm::half> values(4 * pixels * layers, shlm::half(0.0f));
        for (std::size_t p = 0; p < pixels; ++p) {
            if (scene_.atlas.shown[p] == shlm::no_texel) continue;
            for (std::size_t i = 0; i < texels.numbers; ++i)
                values[4 * (i / 4 * pixels + p) + i % 4] =
                    texels.number[scene_.atlas.shown[p] * texels.numbers + i];
        }
        return values;
    }

    void add_maps() {
        const StoredTexels& first = scene_.maps.front().texels;
        // What is covered is what the exact filter weighs: a gutter's pixels only show a neighbour's light.
        std::vector<V4f> faces = picture_of(V4f(0.0f), [&](std::size_t texel) {
            const Vec3& n = first.face[texel].normal;
            return V4f(n.x, n.y, n.z, 0);
        });
        std::vector<float> hits(faces.size(), 0);
        scene_.atlas.places.for_each([&](std::size_t texel, std::size_t pixel) {
            faces[pixel].w = first.face[texel].area;
            hits[pixel] = static_cast<float>(first.hits[texel]);
        });
        nlohmann::ordered_json maps = nlohmann::ordered_json::array();
        for (const ExportedMap& map : scene_.maps) {
            nlohmann::ordered_json entry = description_of(map);
            const std::vector<shlm::half> layers = layers_of(map.texels);
            entry["bufferView"] = add_view(std::span(layers));
            entry["layers"] = (map.texels.numbers + 3) / 4;
            maps.push_back(std::move(entry));
        }
        const Imath::V3d& origin = scene_.loaded.scene.origin;
        nlohmann::ordered_json extension = {{"scene", scene_.run.scene},
                                            {"fingerprint", scene_.run.fingerprint},
                                            {"origin", {origin.x, origin.y, origin.z}},
                                            {"seed", scene_.run.seed},
                                            {"hits", scene_.run.hits},
                                            {"atlas", description_of(scene_.atlas)},
                                            {"faces", add_view(std::span<const V4f>(faces))},
                                            {"hits_of_texels", add_view(std::span<const float>(hits))},
                                            {"maps", std::move(maps)}};
        model_.extensions[lightmap_extension] = to_value(extension);
        gltf_writing::use_extension(model_, lightmap_extension);
    }

    const LitScene& scene_;
    tinygltf::Model model_;
    std::map<std::uint32_t, int> both_faces_;
    float intensity_ = 0;
};

}  // namespace

std::string lit_glb(const LitScene& scene) {
    return GlbBuilder(scene).bytes();
}

}  // namespace bench
