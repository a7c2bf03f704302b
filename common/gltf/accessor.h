// Typed reading of accessors, with every range checked. glTF 2.0, sections 3.6.1 and 3.6.2.
#pragma once

#include <tiny_gltf.h>

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace common::gltf {

/// Returns the bytes of a buffer view. Throws InputError if it is not inside its buffer.
[[nodiscard]] std::span<const unsigned char> view_bytes(const tinygltf::Model& model, int buffer_view);

/// Elements whose range has been checked.
struct Elements {
    const unsigned char* first;
    std::size_t stride;

    [[nodiscard]] const unsigned char* operator[](std::size_t i) const { return first + i * stride; }
};

/// The bytes of an accessor's elements, with every range checked. Its size does not grow with the accessor,
/// except with the sparse part.
struct ElementSource {
    std::size_t count = 0;
    std::optional<Elements> dense;
    std::optional<Elements> sparse;
    /// Each element that the sparse part replaces, with its index in that part, sorted.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> replaced;

    /// Returns the bytes of element `i`, or null if neither part has it: the element is then zero.
    [[nodiscard]] const unsigned char* operator[](std::size_t i) const;
};

/// Reads the accessors of a model, only single elements if not all are needed. Caches what it finds out about
/// an accessor, as many primitives can share one.
class AccessorReader {
  public:
    explicit AccessorReader(const tinygltf::Model& model) : model_(model) {}

    /// Returns the number of elements of an accessor with `components` numbers per element (2 to 4, or 16 for
    /// MAT4). Throws InputError for another shape, for 32-bit integers and for data outside the buffer view.
    [[nodiscard]] std::size_t count(int accessor, int components);

    /// Returns the numbers of `elements`, which are below count(), one element after the other. Normalized
    /// integers become [0, 1] or [-1, 1]; other integers keep their value. Sparse elements are applied, and
    /// an accessor without a buffer view starts from zeros. Throws InputError as count() does.
    [[nodiscard]] std::vector<float> read_vectors(int accessor, int components,
                                                  std::span<const std::uint32_t> elements);

    /// Returns all elements of an accessor of unsigned integers. Throws InputError as above.
    [[nodiscard]] std::vector<std::uint32_t> read_indices(int accessor);

  private:
    [[nodiscard]] const ElementSource& source(int accessor, std::size_t element_size);
    [[nodiscard]] const ElementSource& vectors(int accessor, int components);

    const tinygltf::Model& model_;
    std::map<int, ElementSource> sources_;
};

}  // namespace common::gltf
