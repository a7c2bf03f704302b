// The scene's triangles as primitives of glTF, with coordinates in the light atlas.
#pragma once

#include <Imath/ImathVec.h>

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "bench/export/light_atlas.h"
#include "common/scene/surface_point.h"
#include "shlm/layout/texel_places.h"

namespace bench {

/// Sets of texture coordinates that a primitive may have beside the light map's: the first for base colour,
/// the second for the normal map, the third for emission, where these differ.
inline constexpr std::size_t most_texcoord_sets = 3;

/// Which of a primitive's sets a material's texture reads; its transform is in them already.
struct TexcoordUse {
    std::vector<common::TextureUse> set;              ///< the different ones, at most most_texcoord_sets
    int base_color = -1, normal = -1, emissive = -1;  ///< -1: no such texture
};

[[nodiscard]] TexcoordUse texcoord_use(const common::Material& material);

/// The front or the back of a mesh instance. World space; one entry per vertex in every column that is not
/// empty. A back has its triangles, normals and tangents turned round, so that it is a front like others.
struct LitPrimitive {
    std::uint32_t instance = 0;
    bool back = false;
    bool lit = false;         ///< whether any triangle has texels
    bool both_faces = false;  ///< shown from both sides: of surfaces without texels alone

    std::vector<common::Vec3> position, normal;
    std::vector<Imath::V4f> tangent;  ///< glTF's TANGENT; empty without a normal map
    std::array<std::vector<common::Vec2>, most_texcoord_sets> texcoord;
    std::vector<common::Vec2> light_texcoord;  ///< in [0, 1] of the atlas, v downwards
    /// Left, top, width, height of the rectangle in the atlas, pixels; zero for triangles without texels.
    std::vector<Imath::V4f> light_rectangle;
    std::vector<Imath::V4f> color;  ///< linear, with alpha; empty where the scene has none
    std::vector<std::uint32_t> index;
    std::vector<std::uint32_t> triangle;  ///< of the scene, for each three indices
};

/// A point of a primitive: barycentric coordinates as in common::SurfaceId, of its own triangle's corners.
struct PrimitivePoint {
    std::uint32_t primitive, triangle;
    float u, v;
};

/// Finds surface points among primitives.
class PrimitivePoints {
  public:
    explicit PrimitivePoints(std::span<const LitPrimitive> primitives);

    /// None where no primitive has that side of the triangle.
    [[nodiscard]] std::optional<PrimitivePoint> find(const common::SurfacePoint& point) const;

  private:
    std::map<std::pair<std::uint32_t, bool>, std::pair<std::uint32_t, std::uint32_t>> place_;
};

/// Vertices are doubled where charts or tangents end. `layout`: that which `atlas` is of.
[[nodiscard]] std::vector<LitPrimitive> lit_primitives(const common::Scene& scene,
                                                       const shlm::TexelLayout& layout,
                                                       const LightAtlas& atlas);

}  // namespace bench
