#include "shlm/texel_layout.h"

#include <fmt/format.h>

#include "common/core/input_error.h"

namespace shlm {
namespace {

using common::MeshInstance;
using common::Scene;
using common::Vec2;
using common::Vec3;

/// Size in the world of the rectangle that an instance's lightmap coordinates span, as if it were covered all
/// over.
struct WorldRectangle {
    double width = 0, height = 0;
    int faces = 1;
};

/// Mean length in the world of a unit step along u and along v, weighted by area. In double: positions may be
/// 1e18 apart, and lightmap coordinates as near to each other as floats can be.
Imath::V2d mean_stretch(const Scene& scene, const MeshInstance& instance, int set) {
    Imath::V2d sum(0, 0);
    double area = 0;
    for (std::uint32_t t = instance.first_triangle; t < instance.first_triangle + instance.triangle_count;
         ++t) {
        const auto [a, b, c] = scene.triangle[t];
        const auto& uv = scene.texcoord[set];
        const Imath::V2d origin(uv[a]), duv1 = Imath::V2d(uv[b]) - origin, duv2 = Imath::V2d(uv[c]) - origin;
        const Imath::V3d corner(scene.position[a]), edge1 = Imath::V3d(scene.position[b]) - corner,
                                                    edge2 = Imath::V3d(scene.position[c]) - corner;
        const double determinant = duv1.x * duv2.y - duv1.y * duv2.x;
        if (determinant == 0) continue;
        const double weight = common::triangle_area(scene, t);
        sum += Imath::V2d((edge1 * duv2.y - edge2 * duv1.y).length(),
                          (edge2 * duv1.x - edge1 * duv2.x).length()) *
               (weight / std::abs(determinant));
        area += weight;
    }
    return area > 0 ? sum / area : Imath::V2d(1, 1);
}

WorldRectangle world_rectangle(const Scene& scene, const MeshInstance& instance, const LightmapUv& uv) {
    const Imath::V2d stretch = mean_stretch(scene, instance, uv.texcoord_set);
    const Imath::V2d size(uv.bounds.size());
    const double aspect = (stretch.x * size.x) / (stretch.y * size.y);
    const double area = uv.area / uv.covered_fraction;
    return {std::sqrt(area * aspect), std::sqrt(area / aspect),
            scene.material[instance.material].double_sided ? 2 : 1};
}

std::uint32_t texels_along(double length, double texel_size) {
    constexpr double most = 32768;  // keeps texel indices within a region exact in float
    return static_cast<std::uint32_t>(std::clamp(std::round(length / texel_size), 1.0, most));
}

double texels_at_size(std::span<const WorldRectangle> rectangles, double texel_size) {
    double count = 0;
    for (const WorldRectangle& r : rectangles)
        if (r.width > 0)
            count += static_cast<double>(r.faces) * texels_along(r.width, texel_size) *
                     texels_along(r.height, texel_size);
    return count;
}

/// The smallest texel with which no more than `wanted` are needed, by bisection.
double texel_size_for(std::span<const WorldRectangle> rectangles, std::size_t wanted) {
    double area = 0;
    for (const WorldRectangle& r : rectangles) area += r.faces * r.width * r.height;
    const double guess = std::sqrt(area / static_cast<double>(wanted));
    double low = guess / 16, high = guess * 16;
    for (int step = 0; step < 60; ++step) {
        const double middle = 0.5 * (low + high);
        (texels_at_size(rectangles, middle) > static_cast<double>(wanted) ? low : high) = middle;
    }
    return high;
}

TriangleTexels place_triangle(const Scene& scene, std::uint32_t triangle, const LightmapUv& uv,
                              const TexelRegion& region) {
    TriangleTexels placed;
    placed.normal = scene.geometric_normal[triangle];
    const auto [a, b, c] = scene.triangle[triangle];
    const auto& texcoord = scene.texcoord[uv.texcoord_set];
    const auto in_texels = [&](const Vec2& at) {
        return (at - uv.bounds.min) / uv.bounds.size() *
               Vec2(static_cast<float>(region.width), static_cast<float>(region.height));
    };
    placed.corner = in_texels(texcoord[a]);
    placed.edge_u = in_texels(texcoord[b]) - placed.corner;
    placed.edge_v = in_texels(texcoord[c]) - placed.corner;
    // A triangle whose coordinates span no area has no place in the map: its flux would be divided by
    // nothing.
    if (placed.edge_u.x * placed.edge_v.y == placed.edge_u.y * placed.edge_v.x) return placed;
    placed.first_texel = region.first_texel;
    placed.width = region.width;
    placed.height = region.height;
    placed.both_faces = region.both_faces;
    return placed;
}

}  // namespace

TexelLayout::TexelLayout(const Scene& scene, std::span<const LightmapUv> uv, std::size_t wanted_texels)
    : regions_(scene.instance.size()), triangles_(scene.triangle.size()) {
    std::vector<WorldRectangle> rectangles(scene.instance.size());
    for (std::size_t i = 0; i < rectangles.size(); ++i)
        if (uv[i].texcoord_set >= 0) rectangles[i] = world_rectangle(scene, scene.instance[i], uv[i]);
    const double texel_size = texel_size_for(rectangles, wanted_texels);
    if (texels_at_size(rectangles, texel_size) >= no_texel)
        throw common::InputError(fmt::format("a light map holds fewer than {} texels; {} were asked for",
                                             no_texel, wanted_texels));

    for (std::size_t i = 0; i < regions_.size(); ++i) {
        if (uv[i].texcoord_set < 0) continue;
        TexelRegion& region = regions_[i];
        region.first_texel = static_cast<std::uint32_t>(texel_count_);
        region.width = texels_along(rectangles[i].width, texel_size);
        region.height = texels_along(rectangles[i].height, texel_size);
        region.both_faces = rectangles[i].faces == 2;
        texel_count_ += std::size_t{region.texels_per_face()} * rectangles[i].faces;

        const MeshInstance& instance = scene.instance[i];
        for (std::uint32_t t = instance.first_triangle; t < instance.first_triangle + instance.triangle_count;
             ++t)
            triangles_[t] = place_triangle(scene, t, uv[i], region);
    }
}

}  // namespace shlm
