#include "shlm/block_choice.h"

namespace shlm {
namespace {

struct Cost {
    double error_sq = 0, bytes = 0;

    [[nodiscard]] double at(double byte_price) const { return error_sq + byte_price * bytes; }
};

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
    std::size_t level_begin = 0, below_begin = 0;
    for (std::size_t level = 0; level < pyramid.levels(); ++level) {
        for (std::uint32_t y = 0; y < pyramid.height(level); ++y)
            for (std::uint32_t x = 0; x < pyramid.width(level); ++x) {
                const std::size_t b = level_begin + std::size_t{y} * pyramid.width(level) + x;
                const double area = pyramid.block(level, x, y).area;
                if (area == 0) continue;  // uncovered, and costs nothing
                Cost& cost = best[b];
                choice.of_block[b] = divided;
                if (level > 0) {
                    cost.bytes = bytes_of_division;
                    pyramid.for_children(level, x, y, [&](auto cx, auto cy) {
                        const Cost& part =
                            best[below_begin + std::size_t{cy} * pyramid.width(level - 1) + cx];
                        cost.error_sq += part.error_sq;
                        cost.bytes += part.bytes;
                    });
                    if (!costs[b].may_be_one) continue;
                }
                for (std::size_t k = static_cast<std::size_t>(BlockKind::dark); k < block_kinds; ++k) {
                    const Cost kept{costs[b].error_sq[k], bytes_of(static_cast<BlockKind>(k), with_normals)};
                    if (choice.of_block[b] == divided && level == 0) {
                        cost = kept;
                    } else if (kept.at(byte_price) > cost.at(byte_price)) {
                        continue;
                    } else {
                        cost = kept;
                    }
                    choice.of_block[b] = static_cast<std::uint8_t>(k);
                }
            }
        below_begin = level_begin;
        level_begin += std::size_t{pyramid.width(level)} * pyramid.height(level);
    }
    choice.error_sq = best.back().error_sq;
    choice.bytes = best.back().bytes;
    return choice;
}

}  // namespace shlm
