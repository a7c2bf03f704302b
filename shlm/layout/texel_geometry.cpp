#include "shlm/layout/texel_geometry.h"

#include <Imath/ImathVec.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>

namespace shlm {
namespace {

using common::Scene;
using common::Vec3;
using Point = Imath::V2d;  // double: differences of nearly equal lightmap positions decide the areas

/// Convex polygon. A triangle cut by four half planes has at most seven corners.
struct Polygon {
    std::array<Point, 8> corner;
    int count = 0;

    void push(const Point& p) { corner[count++] = p; }
};

/// Returns the part of `polygon` where sign * (p[axis] - limit) >= 0 (Sutherland and Hodgman 1974).
Polygon clip(const Polygon& polygon, int axis, double limit, double sign) {
    Polygon kept;
    for (int i = 0; i < polygon.count; ++i) {
        const Point& a = polygon.corner[i];
        const Point& b = polygon.corner[(i + 1) % polygon.count];
        const double da = sign * (a[axis] - limit), db = sign * (b[axis] - limit);
        if (da >= 0) kept.push(a);
        if ((da > 0 && db < 0) || (da < 0 && db > 0)) kept.push(a + (b - a) * (da / (da - db)));
    }
    return kept;
}

/// Area, and centroid times area, both signed by orientation.
struct Moments {
    double area = 0;
    Point first{0, 0};
};

Moments moments(const Polygon& polygon) {
    Moments m;
    for (int i = 1; i + 1 < polygon.count; ++i) {
        const Point& o = polygon.corner[0];
        const Point a = polygon.corner[i] - o, b = polygon.corner[i + 1] - o;
        const double area = 0.5 * (a.x * b.y - a.y * b.x);
        m.area += area;
        m.first += (o + (a + b) / 3) * area;
    }
    return m;
}

/// Sums of one texel while triangles are added.
struct GeometrySums {
    double area = 0;
    Imath::V3d center{0, 0, 0};  ///< times area
    Imath::V3d normal{0, 0, 0};  ///< times area
    std::uint32_t piece = 0;
    double piece_lead = 0;  ///< area of `piece` less the area of others counted against it

    /// Counts the area of a piece against that of others, so that a piece with more than half of the area
    /// remains (Boyer and Moore, "MJRTY", 1991).
    void count(std::uint32_t of, double part) {
        if (of == piece) {
            piece_lead += part;
        } else if ((piece_lead -= part) < 0) {
            piece = of;
            piece_lead = -piece_lead;
        }
    }
};

/// Adds the parts of one triangle, which belongs to `piece`, to the texels of its region's front.
void add_triangle(const Scene& scene, std::uint32_t index, std::uint32_t piece, const TriangleTexels& placed,
                  std::span<GeometrySums> texels) {
    const Point corner(placed.corner), edge_u(placed.edge_u), edge_v(placed.edge_v);
    Polygon triangle;
    triangle.push(corner);
    triangle.push(corner + edge_u);
    triangle.push(corner + edge_v);
    const double determinant = edge_u.x * edge_v.y - edge_u.y * edge_v.x;
    const double world_area_per_map_area = common::triangle_area(scene, index) / (0.5 * determinant);

    const auto [ia, ib, ic] = scene.triangle[index];
    const Imath::V3d a(scene.position[ia]), ab(Imath::V3d(scene.position[ib]) - a),
        ac(Imath::V3d(scene.position[ic]) - a);
    const auto to_world = [&](const Point& p) {
        const Point d = p - corner;
        return a + ab * ((d.x * edge_v.y - d.y * edge_v.x) / determinant) +
               ac * ((edge_u.x * d.y - edge_u.y * d.x) / determinant);
    };

    const auto range = [](const Polygon& p, int axis, std::uint32_t size) {
        double low = p.corner[0][axis], high = low;
        for (int i = 1; i < p.count; ++i) {
            low = std::min(low, p.corner[i][axis]);
            high = std::max(high, p.corner[i][axis]);
        }
        const int last = static_cast<int>(size) - 1;
        return std::pair(std::clamp(static_cast<int>(low), 0, last),
                         std::clamp(static_cast<int>(high), 0, last));
    };
    // Positions on the region's far border belong to its last row or column, as in texel_at.
    const auto upper = [](int i, std::uint32_t size) {
        return i + 1 == static_cast<int>(size) ? 1e30 : i + 1.0;
    };
    const auto lower = [](int i) { return i == 0 ? -1e30 : i; };

    const auto [y0, y1] = range(triangle, 1, placed.height);
    for (int y = y0; y <= y1; ++y) {
        const Polygon row = clip(clip(triangle, 1, lower(y), 1), 1, upper(y, placed.height), -1);
        if (row.count < 3) continue;
        const auto [x0, x1] = range(row, 0, placed.width);
        for (int x = x0; x <= x1; ++x) {
            const Moments m = moments(clip(clip(row, 0, lower(x), 1), 0, upper(x, placed.width), -1));
            if (m.area == 0) continue;
            const double area = m.area * world_area_per_map_area;
            GeometrySums& sums = texels[static_cast<std::size_t>(y) * placed.width + x];
            sums.area += area;
            sums.center += to_world(m.first / m.area) * area;
            sums.normal += Imath::V3d(placed.normal) * area;
            sums.count(piece, area);
        }
    }
}

TexelGeometry finished(const GeometrySums& sums) {
    if (!(sums.area > 0)) return {};
    const Vec3 normal(sums.normal);
    return {static_cast<float>(sums.area), Vec3(sums.center / sums.area),
            normal.length2() > 0 ? normal.normalized() : Vec3(0, 0, 0), sums.piece};
}

/// Triangles that have texels, region by region.
std::vector<std::uint32_t> by_region(const Scene& scene, const TexelLayout& layout) {
    std::vector<std::uint32_t> triangles;
    for (std::uint32_t t = 0; t < scene.triangle.size(); ++t)
        if (layout.triangle(t).width > 0) triangles.push_back(t);
    std::stable_sort(triangles.begin(), triangles.end(), [&](std::uint32_t a, std::uint32_t b) {
        return layout.triangle(a).first_texel < layout.triangle(b).first_texel;
    });
    return triangles;
}

}  // namespace

std::vector<TexelGeometry> texel_geometry(const Scene& scene, const TexelLayout& layout,
                                          const common::SurfacePieces& pieces) {
    const std::vector<std::uint32_t> triangles = by_region(scene, layout);
    std::vector<TexelGeometry> geometry(layout.texel_count());
    tbb::parallel_for(std::size_t{0}, layout.regions().size(), [&](std::size_t i) {
        const TexelRegion& region = layout.regions()[i];
        std::vector<GeometrySums> sums(region.texels_per_face());
        auto triangle = std::lower_bound(triangles.begin(), triangles.end(), region.first_texel,
                                         [&](std::uint32_t t, std::uint32_t first_texel) {
                                             return layout.triangle(t).first_texel < first_texel;
                                         });
        for (; triangle != triangles.end(); ++triangle) {
            const TriangleTexels& placed = layout.triangle(*triangle);
            if (placed.first_texel != region.first_texel) break;
            add_triangle(scene, *triangle, pieces.of_triangle(*triangle), placed, sums);
        }
        for (std::size_t k = 0; k < sums.size(); ++k) {
            TexelGeometry& front = geometry[region.first_texel + k];
            front = finished(sums[k]);
            if (region.both_faces)
                geometry[region.first_texel + sums.size() + k] = {front.area, front.center, -front.normal,
                                                                  front.piece};
        }
    });
    return geometry;
}

}  // namespace shlm
