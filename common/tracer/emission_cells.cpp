#include "common/tracer/emission_cells.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/core/sampling.h"
#include "common/scene/surface_point.h"

namespace common {
namespace {

/// The share of a cell's weight for light that its samples may have missed.
constexpr double share_of_brightest = 0.01f;

/// Texels first to last along one axis of a texture, both included.
struct TexelRange {
    int first, last;
};

/// One or two ranges.
struct TexelRanges {
    std::array<TexelRange, 2> range;
    int count;
};

/// Returns the texels that are read between two coordinates, after wrapping.
TexelRanges texels_between(float low, float high, int size, Wrap wrap) {
    const TexelRanges all{{{{0, size - 1}, {}}}, 1};
    const double from = static_cast<double>(low) * size - 0.5, to = static_cast<double>(high) * size - 0.5;
    // A coordinate is rounded here and again when the texture is read.
    const double rounding = 1e-3 + 0x1p-21 * std::max(std::abs(from), std::abs(to));
    const double first = std::floor(from - rounding), last = std::floor(to + rounding) + 1;
    if (!(std::max(std::abs(first), std::abs(last)) < 1e9)) return all;
    if (wrap == Wrap::clamp_to_edge) {
        const auto inside = [&](double i) { return static_cast<int>(std::clamp(i, 0.0, size - 1.0)); };
        return {{{{inside(first), inside(last)}, {}}}, 1};
    }
    if (last - first >= size - 1) return all;
    TexelRanges ranges{{}, 0};
    const double period = std::floor(first / size);
    for (const double p : {period, period + 1}) {
        const double begin = std::max(first - p * size, 0.0), end = std::min(last - p * size, size - 1.0);
        if (begin > end) continue;
        TexelRange range{static_cast<int>(begin), static_cast<int>(end)};
        const bool mirrored = wrap == Wrap::mirrored_repeat && std::fmod(std::abs(p), 2.0) == 1;
        if (mirrored) range = {size - 1 - range.last, size - 1 - range.first};
        ranges.range[static_cast<std::size_t>(ranges.count++)] = range;
    }
    return ranges;
}

}  // namespace

BrightestTexels::BrightestTexels(const Texture& texture) : wrap_(texture.wrap()) {
    Level level{texture.width(), texture.height(), {}};
    const std::span<const std::uint8_t> rgb = texture.rgb();
    level.brightest.resize(rgb.size() / 3);
    for (std::size_t i = 0; i < level.brightest.size(); ++i)
        level.brightest[i] = std::max({rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]});
    level_.push_back(std::move(level));
    while (level_.back().width > 1 || level_.back().height > 1) {
        const Level& fine = level_.back();
        Level coarse{(fine.width + 1) / 2, (fine.height + 1) / 2, {}};
        coarse.brightest.assign(static_cast<std::size_t>(coarse.width) * coarse.height, 0);
        for (int y = 0; y < fine.height; ++y)
            for (int x = 0; x < fine.width; ++x) {
                std::uint8_t& brightest =
                    coarse.brightest[static_cast<std::size_t>(y / 2) * coarse.width + x / 2];
                brightest = std::max(brightest, fine.brightest[static_cast<std::size_t>(y) * fine.width + x]);
            }
        level_.push_back(std::move(coarse));
    }
}

float BrightestTexels::within(const Vec2& low, const Vec2& high) const {
    const TexelRanges x = texels_between(low.x, high.x, level_.front().width, wrap_[0]);
    const TexelRanges y = texels_between(low.y, high.y, level_.front().height, wrap_[1]);
    std::uint8_t brightest = 0;
    for (int i = 0; i < x.count; ++i)
        for (int j = 0; j < y.count; ++j) {
            const TexelRange &across = x.range[static_cast<std::size_t>(i)],
                             &down = y.range[static_cast<std::size_t>(j)];
            brightest = std::max(brightest, in_texels(across.first, across.last, down.first, down.last));
        }
    // Decoding to linear does not increase this.
    return static_cast<float>(brightest) / 255.0f;
}

std::uint8_t BrightestTexels::in_texels(int first_x, int last_x, int first_y, int last_y) const {
    int l = 0;
    while ((last_x >> l) - (first_x >> l) > 1 || (last_y >> l) - (first_y >> l) > 1) ++l;
    const Level& level = level_[static_cast<std::size_t>(l)];
    std::uint8_t brightest = 0;
    for (int y = first_y >> l; y <= last_y >> l; ++y)
        for (int x = first_x >> l; x <= last_x >> l; ++x)
            brightest = std::max(brightest, level.brightest[static_cast<std::size_t>(y) * level.width + x]);
    return brightest;
}

EmissionCells::EmissionCells(const Scene& scene, std::uint32_t triangle, const BrightestTexels& brightest,
                             std::size_t most_cells)
    : triangle_(triangle), cell_{{0, 0, false}} {
    const TextureUse& use = scene.material_of(triangle).emissive_texture;
    texcoord_ = {texcoord_at(scene, {triangle, 0, 0}, use), texcoord_at(scene, {triangle, 1, 0}, use),
                 texcoord_at(scene, {triangle, 0, 1}, use)};
    const float texels = texels_along_an_edge(scene.texture[use.texture]);
    constexpr int finest = 13;
    drop_black(brightest);
    while (level_ < finest && !(texels <= static_cast<float>(1 << level_)) && !cell_.empty() &&
           cell_.size() <= most_cells) {
        split();
        drop_black(brightest);
    }
    constexpr float most_across = 8;
    const float texels_per_cell = texels / static_cast<float>(1 << level_);
    weigh(scene, brightest,
          static_cast<int>(texels_per_cell < most_across - 2 ? texels_per_cell + 2 : most_across));
}

/// Returns the number of texels along the longest edge.
float EmissionCells::texels_along_an_edge(const Texture& texture) const {
    float texels = 1;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec2 edge = texcoord_[(i + 1) % 3] - texcoord_[i];
        texels = std::max({texels, std::abs(edge.x) * static_cast<float>(texture.width()),
                           std::abs(edge.y) * static_cast<float>(texture.height())});
    }
    return texels;
}

/// Splits each cell into four, at the middles of its sides.
void EmissionCells::split() {
    const std::vector<Cell> whole = std::exchange(cell_, {});
    ++level_;
    for (const Cell& cell : whole) {
        const auto column = static_cast<std::uint16_t>(2 * cell.column),
                   row = static_cast<std::uint16_t>(2 * cell.row),
                   next_column = static_cast<std::uint16_t>(column + 1),
                   next_row = static_cast<std::uint16_t>(row + 1);
        cell_.push_back({next_column, row, cell.turned});
        cell_.push_back({column, next_row, cell.turned});
        cell_.push_back(cell.turned ? Cell{next_column, next_row, true} : Cell{column, row, false});
        cell_.push_back(cell.turned ? Cell{next_column, next_row, false} : Cell{column, row, true});
    }
}

void EmissionCells::drop_black(const BrightestTexels& brightest) {
    std::erase_if(cell_, [&](const Cell& cell) {
        const Imath::Box<Vec2> texcoords = texcoords_of(cell);
        return brightest.within(texcoords.min, texcoords.max) == 0;
    });
}

void EmissionCells::weigh(const Scene& scene, const BrightestTexels& brightest, int samples_across) {
    const Rgb& untextured = scene.material_of(triangle_).emitted_radiance;
    Imath::V3d sum(0, 0, 0);
    for (const Cell& cell : cell_) {
        Imath::V3d sampled(0, 0, 0);
        for (int i = 0; i < samples_across * samples_across; ++i) {
            const float across = static_cast<float>(samples_across);
            const Vec2 uv =
                within(cell, sample_triangle((static_cast<float>(i % samples_across) + 0.5f) / across,
                                             (static_cast<float>(i / samples_across) + 0.5f) / across));
            sampled += Imath::V3d(emitted_radiance_at(scene, {triangle_, uv.x, uv.y}));
        }
        const Imath::Box<Vec2> texcoords = texcoords_of(cell);
        const float most = brightest.within(texcoords.min, texcoords.max);
        sum += sampled * ((1.0 - share_of_brightest) / (samples_across * samples_across)) +
               Imath::V3d(untextured) * (share_of_brightest * most);
        cumulative_.push_back((sum.x + sum.y + sum.z) / 3);
    }
    mean_radiance_ = Rgb(sum * std::ldexp(1.0, -2 * level_));
}

Vec2 EmissionCells::within(const Cell& cell, const Vec2& uv) const {
    const Vec2 corner(cell.column, cell.row);
    const Vec2 place = cell.turned ? corner + Vec2(1, 1) - uv : corner + uv;
    return place * std::ldexp(1.0f, -level_);
}

Imath::Box<Vec2> EmissionCells::texcoords_of(const Cell& cell) const {
    Imath::Box<Vec2> box;
    for (const Vec2& corner : {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)}) {
        const Vec2 uv = within(cell, corner);
        box.extendBy(texcoord_[0] + (texcoord_[1] - texcoord_[0]) * uv.x +
                     (texcoord_[2] - texcoord_[0]) * uv.y);
    }
    return box;
}

EmissionCells::Place EmissionCells::place(double which, float u1, float u2) const {
    const auto found = std::upper_bound(cumulative_.begin(), cumulative_.end(), which * cumulative_.back());
    const std::size_t chosen = std::min<std::size_t>(found - cumulative_.begin(), cell_.size() - 1);
    const double weight = cumulative_[chosen] - (chosen == 0 ? 0.0 : cumulative_[chosen - 1]);
    const double cells = std::ldexp(1.0, 2 * level_);  // including the black ones
    return {within(cell_[chosen], sample_triangle(u1, u2)),
            static_cast<float>(weight / cumulative_.back() * cells)};
}

}  // namespace common
