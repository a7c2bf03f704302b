#include "common/gltf/accessor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>

#include "common/core/input_error.h"

namespace common::gltf {
namespace {

/// Limit for accessors without a buffer view, as no data bound the count that a file can ask for.
constexpr std::size_t most_elements_without_data = std::size_t{1} << 24;

/// The layout of elements in the bytes of a buffer view.
struct Layout {
    std::uint64_t offset;
    std::uint64_t stride;
    std::uint64_t element_size;
    std::uint64_t count;
};

Elements checked_elements(const tinygltf::Model& model, int buffer_view, const Layout& layout,
                          const std::string& where) {
    const std::span<const unsigned char> bytes = view_bytes(model, buffer_view);
    // Divided rather than multiplied, so that nothing can overflow.
    const bool fits =
        layout.offset <= bytes.size() && layout.element_size <= bytes.size() - layout.offset &&
        layout.count - 1 <= (bytes.size() - layout.offset - layout.element_size) / layout.stride;
    if (!fits) throw InputError(fmt::format("{} goes beyond the end of bufferViews/{}", where, buffer_view));
    return {bytes.data() + layout.offset, layout.stride};
}

template <class T>
T load(const unsigned char* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

template <class Integer>
float integer_component(const unsigned char* bytes, bool normalized) {
    const auto value = static_cast<float>(load<Integer>(bytes));
    // The smallest signed integer would give a little less than -1 (glTF 2.0, section 3.6.2.2).
    return normalized ? std::max(value / static_cast<float>(std::numeric_limits<Integer>::max()), -1.0f)
                      : value;
}

float component(const unsigned char* bytes, int type, bool normalized) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return integer_component<std::int8_t>(bytes, normalized);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return integer_component<std::uint8_t>(bytes, normalized);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return integer_component<std::int16_t>(bytes, normalized);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return integer_component<std::uint16_t>(bytes, normalized);
        default:
            return load<float>(bytes);
    }
}

int accessor_type(int components) {
    // tinygltf's numbers for VEC2, VEC3 and VEC4 are 2, 3 and 4.
    return components == 16 ? TINYGLTF_TYPE_MAT4 : components;
}

std::string shape_name(int components) {
    return components == 16 ? "MAT4" : fmt::format("VEC{}", components);
}

bool is_vector_component(int type) {
    return (type >= TINYGLTF_COMPONENT_TYPE_BYTE && type <= TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) ||
           type == TINYGLTF_COMPONENT_TYPE_FLOAT;
}

bool is_index(int type) {
    return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

std::uint32_t index_at(const unsigned char* bytes, int type) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return load<std::uint8_t>(bytes);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return load<std::uint16_t>(bytes);
        default:
            return load<std::uint32_t>(bytes);
    }
}

std::size_t component_size(int type) {
    return static_cast<std::size_t>(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(type)));
}

void check_count(const tinygltf::Accessor& accessor, const std::string& where) {
    if (accessor.count == 0) throw InputError(fmt::format("{} is empty", where));
    if (accessor.count > std::numeric_limits<std::uint32_t>::max())
        throw InputError(fmt::format("{} has more elements than 32 bits can count", where));
    if (accessor.bufferView < 0 && accessor.count > most_elements_without_data)
        throw InputError(fmt::format("{} has {} elements, but no data", where, accessor.count));
}

/// The elements in the accessor's own buffer view.
Elements dense_elements(const tinygltf::Model& model, const tinygltf::Accessor& accessor,
                        std::size_t element_size, const std::string& where) {
    const int stride = accessor.ByteStride(model.bufferViews[static_cast<std::size_t>(accessor.bufferView)]);
    if (stride < static_cast<int>(element_size))
        throw InputError(fmt::format("{} has a byteStride that does not suit its type", where));
    const Layout layout{accessor.byteOffset, static_cast<std::uint64_t>(stride), element_size,
                        accessor.count};
    return checked_elements(model, accessor.bufferView, layout, where);
}

/// Returns the elements that the sparse part replaces, each with its index in that part.
std::vector<std::pair<std::uint32_t, std::uint32_t>> sparse_places(const tinygltf::Model& model,
                                                                   const tinygltf::Accessor& accessor,
                                                                   const std::string& where) {
    const auto& sparse = accessor.sparse;
    const int type = sparse.indices.componentType;
    if (!is_index(type))
        throw InputError(fmt::format("{} has sparse indices of a type that is not allowed", where));
    if (sparse.count <= 0) throw InputError(fmt::format("{} is sparse without elements", where));
    const std::size_t size = component_size(type);
    const Layout layout{static_cast<std::uint64_t>(sparse.indices.byteOffset), size, size,
                        static_cast<std::uint64_t>(sparse.count)};
    const Elements elements =
        checked_elements(model, sparse.indices.bufferView, layout, where + "/sparse/indices");

    std::vector<std::pair<std::uint32_t, std::uint32_t>> places(static_cast<std::size_t>(sparse.count));
    for (std::uint32_t i = 0; i < places.size(); ++i) {
        places[i] = {index_at(elements[i], type), i};
        if (places[i].first >= accessor.count)
            throw InputError(fmt::format("{} has a sparse index beyond its end", where));
    }
    if (!std::is_sorted(places.begin(), places.end())) std::sort(places.begin(), places.end());
    return places;
}

ElementSource checked_source(const tinygltf::Model& model, const tinygltf::Accessor& accessor,
                             std::size_t element_size, const std::string& where) {
    check_count(accessor, where);
    ElementSource source;
    source.count = accessor.count;
    if (accessor.bufferView >= 0) source.dense = dense_elements(model, accessor, element_size, where);
    if (accessor.sparse.isSparse) {
        source.replaced = sparse_places(model, accessor, where);
        const Layout layout{static_cast<std::uint64_t>(accessor.sparse.values.byteOffset), element_size,
                            element_size, source.replaced.size()};
        source.sparse =
            checked_elements(model, accessor.sparse.values.bufferView, layout, where + "/sparse/values");
    }
    return source;
}

}  // namespace

std::span<const unsigned char> view_bytes(const tinygltf::Model& model, int buffer_view) {
    const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(buffer_view)];
    const std::vector<unsigned char>& data = model.buffers[static_cast<std::size_t>(view.buffer)].data;
    if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset)
        throw InputError(fmt::format("bufferViews/{} goes beyond the end of its buffer", buffer_view));
    return {data.data() + view.byteOffset, view.byteLength};
}

const unsigned char* ElementSource::operator[](std::size_t i) const {
    if (!replaced.empty()) {
        // If an element is replaced several times, the last one counts.
        const auto behind =
            std::upper_bound(replaced.begin(), replaced.end(), i,
                             [](std::size_t element, const auto& place) { return element < place.first; });
        if (behind != replaced.begin() && std::prev(behind)->first == i)
            return (*sparse)[std::prev(behind)->second];
    }
    return dense ? (*dense)[i] : nullptr;
}

const ElementSource& AccessorReader::source(int accessor, std::size_t element_size) {
    const auto known = sources_.find(accessor);
    if (known != sources_.end()) return known->second;
    ElementSource checked = checked_source(model_, model_.accessors[static_cast<std::size_t>(accessor)],
                                           element_size, fmt::format("accessors/{}", accessor));
    return sources_.emplace(accessor, std::move(checked)).first->second;
}

const ElementSource& AccessorReader::vectors(int accessor, int components) {
    const tinygltf::Accessor& described = model_.accessors[static_cast<std::size_t>(accessor)];
    if (described.type != accessor_type(components) || !is_vector_component(described.componentType))
        throw InputError(
            fmt::format("accessors/{} is not the {} that its use needs", accessor, shape_name(components)));
    return source(accessor, static_cast<std::size_t>(components) * component_size(described.componentType));
}

std::size_t AccessorReader::count(int accessor, int components) {
    return vectors(accessor, components).count;
}

std::vector<float> AccessorReader::read_vectors(int accessor, int components,
                                                std::span<const std::uint32_t> elements) {
    const ElementSource& source = vectors(accessor, components);
    const tinygltf::Accessor& described = model_.accessors[static_cast<std::size_t>(accessor)];
    const int type = described.componentType;
    const auto width = static_cast<std::size_t>(components);
    const std::size_t size = component_size(type);
    std::vector<float> values(elements.size() * width);
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const unsigned char* bytes = source[elements[i]];
        if (bytes == nullptr) continue;
        for (std::size_t c = 0; c < width; ++c)
            values[i * width + c] = component(bytes + c * size, type, described.normalized);
    }
    return values;
}

std::vector<std::uint32_t> AccessorReader::read_indices(int accessor) {
    const tinygltf::Accessor& described = model_.accessors[static_cast<std::size_t>(accessor)];
    const int type = described.componentType;
    if (described.type != TINYGLTF_TYPE_SCALAR || !is_index(type) || described.normalized)
        throw InputError(
            fmt::format("accessors/{} is not the list of unsigned integers that indices need", accessor));

    const ElementSource& elements = source(accessor, component_size(type));
    std::vector<std::uint32_t> indices(elements.count);
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const unsigned char* bytes = elements[i];
        if (bytes != nullptr) indices[i] = index_at(bytes, type);
    }
    return indices;
}

}  // namespace common::gltf
