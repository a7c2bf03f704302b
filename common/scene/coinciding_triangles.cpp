#include "common/scene/coinciding_triangles.h"

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>

#include <limits>
#include <span>
#include <tuple>

#include "common/core/sampling.h"
#include "common/scene/triangle_overlap.h"

namespace common {
namespace {

TriangleCorners corners_of(const Scene& scene, std::uint32_t triangle) {
    const auto [a, b, c] = scene.triangle[triangle];
    return {scene.position[a], scene.position[b], scene.position[c]};
}

// --- normals: only triangles with nearly the same or the opposite normal are compared

/// Cells along a side of each face of a cube map of normals, whose opposite faces are merged. Odd, so that
/// normals along an axis lie in the middle of a cell.
constexpr int cells_a_side = 17;
constexpr std::size_t cell_count = 3 * cells_a_side * cells_a_side;

/// The largest tilt of narrow triangles by rounding, in radians. Triangles with a larger tilt may be missed.
constexpr float largest_tilt = 1.0f / 16;
constexpr float same_plane_cosine = 1 - 2 * largest_tilt * largest_tilt;

/// The cells of one pair of the cube's faces that may contain a triangle's normal or its opposite.
struct CellRange {
    std::uint8_t first_u = 1, last_u = 0, first_v = 1, last_v = 0;
};
using NormalCells = std::array<CellRange, 3>;  ///< indexed by the axis that the faces are perpendicular to

std::uint8_t cell_along(float at) {
    const int cell = static_cast<int>(std::floor((at + 1) * (0.5f * cells_a_side)));
    return static_cast<std::uint8_t>(std::clamp(cell, 0, cells_a_side - 1));
}

std::size_t cell_number(std::size_t axis, std::size_t u, std::size_t v) {
    return (axis * cells_a_side + u) * cells_a_side + v;
}

/// `normal` is unit, with an error of at most `tilt` radians.
NormalCells cells_of(const Vec3& normal, float tilt) {
    NormalCells cells;
    for (int axis = 0; axis < 3; ++axis) {
        const float u = normal[(axis + 1) % 3] / normal[axis], v = normal[(axis + 2) % 3] / normal[axis];
        const float edge = 1 + 3 * tilt;
        if (!(std::abs(u) <= edge && std::abs(v) <= edge)) continue;
        const float reach = tilt * (1 + u * u + v * v);  // on the cube
        cells[static_cast<std::size_t>(axis)] = {cell_along(u - reach), cell_along(u + reach),
                                                 cell_along(v - reach), cell_along(v + reach)};
    }
    return cells;
}

template <class Visit>
void for_each_cell(const NormalCells& cells, Visit visit) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const CellRange& range = cells[axis];
        for (std::size_t u = range.first_u; u <= range.last_u; ++u)
            for (std::size_t v = range.first_v; v <= range.last_v; ++v) visit(cell_number(axis, u, v));
    }
}

/// Returns the first cell that both have; `cell_count` if there is none.
std::size_t first_common_cell(const NormalCells& a, const NormalCells& b) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t u = std::max(a[axis].first_u, b[axis].first_u),
                          v = std::max(a[axis].first_v, b[axis].first_v);
        if (u <= std::min(a[axis].last_u, b[axis].last_u) && v <= std::min(a[axis].last_v, b[axis].last_v))
            return cell_number(axis, u, v);
    }
    return cell_count;
}

std::vector<NormalCells> cells_of_all(const Scene& scene, float tolerance) {
    std::vector<NormalCells> cells(scene.triangle.size());
    tbb::parallel_for(std::size_t{0}, cells.size(), [&](std::size_t t) {
        const double width = narrowest_width(corners_of(scene, static_cast<std::uint32_t>(t)));
        if (width <= tolerance) return;
        // Rounding moves a corner by an eighth of the tolerance of RayScene, and two corners apart by twice
        // that.
        const auto tilt = static_cast<float>(0.25 * double{tolerance} / width);
        cells[t] = cells_of(scene.geometric_normal[t], std::min(tilt, largest_tilt));
    });
    return cells;
}

/// Triangles by the cells of their normals.
struct TrianglesByCell {
    std::vector<std::size_t> first;  ///< one per cell and the end, into `triangle`
    std::vector<std::uint32_t> triangle;

    explicit TrianglesByCell(std::span<const NormalCells> cells) : first(cell_count + 1, 0) {
        for (const NormalCells& of_one : cells) for_each_cell(of_one, [&](std::size_t c) { ++first[c + 1]; });
        for (std::size_t c = 0; c < cell_count; ++c) first[c + 1] += first[c];
        triangle.resize(first.back());
        std::vector<std::size_t> next = first;
        for (std::uint32_t t = 0; t < cells.size(); ++t)
            for_each_cell(cells[t], [&](std::size_t c) { triangle[next[c]++] = t; });
    }

    [[nodiscard]] std::span<const std::uint32_t> in(std::size_t cell) const {
        return std::span(triangle).subspan(first[cell], first[cell + 1] - first[cell]);
    }
};

/// Returns a frame for the triangles of one cell, with z along their normals.
Frame frame_of(std::size_t cell) {
    const auto along = [](std::size_t number) {
        return (2 * static_cast<float>(number) + 1) / cells_a_side - 1;
    };
    const int axis = static_cast<int>(cell / (cells_a_side * cells_a_side));
    Vec3 normal(0, 0, 0);
    normal[axis] = 1;
    normal[(axis + 1) % 3] = along(cell / cells_a_side % cells_a_side);
    normal[(axis + 2) % 3] = along(cell % cells_a_side);
    return Frame(normal.normalized());
}

// --- positions: only triangles whose boxes overlap are compared

struct Box {
    Vec3 low, high;
};

struct BoxedTriangle {
    Box box;
    std::uint32_t triangle;
};

struct Pair {
    std::uint32_t before, after;
    double area;  ///< of the overlap
};

/// A part with at most this many triangles is not divided further.
constexpr std::size_t few = 16;
/// A part that no plane divides is compared pair by pair up to this size. A larger one is a crowd.
constexpr std::size_t many = 64;
/// Limit of the pairs that are compared in all crowds together.
constexpr std::size_t most_pairs_in_crowds = 4'000'000;
/// A part of at least this size is worth another thread.
constexpr std::size_t worth_a_thread = 4096;

/// Triangles of one cell that lie in one part of space.
struct Part {
    std::size_t cell;
    Box region;
    std::vector<BoxedTriangle> triangle;

    [[nodiscard]] std::size_t pairs() const { return triangle.size() * (triangle.size() - 1) / 2; }
};

class PairSearch {
  public:
    PairSearch(const Scene& scene, float tolerance)
        : scene_(scene), tolerance_(tolerance), cells_(cells_of_all(scene, tolerance)), by_cell_(cells_) {}

    void run() {
        tbb::parallel_for(std::size_t{0}, cell_count, [&](std::size_t cell) {
            if (by_cell_.in(cell).size() > 1) divide(part_of(cell));
        });
    }

    /// Returns the pairs, sorted by triangle.
    [[nodiscard]] std::vector<Pair> pairs() {
        std::vector<Pair> all;
        for (const std::vector<Pair>& some : pairs_) all.insert(all.end(), some.begin(), some.end());
        std::sort(all.begin(), all.end(), [](const Pair& a, const Pair& b) {
            return std::tie(a.after, a.before) < std::tie(b.after, b.before);
        });
        return all;
    }

    /// Compares the crowds up to the limit of pairs. Returns the triangles of all other crowds.
    [[nodiscard]] std::vector<std::uint32_t> compare_crowds() {
        std::vector<Part> crowds;
        for (std::vector<Part>& some : crowds_)
            crowds.insert(crowds.end(), std::move_iterator(some.begin()), std::move_iterator(some.end()));
        std::sort(crowds.begin(), crowds.end(), [](const Part& a, const Part& b) {
            return std::tuple(a.triangle.size(), a.cell, a.region.low.x, a.region.low.y, a.region.low.z) <
                   std::tuple(b.triangle.size(), b.cell, b.region.low.x, b.region.low.y, b.region.low.z);
        });
        std::size_t pairs = 0, compared = 0;
        while (compared < crowds.size() && (pairs += crowds[compared].pairs()) <= most_pairs_in_crowds)
            ++compared;
        tbb::parallel_for(std::size_t{0}, compared, [&](std::size_t i) { compare(crowds[i]); });
        std::vector<std::uint32_t> others;
        for (std::size_t i = compared; i < crowds.size(); ++i)
            for (const BoxedTriangle& t : crowds[i].triangle) others.push_back(t.triangle);
        return others;
    }

  private:
    [[nodiscard]] Part part_of(std::size_t cell) const {
        constexpr float infinity = std::numeric_limits<float>::infinity();
        Part part{cell, {Vec3(-infinity), Vec3(infinity)}, {}};
        const Frame frame = frame_of(cell);
        part.triangle.reserve(by_cell_.in(cell).size());
        for (const std::uint32_t t : by_cell_.in(cell)) {
            Box box{Vec3(infinity), Vec3(-infinity)};
            for (const Vec3& corner : corners_of(scene_, t)) {
                const Vec3 at(frame.tangent.dot(corner), frame.bitangent.dot(corner),
                              frame.normal.dot(corner));
                for (int axis = 0; axis < 3; ++axis) {
                    box.low[axis] = std::min(box.low[axis], at[axis]);
                    box.high[axis] = std::max(box.high[axis], at[axis]);
                }
            }
            // Half of it for the largest distance between two that coincide, half of it for rounding.
            box.low.z -= tolerance_;
            box.high.z += tolerance_;
            part.triangle.push_back({box, t});
        }
        return part;
    }

    /// Halves the part until few triangles are left. Triangles in both halves go into both.
    void divide(Part part) {
        if (part.triangle.size() > few) {
            for (const int axis : axes_by_spread(part)) {
                const float border = middle(part, axis);
                if (!is_worthwhile(part, axis, border)) continue;
                Part above = cut_off_above(part, axis, border);
                if (part.triangle.size() + above.triangle.size() < worth_a_thread) {
                    divide(std::move(part));
                    divide(std::move(above));
                } else {
                    tbb::parallel_invoke([&] { divide(std::move(part)); }, [&] { divide(std::move(above)); });
                }
                return;
            }
        }
        if (part.triangle.size() <= many)
            compare(part);
        else
            crowds_.local().push_back(std::move(part));
    }

    static float middle(const Part& part, int axis) {
        double sum = 0;
        for (const BoxedTriangle& t : part.triangle)
            sum += double{t.box.low[axis]} + double{t.box.high[axis]};
        return static_cast<float>(sum / (2 * static_cast<double>(part.triangle.size())));
    }

    static std::array<int, 3> axes_by_spread(const Part& part) {
        Vec3 low = part.triangle[0].box.low, high = low;
        for (const BoxedTriangle& t : part.triangle)
            for (int axis = 0; axis < 3; ++axis) {
                low[axis] = std::min(low[axis], t.box.low[axis]);
                high[axis] = std::max(high[axis], t.box.low[axis]);
            }
        std::array<int, 3> axes = {0, 1, 2};
        std::sort(axes.begin(), axes.end(),
                  [spread = high - low](int a, int b) { return spread[a] > spread[b]; });
        return axes;
    }

    static bool is_worthwhile(const Part& part, int axis, float border) {
        std::size_t below = 0, above = 0;
        for (const BoxedTriangle& t : part.triangle) {
            below += t.box.low[axis] < border;
            above += t.box.high[axis] >= border;
        }
        const std::size_t size = part.triangle.size();
        return std::max(below, above) < size && below + above <= size + size / 2;
    }

    /// Splits off what is above the border; the part keeps what is below.
    static Part cut_off_above(Part& part, int axis, float border) {
        Part above{part.cell, part.region, {}};
        above.region.low[axis] = border;
        part.region.high[axis] = border;
        above.triangle.reserve(part.triangle.size());
        std::size_t kept = 0;
        for (const BoxedTriangle& t : part.triangle) {
            if (t.box.high[axis] >= border) above.triangle.push_back(t);
            if (t.box.low[axis] < border) part.triangle[kept++] = t;
        }
        part.triangle.resize(kept);
        return above;
    }

    void compare(const Part& part) {
        for (std::size_t i = 0; i < part.triangle.size(); ++i)
            for (std::size_t j = i + 1; j < part.triangle.size(); ++j)
                if (begin_to_overlap_in(part.region, part.triangle[i].box, part.triangle[j].box))
                    compare(part.cell, part.triangle[i].triangle, part.triangle[j].triangle);
    }

    /// Returns whether the boxes overlap and the lowest corner of their overlap is in `region`. This holds
    /// for only one of the regions that contain both, so that each pair is compared once.
    static bool begin_to_overlap_in(const Box& region, const Box& a, const Box& b) {
        for (int axis = 0; axis < 3; ++axis) {
            const float begin = std::max(a.low[axis], b.low[axis]);
            if (!(begin < a.high[axis] && begin < b.high[axis])) return false;
            if (!(begin >= region.low[axis] && begin < region.high[axis])) return false;
        }
        return true;
    }

    void compare(std::size_t cell, std::uint32_t i, std::uint32_t j) {
        if (std::abs(scene_.geometric_normal[i].dot(scene_.geometric_normal[j])) < same_plane_cosine) return;
        if (first_common_cell(cells_[i], cells_[j]) != cell) return;
        const auto [before, after] = std::minmax(i, j);
        const double area = common_area(corners_of(scene_, before), corners_of(scene_, after), tolerance_);
        if (area > 0) pairs_.local().push_back({before, after, area});
    }

    const Scene& scene_;
    float tolerance_;
    std::vector<NormalCells> cells_;  ///< per triangle
    TrianglesByCell by_cell_;
    tbb::enumerable_thread_specific<std::vector<Pair>> pairs_;
    tbb::enumerable_thread_specific<std::vector<Part>> crowds_;
};

bool have_a_side_in_common(const Scene& scene, const Pair& pair) {
    return scene.geometric_normal[pair.before].dot(scene.geometric_normal[pair.after]) > 0 ||
           is_for_both_faces(scene.material_of(pair.before)) ||
           is_for_both_faces(scene.material_of(pair.after));
}

/// `pairs` must be sorted by triangle.
void count_covering(const Scene& scene, std::span<const Pair> pairs, CoincidingTriangles& found) {
    for (std::size_t i = 0; i < pairs.size();) {
        const std::uint32_t after = pairs[i].after;
        double area = 0;
        for (; i < pairs.size() && pairs[i].after == after; ++i)
            if (have_a_side_in_common(scene, pairs[i])) area += pairs[i].area;
        found.covering += area > 0;
        found.area += std::min(area, double{triangle_area(scene, after)});
    }
}

}  // namespace

CoincidingTriangles find_coinciding_triangles(const Scene& scene, float tolerance) {
    PairSearch search(scene, tolerance);
    search.run();
    CoincidingTriangles found;
    found.triangle = search.compare_crowds();
    found.all_compared = found.triangle.empty();
    const std::vector<Pair> pairs = search.pairs();
    count_covering(scene, pairs, found);
    for (const Pair& pair : pairs) found.triangle.insert(found.triangle.end(), {pair.before, pair.after});
    std::sort(found.triangle.begin(), found.triangle.end());
    found.triangle.erase(std::unique(found.triangle.begin(), found.triangle.end()), found.triangle.end());
    return found;
}

}  // namespace common
