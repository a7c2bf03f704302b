#include "common/gltf/tangents.h"

#include <Imath/ImathFun.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <limits>
#include <numeric>
#include <tuple>

namespace common::gltf {
namespace {

using Imath::V3d;

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// Less than the resolution of an 8-bit normal map near its middle, which is half a degree.
constexpr double largest_difference = 0.1 * 3.14159265358979 / 180;  // radians

/// The corners of a primitive's triangles. Corner i of triangle t has the index 3 t + i.
class Corners {
  public:
    Corners(const Attributes& attributes, std::span<const Vec2> texcoord,
            std::span<const TriangleVertices> triangles)
        : attributes_(attributes), texcoord_(texcoord), triangles_(triangles) {
        if (!attributes.normal.empty()) return;
        for (const auto& [a, b, c] : triangles) {
            const Vec3 &from = attributes.position[a], &to_b = attributes.position[b],
                       &to_c = attributes.position[c];
            flat_normal_.push_back(Vec3((V3d(to_b) - V3d(from)).cross(V3d(to_c) - V3d(from)).normalized()));
        }
    }

    [[nodiscard]] std::size_t count() const { return 3 * triangles_.size(); }
    [[nodiscard]] const Vec3& position(std::size_t corner) const {
        return attributes_.position[vertex(corner)];
    }
    [[nodiscard]] const Vec3& normal(std::size_t corner) const {
        return flat_normal_.empty() ? attributes_.normal[vertex(corner)] : flat_normal_[corner / 3];
    }
    [[nodiscard]] const Vec2& texcoord(std::size_t corner) const { return texcoord_[vertex(corner)]; }

    /// Returns whether two corners share a position. Such a triangle does not affect its surroundings.
    [[nodiscard]] bool is_degenerate(std::size_t triangle) const {
        const Vec3 &a = position(3 * triangle), &b = position(3 * triangle + 1),
                   &c = position(3 * triangle + 2);
        return a == b || b == c || c == a;
    }

    /// Returns a number for each corner, equal for equal position, normal and texture coordinates.
    [[nodiscard]] std::vector<std::uint32_t> welded() const {
        const auto key = [&](std::uint32_t corner) {
            const Vec3 &p = position(corner), &n = normal(corner);
            const Vec2& uv = texcoord(corner);
            return std::tuple(p.x, p.y, p.z, n.x, n.y, n.z, uv.x, uv.y);
        };
        std::vector<std::uint32_t> order(count());
        std::iota(order.begin(), order.end(), 0u);
        std::sort(order.begin(), order.end(),
                  [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
        std::vector<std::uint32_t> number(count());
        std::uint32_t next = 0;
        for (std::size_t i = 0; i < order.size(); ++i) {
            if (i > 0 && key(order[i]) != key(order[i - 1])) ++next;
            number[order[i]] = next;
        }
        return number;
    }

  private:
    [[nodiscard]] std::uint32_t vertex(std::size_t corner) const {
        return triangles_[corner / 3][corner % 3];
    }

    const Attributes& attributes_;
    std::span<const Vec2> texcoord_;
    std::span<const TriangleVertices> triangles_;
    std::vector<Vec3> flat_normal_;  ///< one per triangle, where the file gives no normals
};

/// A triangle's derivative of position by u, and whether its texture is mirrored.
struct Chart {
    V3d along_u{0, 0, 0};      ///< unit; zero where the texture coordinates have no area
    bool is_mirrored = false;  ///< u and v (v down) run clockwise seen from the front

    [[nodiscard]] bool has_area() const { return along_u != V3d(0, 0, 0); }
};

Chart chart_of(const Corners& corners, std::size_t triangle) {
    const std::size_t a = 3 * triangle, b = a + 1, c = a + 2;
    const Imath::V2d uv(corners.texcoord(a)), to_b = Imath::V2d(corners.texcoord(b)) - uv,
                                              to_c = Imath::V2d(corners.texcoord(c)) - uv;
    const V3d edge_b = V3d(corners.position(b)) - V3d(corners.position(a)),
              edge_c = V3d(corners.position(c)) - V3d(corners.position(a));
    const double area = to_b.x * to_c.y - to_b.y * to_c.x;
    const V3d along_u = (edge_b * to_c.y - edge_c * to_b.y) * std::copysign(1.0, area);
    if (area == 0 || corners.is_degenerate(triangle)) return {};
    return {along_u.normalized(), area > 0};
}

/// Returns `v` projected to the plane perpendicular to the unit `normal`, as a unit vector; or zero.
V3d across(const V3d& normal, const V3d& v) {
    return (v - normal * normal.dot(v)).normalized();
}

/// Returns for each corner the triangle on the other side of the edge to the next corner, or none. If more
/// than two triangles meet at an edge, they are paired in their order.
std::vector<std::uint32_t> neighbours(const Corners& corners, const std::vector<std::uint32_t>& welded) {
    struct Edge {
        std::uint32_t low, high, corner;
        bool is_rising;
    };
    std::vector<Edge> edges;
    edges.reserve(welded.size());
    for (std::uint32_t corner = 0; corner < welded.size(); ++corner) {
        const std::uint32_t from = welded[corner], to = welded[corner - corner % 3 + (corner + 1) % 3];
        if (!corners.is_degenerate(corner / 3))
            edges.push_back({std::min(from, to), std::max(from, to), corner, from < to});
    }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
        return std::tie(a.low, a.high, a.corner) < std::tie(b.low, b.high, b.corner);
    });

    std::vector<std::uint32_t> neighbour(welded.size(), none);
    std::deque<const Edge*> waiting;  // all in the same direction along the edge
    const Edge* last = nullptr;
    for (const Edge& edge : edges) {
        if (last != nullptr && (last->low != edge.low || last->high != edge.high)) waiting.clear();
        last = &edge;
        if (waiting.empty() || waiting.front()->is_rising == edge.is_rising) {
            waiting.push_back(&edge);
        } else {
            neighbour[edge.corner] = waiting.front()->corner / 3;
            neighbour[waiting.front()->corner] = edge.corner / 3;
            waiting.pop_front();
        }
    }
    return neighbour;
}

/// Finds the triangles around each vertex that share a tangent.
class Grouping {
  public:
    Grouping(const Corners& corners, const std::vector<Chart>& charts)
        : charts_(charts),
          welded_(corners.welded()),
          neighbour_(neighbours(corners, welded_)),
          sense_(charts.size(), unknown),
          group_of_(corners.count(), none) {
        for (std::size_t t = 0; t < charts.size(); ++t) {
            if (charts[t].has_area()) sense_[t] = charts[t].is_mirrored ? mirrored : upright;
        }
    }

    /// Calls `finish(corners, is_mirrored)` for each group.
    template <class Finish>
    void for_each(const Finish& finish) {
        for (std::uint32_t corner = 0; corner < group_of_.size(); ++corner) {
            const Chart& chart = charts_[corner / 3];
            if (group_of_[corner] != none || !chart.has_area()) continue;
            collect(corner);
            finish(members_, chart.is_mirrored);
            ++groups_;
        }
    }

  private:
    enum Sense : std::uint8_t { unknown, upright, mirrored };

    /// Collects in members_ all corners that can be reached from `first` over edges at its vertex.
    void collect(std::uint32_t first) {
        const Sense sense = sense_[first / 3];
        members_.clear();
        std::vector<std::uint32_t>& open = open_;
        open.assign(1, first);
        while (!open.empty()) {
            const std::uint32_t corner = open.back();
            open.pop_back();
            if (group_of_[corner] != none) continue;
            const std::uint32_t triangle = corner / 3, before = 3 * triangle + (corner + 2) % 3;
            // A triangle without area in texture space joins the first group that reaches it.
            if (sense_[triangle] == unknown) sense_[triangle] = sense;
            if (sense_[triangle] != sense) continue;
            group_of_[corner] = groups_;
            members_.push_back(corner);
            for (const std::uint32_t edge : {before, corner}) {
                if (neighbour_[edge] != none) open_corner(neighbour_[edge], welded_[corner]);
            }
        }
    }

    void open_corner(std::uint32_t triangle, std::uint32_t vertex) {
        for (std::uint32_t corner = 3 * triangle; corner < 3 * triangle + 3; ++corner) {
            if (welded_[corner] != vertex) continue;
            open_.push_back(corner);
            return;
        }
    }

    const std::vector<Chart>& charts_;
    std::vector<std::uint32_t> welded_;
    std::vector<std::uint32_t> neighbour_;
    std::vector<Sense> sense_;             ///< of each triangle
    std::vector<std::uint32_t> group_of_;  ///< of each corner
    std::uint32_t groups_ = 0;
    std::vector<std::uint32_t> members_, open_;
};

/// Returns the angle in radians between the edges at a corner, projected along the normal.
double angle_at(const Corners& corners, std::uint32_t corner, const V3d& normal) {
    const std::uint32_t first = corner - corner % 3;
    const V3d here(corners.position(corner));
    const V3d to_next = across(normal, V3d(corners.position(first + (corner + 1) % 3)) - here),
              to_last = across(normal, V3d(corners.position(first + (corner + 2) % 3)) - here);
    return std::acos(Imath::clamp(to_next.dot(to_last), -1.0, 1.0));
}

V3d mean_direction(const Corners& corners, const std::vector<Chart>& charts,
                   const std::vector<std::uint32_t>& group) {
    const V3d normal(corners.normal(group.front()));
    V3d sum(0);
    for (const std::uint32_t corner : group) {
        const Chart& chart = charts[corner / 3];
        if (chart.has_area()) sum += across(normal, chart.along_u) * angle_at(corners, corner, normal);
    }
    return sum.normalized();
}

bool differ(const Corners& corners, const std::vector<Chart>& charts, std::uint32_t corner,
            const V3d& direction) {
    const Chart& chart = charts[corner / 3];
    const V3d own = across(V3d(corners.normal(corner)), chart.along_u);
    return (own - direction).length() > largest_difference;
}

}  // namespace

std::vector<CornerTangents> corner_tangents(const Attributes& attributes, std::span<const Vec2> texcoord,
                                            std::span<const TriangleVertices> triangles) {
    const Corners corners(attributes, texcoord, triangles);
    std::vector<Chart> charts(triangles.size());
    for (std::size_t t = 0; t < charts.size(); ++t) charts[t] = chart_of(corners, t);

    std::vector<CornerTangents> tangents(triangles.size());
    bool any_differs = false;
    Grouping(corners, charts).for_each([&](const std::vector<std::uint32_t>& group, bool is_mirrored) {
        const V3d direction = mean_direction(corners, charts, group);
        for (const std::uint32_t corner : group) {
            // glTF's v points down, its bitangent up.
            tangents[corner / 3][corner % 3] = {Vec3(direction), is_mirrored ? -1.0f : 1.0f};
            any_differs = any_differs || differ(corners, charts, corner, direction);
        }
    });
    if (!any_differs) tangents.clear();
    return tangents;
}

}  // namespace common::gltf
