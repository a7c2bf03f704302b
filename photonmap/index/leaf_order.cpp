#include "photonmap/index/leaf_order.h"

namespace photonmap {
namespace {

/// Quantises coordinates along the widest axis into steps of the extent. Points closer than a step may come
/// in either order, but always in the same one.
struct Steps {
    std::size_t axis;
    float low, per_unit;

    Steps(std::span<const Member> members, int steps) {
        std::array<float, 3> least = members.front().position, most = least, size;
        for (const Member& member : members)
            for (std::size_t a = 0; a < 3; ++a) {
                least[a] = std::min(least[a], member.position[a]);
                most[a] = std::max(most[a], member.position[a]);
            }
        for (std::size_t a = 0; a < 3; ++a) size[a] = most[a] - least[a];
        axis = static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
        low = least[axis];
        per_unit = static_cast<float>(steps) / size[axis];
        // Coincident points, or an extent that has no reciprocal as it is too small or too large: all in one
        // step.
        if (!(per_unit <= std::numeric_limits<float>::max())) per_unit = 0;
    }

    /// From 0 to the number of steps.
    [[nodiscard]] int operator()(const Member& member) const {
        return static_cast<int>((member.position[axis] - low) * per_unit);
    }
};

}  // namespace

void LeafCutter::sort(std::span<const Member> members, std::span<Member> out) {
    constexpr int number_bits = 8, steps = (1 << 22) - 1;
    static_assert(most_ranked == 1 << number_bits);
    const Steps step_of(members, steps);
    // All keys differ: the high bits have the step, the low bits the number.
    std::array<int, most_ranked> key, rank{};
    for (std::size_t i = 0; i < members.size(); ++i)
        key[i] = step_of(members[i]) << number_bits | static_cast<int>(i);
    for (std::size_t i = members.size(); i < most_ranked; ++i) key[i] = std::numeric_limits<int>::max();
    const std::size_t rows = (members.size() + 15) / 16 * 16;
    for (std::size_t row = 0; row < rows; row += 16) {
        std::array<int, 16> before{};
        for (std::size_t other = 0; other < members.size(); ++other)
            for (std::size_t i = 0; i < 16; ++i) before[i] += key[other] < key[row + i];
        std::copy(before.begin(), before.end(), rank.begin() + static_cast<std::ptrdiff_t>(row));
    }
    for (std::size_t i = 0; i < members.size(); ++i) out[static_cast<std::size_t>(rank[i])] = members[i];
}

void LeafCutter::select(std::span<const Member> members, std::span<Member> out, std::size_t left) {
    constexpr int most_bins = 256;
    const int bins = std::min(most_bins, static_cast<int>(members.size() / 8));
    const Steps bin_of(members, bins - 1);
    std::array<std::uint32_t, most_bins> even{}, odd{};  // two, as consecutive members are often in one bin
    std::size_t i = 0;
    for (; i + 1 < members.size(); i += 2) {
        ++even[static_cast<std::size_t>(bin_of(members[i]))];
        ++odd[static_cast<std::size_t>(bin_of(members[i + 1]))];
    }
    if (i < members.size()) ++even[static_cast<std::size_t>(bin_of(members[i]))];

    std::size_t below = 0;
    int edge = 0;  // the bin that contains the split
    const auto in_edge = [&] {
        return std::size_t{even[static_cast<std::size_t>(edge)]} + odd[static_cast<std::size_t>(edge)];
    };
    for (; below + in_edge() < left; ++edge) below += in_edge();

    const auto edge_begin = out.begin() + static_cast<std::ptrdiff_t>(below);
    const auto edge_end = edge_begin + static_cast<std::ptrdiff_t>(in_edge());
    // Without branches, as they would be unpredictable.
    std::size_t before = 0, within = below, beyond = below + in_edge();
    for (const Member& member : members) {
        const int bin = bin_of(member);
        const std::size_t is_before = bin<edge, is_beyond = bin> edge, is_within = 1 - is_before - is_beyond;
        out[(before & -is_before) | (within & -is_within) | (beyond & -is_beyond)] = member;
        before += is_before;
        within += is_within;
        beyond += is_beyond;
    }
    const std::size_t axis = bin_of.axis;
    std::nth_element(
        edge_begin, out.begin() + static_cast<std::ptrdiff_t>(left), edge_end,
        [axis](const Member& a, const Member& b) { return a.position[axis] < b.position[axis]; });
}

}  // namespace photonmap
