#include "bench/scenes/mesh_builder.h"

#include <limits>

#include "bench/scenes/lightmap_charts.h"

namespace scenes {
namespace {

/// Returns point i of n from a to b, exact at both ends and symmetric in a and b.
float subdivide(float a, float b, int i, int n) {
    if (i == 0 || a == b) return a;
    if (i == n) return b;
    return (a * static_cast<float>(n - i) + b * static_cast<float>(i)) / static_cast<float>(n);
}

Vec3 subdivide(const Vec3& a, const Vec3& b, int i, int n) {
    return {subdivide(a.x, b.x, i, n), subdivide(a.y, b.y, i, n), subdivide(a.z, b.z, i, n)};
}

Vec3 normal_of(const Surface& surface, float s, float t) {
    const float step = 1e-3f;
    const Vec3 ds = surface(s + step, t) - surface(s - step, t);
    const Vec3 dt = surface(s, t + step) - surface(s, t - step);
    const Vec3 cross = ds % dt;
    const bool at_pole = ds.length() < 1e-4f * dt.length();
    if (at_pole) return normal_of(surface, s, t < 0.5f ? t + 2 * step : t - 2 * step);
    return cross.normalized();
}

/// Returns n arc lengths from 0 along one direction of a grid of points, averaged over the other direction.
std::vector<float> mean_running_length(int n, int lines, const std::function<Vec3(int, int)>& point) {
    std::vector<float> length(static_cast<std::size_t>(n), 0.0f);
    for (int i = 1; i < n; ++i) {
        float sum = 0;
        for (int line = 0; line < lines; ++line) sum += (point(i, line) - point(i - 1, line)).length();
        length[i] = length[i - 1] + sum / static_cast<float>(lines);
    }
    return length;
}

/// Flattens a curved grid to a rectangle whose rows and columns keep their mean lengths.
std::vector<Vec2> flatten_curved(Cells cells, const std::function<Vec3(int, int)>& point) {
    const int columns = cells.along_s + 1, rows = cells.along_t + 1;
    const auto along_s = mean_running_length(columns, rows, point);
    const auto along_t = mean_running_length(rows, columns, [&](int j, int i) { return point(i, j); });
    std::vector<Vec2> flat;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) flat.emplace_back(along_s[i], along_t[j]);
    return flat;
}

/// Flattens a plane grid without any distortion.
std::vector<Vec2> flatten_plane(Cells cells, const std::function<Vec3(int, int)>& point) {
    const Vec3 origin = point(0, 0);
    const Vec3 axis_s = (point(cells.along_s, 0) - origin).normalized();
    const Vec3 normal = (axis_s % (point(0, cells.along_t) - origin)).normalized();
    const Vec3 axis_t = normal % axis_s;
    std::vector<Vec2> flat;
    for (int j = 0; j <= cells.along_t; ++j)
        for (int i = 0; i <= cells.along_s; ++i)
            flat.emplace_back((point(i, j) - origin).dot(axis_s), (point(i, j) - origin).dot(axis_t));
    return flat;
}

int pieces_no_longer_than(float limit, float length, int cells) {
    return std::clamp(static_cast<int>(std::ceil(length / limit - 1e-3f)), 1, cells);
}

Vec2 largest(const std::vector<Vec2>& points) {
    Vec2 result = points.front();
    for (const Vec2& p : points) result = {std::max(result.x, p.x), std::max(result.y, p.y)};
    return result;
}

void move_to_origin(std::vector<Vec2>& points) {
    Vec2 smallest = points.front();
    for (const Vec2& p : points) smallest = {std::min(smallest.x, p.x), std::min(smallest.y, p.y)};
    for (Vec2& p : points) p -= smallest;
}

}  // namespace

void MeshBuilder::add_quad(const std::array<Vec3, 4>& corner, Cells cells, const CellFilter& present) {
    Patch patch{.cells = cells, .is_plane = true};
    for (int j = 0; j <= cells.along_t; ++j) {
        for (int i = 0; i <= cells.along_s; ++i) {
            const Vec3 below = subdivide(corner[0], corner[1], i, cells.along_s);
            const Vec3 above = subdivide(corner[3], corner[2], i, cells.along_s);
            patch.position.push_back(subdivide(below, above, j, cells.along_t));
        }
    }
    const Vec3 normal = ((corner[2] - corner[0]) % (corner[3] - corner[1])).normalized();
    patch.normal.assign(patch.position.size(), normal);
    const auto flat = flatten_plane(cells, [&](int i, int j) { return patch.position[patch.vertex(i, j)]; });
    for (const Vec2& p : flat) patch.texcoord.emplace_back(p.x / texture_size_, -p.y / texture_size_);
    for (int j = 0; j < cells.along_t; ++j)
        for (int i = 0; i < cells.along_s; ++i) patch.present.push_back(!present || present(i, j));
    patches_.push_back(std::move(patch));
}

void MeshBuilder::add_surface(Cells cells, const Surface& surface) {
    Patch patch{.cells = cells};
    for (int j = 0; j <= cells.along_t; ++j) {
        for (int i = 0; i <= cells.along_s; ++i) {
            const float s = static_cast<float>(i) / static_cast<float>(cells.along_s);
            const float t = static_cast<float>(j) / static_cast<float>(cells.along_t);
            patch.position.push_back(surface(s, t));
            patch.normal.push_back(normal_of(surface, s, t));
        }
    }
    const bool closed = (surface(0, 0.5f) - surface(1, 0.5f)).length() < 1e-4f;
    if (closed)  // both ends of the seam take the same points
        for (int j = 0; j <= cells.along_t; ++j)
            patch.position[patch.vertex(cells.along_s, j)] = patch.position[patch.vertex(0, j)];

    const auto flat = flatten_curved(cells, [&](int i, int j) { return patch.position[patch.vertex(i, j)]; });
    const float repeats = flat.back().x / texture_size_;
    const float fit = closed ? std::max(1.0f, std::round(repeats)) / repeats : 1.0f;
    for (const Vec2& p : flat) patch.texcoord.emplace_back(p.x * fit / texture_size_, -p.y / texture_size_);
    patch.present.assign(static_cast<std::size_t>(cells.along_s * cells.along_t), true);
    patches_.push_back(std::move(patch));
}

void MeshBuilder::repeat_turned_half_round() {
    const auto turn = [](Vec3& v) { v = {-v.x, v.y, -v.z}; };
    std::vector<Patch> turned = patches_;
    for (Patch& patch : turned) {
        std::for_each(patch.position.begin(), patch.position.end(), turn);
        std::for_each(patch.normal.begin(), patch.normal.end(), turn);
    }
    patches_.insert(patches_.end(), turned.begin(), turned.end());
}

std::vector<MeshBuilder::Chart> MeshBuilder::cut_into_charts(float longest_side) const {
    std::vector<Chart> charts;
    for (std::size_t p = 0; p < patches_.size(); ++p) {
        const Patch& patch = patches_[p];
        const auto flatten = patch.is_plane ? flatten_plane : flatten_curved;
        const Vec2 size =
            largest(flatten(patch.cells, [&](int i, int j) { return patch.position[patch.vertex(i, j)]; }));
        const int columns = pieces_no_longer_than(longest_side, size.x, patch.cells.along_s);
        const int rows = pieces_no_longer_than(longest_side, size.y, patch.cells.along_t);
        for (int row = 0; row < rows; ++row) {
            for (int column = 0; column < columns; ++column) {
                const int i0 = patch.cells.along_s * column / columns, j0 = patch.cells.along_t * row / rows;
                const Cells cells{patch.cells.along_s * (column + 1) / columns - i0,
                                  patch.cells.along_t * (row + 1) / rows - j0};
                Chart chart{.patch = p, .first_i = i0, .first_j = j0, .cells = cells};
                chart.flat = flatten(
                    cells, [&](int i, int j) { return patch.position[patch.vertex(i0 + i, j0 + j)]; });
                move_to_origin(chart.flat);
                chart.size = largest(chart.flat);
                charts.push_back(std::move(chart));
            }
        }
    }
    return charts;
}

void MeshBuilder::append_chart(const Chart& chart, const std::function<Vec2(Vec2)>& to_lightmap,
                               Mesh& mesh) const {
    const Patch& patch = patches_[chart.patch];
    const auto first = static_cast<std::uint32_t>(mesh.position.size());
    for (int j = 0; j <= chart.cells.along_t; ++j) {
        for (int i = 0; i <= chart.cells.along_s; ++i) {
            const std::size_t v = patch.vertex(chart.first_i + i, chart.first_j + j);
            mesh.position.push_back(patch.position[v]);
            mesh.normal.push_back(patch.normal[v]);
            mesh.texcoord.push_back(patch.texcoord[v]);
        }
    }
    for (const Vec2& p : chart.flat) mesh.lightmap_texcoord.push_back(to_lightmap(p));

    const auto row = static_cast<std::uint32_t>(chart.cells.along_s + 1);
    const auto append_triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const Vec3 cross = (mesh.position[b] - mesh.position[a]) % (mesh.position[c] - mesh.position[a]);
        if (cross.length() > 1e-10f) mesh.index.insert(mesh.index.end(), {a, b, c});
    };
    for (int j = 0; j < chart.cells.along_t; ++j) {
        for (int i = 0; i < chart.cells.along_s; ++i) {
            if (!patch.present[patch.cell(chart.first_i + i, chart.first_j + j)]) continue;
            const std::uint32_t corner =
                first + static_cast<std::uint32_t>(j) * row + static_cast<std::uint32_t>(i);
            append_triangle(corner, corner + 1, corner + row + 1);
            append_triangle(corner, corner + row + 1, corner + row);
        }
    }
}

Mesh MeshBuilder::finish() const {
    const auto sizes_of = [](const std::vector<Chart>& charts) {
        std::vector<Vec2> sizes;
        for (const Chart& chart : charts) sizes.push_back(chart.size);
        return sizes;
    };
    std::vector<Chart> charts = cut_into_charts(std::numeric_limits<float>::infinity());
    ChartPacking packing = pack_charts(sizes_of(charts));
    float area = 0;
    for (const Chart& chart : charts) area += chart.size.x * chart.size.y;

    // More cuts fill the square better but break up the lightmap, so each step has to be worth it.
    for (float longest_side : {1.0f, 0.7f, 0.5f, 0.35f, 0.25f}) {
        const float gain_worth_a_cut = 1.06f;
        std::vector<Chart> cut_charts = cut_into_charts(longest_side * std::sqrt(area));
        ChartPacking cut_packing = pack_charts(sizes_of(cut_charts));
        if (cut_packing.scale.x * cut_packing.scale.y >
            gain_worth_a_cut * packing.scale.x * packing.scale.y) {
            charts = std::move(cut_charts);
            packing = std::move(cut_packing);
        }
    }

    Mesh mesh;
    for (std::size_t c = 0; c < charts.size(); ++c) {
        const ChartPlacement& placement = packing.placement[c];
        append_chart(
            charts[c],
            [&](Vec2 p) {
                const Vec2 turned = placement.rotated ? Vec2(charts[c].size.y - p.y, p.x) : p;
                return placement.offset + turned * packing.scale;
            },
            mesh);
    }
    return mesh;
}

}  // namespace scenes
