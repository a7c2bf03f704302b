#include "bench/scenes/lightmap_charts.h"

#include <array>
#include <numeric>
#include <optional>

namespace scenes {
namespace {

struct Rectangle {
    Vec2 corner, size;
};

Vec2 quarter_turned(Vec2 size) {
    return {size.y, size.x};
}

std::vector<std::size_t> longest_first(std::span<const Vec2> chart_size) {
    std::vector<std::size_t> order(chart_size.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::max(chart_size[a].x, chart_size[a].y) > std::max(chart_size[b].x, chart_size[b].y);
    });
    return order;
}

struct Fit {
    std::size_t free_rectangle;
    bool rotated;
    float slack;  ///< the smaller of the two gaps that would be left beside the chart
};

std::optional<Fit> find_tightest_fit(std::span<const Rectangle> free, Vec2 size, Vec2 turned_size) {
    std::optional<Fit> best;
    for (std::size_t i = 0; i < free.size(); ++i) {
        for (bool rotated : {false, true}) {
            const Vec2 gap = free[i].size - (rotated ? turned_size : size);
            const float slack = std::min(gap.x, gap.y);
            if (slack >= 0 && (!best || slack < best->slack)) best = Fit{i, rotated, slack};
        }
    }
    return best;
}

/// Divides the rest of a free rectangle around a chart in its corner by one straight cut, so that the larger
/// part is as large as possible.
void split_free_rectangle(std::vector<Rectangle>& free, std::size_t index, Vec2 taken) {
    const Rectangle whole = free[index];
    const Vec2 rest = whole.size - taken;
    const bool cut_upright = rest.x > rest.y;
    free[index] = {whole.corner + Vec2(taken.x, 0), {rest.x, cut_upright ? whole.size.y : taken.y}};
    free.push_back({whole.corner + Vec2(0, taken.y), {cut_upright ? taken.x : whole.size.x, rest.y}});
}

/// Packs by guillotine cuts: every chart takes the corner of the free rectangle that it fits most tightly.
std::optional<ChartPacking> place_charts(std::span<const Vec2> chart_size, std::span<const std::size_t> order,
                                         Vec2 scale) {
    ChartPacking packing{std::vector<ChartPlacement>(chart_size.size()), scale};
    const Vec2 gutter(chart_gutter, chart_gutter);
    std::vector<Rectangle> free{
        {gutter * 0.5f, Vec2(1, 1)}};  // half a gutter at the lower borders, half at the upper
    for (std::size_t chart : order) {
        const Vec2 size = chart_size[chart] * scale + gutter;
        const Vec2 turned_size = quarter_turned(chart_size[chart]) * scale + gutter;
        const auto fit = find_tightest_fit(free, size, turned_size);
        if (!fit) return std::nullopt;
        packing.placement[chart] = {free[fit->free_rectangle].corner, fit->rotated};
        split_free_rectangle(free, fit->free_rectangle, fit->rotated ? turned_size : size);
    }
    return packing;
}

}  // namespace

ChartPacking pack_charts(std::span<const Vec2> chart_size) {
    constexpr std::array stretches{1.0f, 1.05f, 0.95f, 1.09f, 0.92f, 1.14f, 0.88f};
    const std::vector<std::size_t> order = longest_first(chart_size);
    float area = 0;
    for (Vec2 size : chart_size) area += size.x * size.y;

    // What fits is not monotonic in the scale, so walk down from the scale that would leave no gap.
    for (float scale = 1 / std::sqrt(area);; scale *= 0.995f) {
        for (float stretch : stretches) {
            const Vec2 stretched(scale * stretch, scale / stretch);
            if (auto packing = place_charts(chart_size, order, stretched)) return *packing;
        }
    }
}

}  // namespace scenes
