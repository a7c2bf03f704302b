// Parts of a glTF file that is to be written, as tinygltf's model has them.
#pragma once

#include <tiny_gltf.h>

#include <span>
#include <string>
#include <vector>

#include "common/core/vector.h"

namespace common::gltf_writing {

[[nodiscard]] std::vector<double> to_doubles(const Vec3& v);

/// Lists an extension as used, once.
void use_extension(tinygltf::Model& model, const std::string& name);

/// Appends bytes to the one buffer, aligned to 4, and returns the index of their view. `target`: 0, or what
/// glTF says of vertices and indices.
int add_view(std::span<const std::byte> bytes, int target, tinygltf::Model& model);

/// Appends `items` and returns the index of the accessor to them.
template <class T>
int add_accessor(const std::vector<T>& items, int type, int component_type, int target,
                 tinygltf::Model& model) {
    tinygltf::Accessor accessor;
    accessor.bufferView = add_view(std::as_bytes(std::span(items)), target, model);
    accessor.componentType = component_type;
    accessor.type = type;
    accessor.count = items.size();
    model.accessors.push_back(std::move(accessor));
    return static_cast<int>(model.accessors.size()) - 1;
}

/// Appends a column of vertices, vectors of 2, 3 or 4 floats.
template <class T>
int add_attribute(const std::vector<T>& items, tinygltf::Model& model) {
    static_assert(sizeof(T) == 8 || sizeof(T) == 12 || sizeof(T) == 16);
    constexpr int type = sizeof(T) == 8    ? TINYGLTF_TYPE_VEC2
                         : sizeof(T) == 12 ? TINYGLTF_TYPE_VEC3
                                           : TINYGLTF_TYPE_VEC4;
    return add_accessor(items, type, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TARGET_ARRAY_BUFFER, model);
}

/// Appends positions, with the bounds that glTF wants of them.
int add_positions(const std::vector<Vec3>& positions, tinygltf::Model& model);

int add_indices(const std::vector<std::uint32_t>& indices, tinygltf::Model& model);

/// W/(m^2 sr), greater than zero.
void set_emission(const Rgb& radiance, tinygltf::Material& material, tinygltf::Model& model);

/// `has_inside`: the boundary of a body, otherwise a sheet without thickness. How thick a body is matters
/// only where it absorbs light, which this one does not.
void set_glass(float index_of_refraction, bool has_inside, tinygltf::Material& material,
               tinygltf::Model& model);

/// Returns the model as binary glTF. Throws InputError, naming `file`, where tinygltf cannot write it.
[[nodiscard]] std::string glb_bytes(const tinygltf::Model& model, const std::string& file);

}  // namespace common::gltf_writing
