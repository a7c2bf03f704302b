#include "shlm/block_choice.h"

namespace shlm {
namespace {

struct Cost {
    double error_sq = 0, bytes = 0;

    [[nodiscard]] double at(double byte_price) const { return error_sq + byte_price * bytes; }
};

struct Kept {
    BlockKind kind = BlockKind::dark;
    Cost cost;
};

/// Of what a block may be that is not divided.
Kept cheapest(const BlockCosts& costs, bool with_normals, double byte_price) {
    Kept best;
    for (std::size_t k = static_cast<std::size_t>(BlockKind::dark); k < block_kinds; ++k) {
        const auto kind = static_cast<BlockKind>(k);
        const Cost cost{costs.error_sq[k], bytes_of(kind, with_normals)};
        if (kind == BlockKind::dark || cost.at(byte_price) < best.cost.at(byte_price)) best = {kind, cost};
    }
    return best;
}

}  // namespace

double bytes_of(BlockKind kind, bool with_normal) {
    constexpr double half_bytes = 2, normal_bytes = 4;
    if (kind == BlockKind::uncovered) return 0;
    return half_bytes * static_cast<double>(block_numbers[static_cast<std::size_t>(kind)]) +
           (with_normal ? normal_bytes : 0);
}

BlockChoice choose_blocks(const LightPyramid& pyramid, std::span<const BlockCosts> costs, bool with_normals,
                          double byte_price) {
    BlockChoice choice;
    choice.of_block.resize(costs.size());
    std::vector<Cost> best(costs.size());
    const auto cost_of_division = [&](std::size_t level, std::uint32_t x, std::uint32_t y) {
        Cost cost{0, bytes_of_division};
        pyramid.for_children(level, x, y, [&](auto cx, auto cy) {
            const Cost& part = best[pyramid.index(level - 1, cx, cy)];
            cost.error_sq += part.error_sq;
            cost.bytes += part.bytes;
        });
        return cost;
    };
    for (std::size_t level = 0; level < pyramid.levels(); ++level)
        for (std::uint32_t y = 0; y < pyramid.height(level); ++y)
            for (std::uint32_t x = 0; x < pyramid.width(level); ++x) {
                const std::size_t b = pyramid.index(level, x, y);
                const LightBlock& block = pyramid.block(level, x, y);
                if (block.surface.area == 0) continue;  // uncovered, and costs nothing
                const Kept kept = cheapest(costs[b], with_normals, byte_price);
                choice.of_block[b] = static_cast<std::uint8_t>(kept.kind);
                best[b] = kept.cost;
                if (level == 0 || (costs[b].may_be_one && block.hits < least_hits_to_divide)) continue;
                const Cost division = cost_of_division(level, x, y);
                if (costs[b].may_be_one && kept.cost.at(byte_price) <= division.at(byte_price)) continue;
                choice.of_block[b] = divided;
                best[b] = division;
            }
    choice.error_sq = best.back().error_sq;
    return choice;
}

}  // namespace shlm
