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

/// The bytes of a buffer view. Throws InputError where it is not inside its buffer.
[[nodiscard]] std::span<const unsigned char> view_bytes(const tinygltf::Model& model, int buffer_view);

/// Elements whose range has been checked.
struct Elements {
    const unsigned char* first;
    std::size_t stride;

    [[nodiscard]] const unsigned char* operator[](std::size_t i) const { return first + i * stride; }
};

/// Where an accessor's elements come from, with every range checked. Nothing in it is as large as the
/// accessor, but where the sparse part is.
struct ElementSource {
    std::size_t count = 0;
    std::optional<Elements> dense;
    std::optional<Elements> sparse;
    /// The elements that the sparse part gives, each with its place there, in order of both.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> replaced;

    /// The bytes of element `i`, or null where it is zero: neither part has it.
    [[nodiscard]] const unsigned char* operator[](std::size_t i) const;
};

/// Reads the accessors of a model, one element at a time where not all are needed. Many primitives can share
/// one accessor, so that what has been found out about it is kept.
class AccessorReader {
  public:
    explicit AccessorReader(const tinygltf::Model& model) : model_(model) {}

    /// How many elements an accessor of `components` numbers per element (2 to 4, or 16 for MAT4) has. Throws
    /// InputError for another shape, for 32-bit integers and for data outside the buffer view.
    [[nodiscard]] std::size_t count(int accessor, int components);

    /// The numbers of `elements`, which are below count(), one element after the other; normalized integers
    /// become [0, 1] or [-1, 1], other integers their value. Sparse elements are put in, and an accessor
    /// without a buffer view starts from zeros. Throws InputError as count().
    [[nodiscard]] std::vector<float> read_vectors(int accessor, int components,
                                                  std::span<const std::uint32_t> elements);

    /// All elements of an accessor of unsigned integers. Throws InputError as above.
    [[nodiscard]] std::vector<std::uint32_t> read_indices(int accessor);

  private:
    [[nodiscard]] const ElementSource& source(int accessor, std::size_t element_size);
    [[nodiscard]] const ElementSource& vectors(int accessor, int components);

    const tinygltf::Model& model_;
    std::map<int, ElementSource> sources_;
};

}  // namespace common::gltf
