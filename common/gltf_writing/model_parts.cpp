#include "common/gltf_writing/model_parts.h"

#include <Imath/ImathBox.h>
#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "common/core/input_error.h"

namespace common::gltf_writing {

using tinygltf::Value;

std::vector<double> to_doubles(const Vec3& v) {
    return {v.x, v.y, v.z};
}

void use_extension(tinygltf::Model& model, const std::string& name) {
    auto& used = model.extensionsUsed;
    if (std::find(used.begin(), used.end(), name) == used.end()) used.push_back(name);
}

int add_view(std::span<const std::byte> bytes, int target, tinygltf::Model& model) {
    auto& data = model.buffers.front().data;
    data.resize((data.size() + 3) / 4 * 4);
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = data.size();
    view.byteLength = bytes.size();
    view.target = target;
    const auto* first = reinterpret_cast<const unsigned char*>(bytes.data());
    data.insert(data.end(), first, first + bytes.size());
    model.bufferViews.push_back(std::move(view));
    return static_cast<int>(model.bufferViews.size()) - 1;
}

int add_positions(const std::vector<Vec3>& positions, tinygltf::Model& model) {
    const int accessor = add_attribute(positions, model);
    Imath::Box3f bounds;
    for (const Vec3& p : positions) bounds.extendBy(p);
    model.accessors.back().minValues = to_doubles(bounds.min);
    model.accessors.back().maxValues = to_doubles(bounds.max);
    return accessor;
}

int add_indices(const std::vector<std::uint32_t>& indices, tinygltf::Model& model) {
    return add_accessor(indices, TINYGLTF_TYPE_SCALAR, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
                        TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER, model);
}

void set_emission(const Rgb& radiance, tinygltf::Material& material, tinygltf::Model& model) {
    const float strength = max_component(radiance);
    material.emissiveFactor = to_doubles(radiance / strength);
    Value::Object extension;
    extension["emissiveStrength"] = Value(static_cast<double>(strength));
    material.extensions["KHR_materials_emissive_strength"] = Value(std::move(extension));
    use_extension(model, "KHR_materials_emissive_strength");
}

void set_glass(float index_of_refraction, bool has_inside, tinygltf::Material& material,
               tinygltf::Model& model) {
    Value::Object transmission, ior, volume;
    transmission["transmissionFactor"] = Value(1.0);
    ior["ior"] = Value(static_cast<double>(index_of_refraction));
    volume["thicknessFactor"] = Value(1.0);
    material.extensions["KHR_materials_transmission"] = Value(std::move(transmission));
    material.extensions["KHR_materials_ior"] = Value(std::move(ior));
    use_extension(model, "KHR_materials_transmission");
    if (has_inside) {
        material.extensions["KHR_materials_volume"] = Value(std::move(volume));
        use_extension(model, "KHR_materials_volume");
    }
    use_extension(model, "KHR_materials_ior");
}

std::string glb_bytes(const tinygltf::Model& model, const std::string& file) {
    std::ostringstream stream;
    if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, stream, false, true))
        throw InputError(fmt::format("{}: cannot be made into glTF", file));
    return std::move(stream).str();
}

}  // namespace common::gltf_writing
