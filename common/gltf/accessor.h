// Typed reading of accessors, with every range checked. glTF 2.0, sections 3.6.1 and 3.6.2.
#pragma once

#include <tiny_gltf.h>

#include <cstdint>
#include <span>
#include <vector>

namespace common::gltf {

/// The bytes of a buffer view. Throws InputError where it is not inside its buffer.
[[nodiscard]] std::span<const unsigned char> view_bytes(const tinygltf::Model& model, int buffer_view);

/// All components of an accessor of `components` (2 to 4) numbers per element, one element after the other;
/// normalized integers become [0, 1] or [-1, 1], other integers their value. Sparse elements are put in, and
/// an accessor without a buffer view starts from zeros. Throws InputError for another shape, for 32-bit
/// integers and for data outside the buffer view.
[[nodiscard]] std::vector<float> read_vectors(const tinygltf::Model& model, int accessor, int components);

/// An accessor of unsigned integers. Throws InputError as above.
[[nodiscard]] std::vector<std::uint32_t> read_indices(const tinygltf::Model& model, int accessor);

}  // namespace common::gltf
