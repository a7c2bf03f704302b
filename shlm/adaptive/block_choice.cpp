#include "shlm/adaptive/block_choice.h"

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

/// Returns the cheapest kind for a block that is not divided.
Kept cheapest(const BlockCosts& costs, bool with_normals, double byte_price) {
    Kept best;
    for (std::size_t k = static_cast<std::size_t>(BlockKind::dark); k < block_kinds; ++k) {
        const auto kind = static_cast<BlockKind>(k);
        const Cost cost{costs.error_sq[k], bytes_of(kind, with_normals)};
        if (kind == BlockKind::dark || cost.at(byte_price) < best.cost.at(byte_price)) best = {kind, cost};
    }
    return best;
}

/// Descends to the blocks that stay whole, and decides on the way back.
class Choosing {
  public:
    Choosing(const LightPyramid& pyramid, std::span<const BlockCosts> costs, double byte_price)
        : pyramid_(pyramid), costs_(costs), byte_price_(byte_price) {
        choice_.of_block.resize(costs.size());
        choice_.error_sq = visit(pyramid.levels() - 1, 0, 0).error_sq;
    }

    [[nodiscard]] BlockChoice take() && { return std::move(choice_); }

  private:
    Cost visit(std::size_t level, std::uint32_t x, std::uint32_t y) {
        const LightBlock& block = pyramid_.block(level, x, y);
        if (block.surface.area == 0) return {};  // uncovered, and costs nothing
        const std::size_t b = pyramid_.index(level, x, y);
        const Kept kept = cheapest(costs_[b], !pyramid_.is_flat(), byte_price_);
        choice_.of_block[b] = static_cast<std::uint8_t>(kept.kind);
        if (level == 0 || stays_whole(block)) return kept.cost;
        Cost division{0, bytes_of_division};
        pyramid_.for_children(level, x, y, [&](auto child_x, auto child_y) {
            const Cost part = visit(level - 1, child_x, child_y);
            division.error_sq += part.error_sq;
            division.bytes += part.bytes;
        });
        if (block.surface.one && kept.cost.at(byte_price_) <= division.at(byte_price_)) return kept.cost;
        choice_.of_block[b] = divided;
        return division;
    }

    const LightPyramid& pyramid_;
    std::span<const BlockCosts> costs_;
    double byte_price_;
    BlockChoice choice_;
};

}  // namespace

double bytes_of(BlockKind kind, bool with_normal) {
    constexpr double half_bytes = 2, normal_bytes = 4;
    if (kind == BlockKind::uncovered) return 0;
    return half_bytes * static_cast<double>(block_numbers(kind)) + (with_normal ? normal_bytes : 0);
}

BlockChoice choose_blocks(const LightPyramid& pyramid, std::span<const BlockCosts> costs, double byte_price) {
    return Choosing(pyramid, costs, byte_price).take();
}

}  // namespace shlm
