#include "shlm/layout/texel_tree.h"

namespace shlm {
namespace {

template <class Value>
std::vector<Value> of_covered(std::span<const TexelGeometry> texels, Value TexelGeometry::*member) {
    std::vector<Value> values;
    for (const TexelGeometry& texel : texels)
        if (texel.area > 0) values.push_back(texel.*member);
    values.shrink_to_fit();
    return values;
}

}  // namespace

TexelTree::TexelTree(std::span<const TexelGeometry> texels)
    : center_(of_covered(texels, &TexelGeometry::center)),
      piece_(of_covered(texels, &TexelGeometry::piece)),
      index_(center_),
      max_radius_(static_cast<float>(4 * texel_width(texels))) {}

}  // namespace shlm
