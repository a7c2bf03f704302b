#include "shlm/adaptive/adaptive_map.h"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <bit>

#include "common/core/input_error.h"
#include "shlm/adaptive/block_moments.h"
#include "shlm/map/irradiance_mean.h"
#include "shlm/map/packed_normal.h"
#include "shlm/map/stored_texel.h"

namespace shlm {
namespace {

using common::Rgb;
using common::Vec3;

constexpr std::uint32_t block_bit = 0x80000000u, offset_mask = 0x0fffffffu;

BlockKind kind_of(std::uint32_t node) {
    return static_cast<BlockKind>((node >> 28) & 7);
}

std::uint32_t block_node(BlockKind kind, std::size_t offset) {
    return block_bit | static_cast<std::uint32_t>(kind) << 28 | static_cast<std::uint32_t>(offset);
}

float number_at(const std::uint16_t* stored, std::size_t i) {
    half h;
    h.setBits(stored[i]);
    return static_cast<float>(h);
}

std::vector<float> kept_numbers(BlockKind kind, const LightBlock& block) {
    if (!keeps_numbers(kind)) return {};
    return with_basis(kind, [&](auto basis) {
        const auto numbers = shlm::numbers_of<decltype(basis)>(block.light(), block.surface.unit_normal());
        return std::vector<float>(numbers.begin(), numbers.end());
    });
}

}  // namespace

/// A face's blocks before they are assembled with those of the others.
struct AdaptiveMap::Draft {
    struct Block {
        BlockKind kind = BlockKind::uncovered;
        Vec3 normal{0, 0, 0};
        std::vector<float> number;
    };
    RegionFace face;
    bool flat;
    Vec3 normal;
    std::vector<Node> node;  ///< the first is the root; that of a block is an index into `block`
    std::vector<Block> block;
};

/// Descends from the largest block and makes the chosen blocks.
class AdaptiveMap::Drawing {
  public:
    static Draft draft_of(const LightPyramid& pyramid, const BlockChoice& choice) {
        Drawing drawing(pyramid, choice);
        drawing.draft_.node.push_back(0);
        drawing.draw(0, pyramid.levels() - 1, 0, 0);
        return std::move(drawing.draft_);
    }

  private:
    Drawing(const LightPyramid& pyramid, const BlockChoice& choice) : pyramid_(pyramid), choice_(choice) {
        draft_.face = pyramid.face();
        draft_.flat = pyramid.is_flat();
        draft_.normal = pyramid.largest_block().surface.unit_normal();
    }

    void draw(std::size_t node, std::size_t level, std::uint32_t x, std::uint32_t y) {
        const bool inside = x < pyramid_.width(level) && y < pyramid_.height(level);
        const std::uint8_t chosen = inside ? choice_.of_block[pyramid_.index(level, x, y)]
                                           : static_cast<std::uint8_t>(BlockKind::uncovered);
        if (chosen != divided) {
            Draft::Block kept = inside ? block_of(static_cast<BlockKind>(chosen), pyramid_.block(level, x, y))
                                       : Draft::Block();
            draft_.node[node] = block_node(kept.kind, draft_.block.size());
            draft_.block.push_back(std::move(kept));
            return;
        }
        const std::size_t first = draft_.node.size();
        draft_.node[node] = static_cast<Node>(first);
        draft_.node.resize(first + 4);
        for (std::uint32_t i = 0; i < 4; ++i) draw(first + i, level - 1, 2 * x + i % 2, 2 * y + i / 2);
    }

    /// Returns an uncovered block also if its texels' normals cancel, so that it faces nowhere.
    static Draft::Block block_of(BlockKind kind, const LightBlock& block) {
        const Vec3 normal = block.surface.unit_normal();
        if (kind == BlockKind::uncovered || normal == Vec3(0, 0, 0)) return {};
        return {kind, normal, kept_numbers(kind, block)};
    }

    const LightPyramid& pyramid_;
    const BlockChoice& choice_;
    Draft draft_;
};

AdaptiveMap::AdaptiveMap(const BlockSearch& search, const TexelLayout& layout, double wanted_error,
                         bool smooth)
    : smooth_(smooth), places_(layout) {
    const std::span<const LightPyramid> pyramids = search.pyramids();
    const bool has_backs = std::any_of(pyramids.begin(), pyramids.end(),
                                       [](const LightPyramid& pyramid) { return pyramid.face().back; });
    face_.resize((has_backs ? 2 : 1) * places_.region_count());
    const MapBlocks blocks = search.smallest(wanted_error);
    estimated_error_ = blocks.error;
    std::vector<Draft> drafts(pyramids.size());
    tbb::parallel_for(std::size_t{0}, pyramids.size(),
                      [&](std::size_t f) { drafts[f] = Drawing::draft_of(pyramids[f], blocks.face[f]); });
    assemble(drafts);
}

void AdaptiveMap::assemble(std::span<const Draft> drafts) {
    float largest = 0;
    std::size_t nodes = 0, numbers = 0;
    for (const Draft& draft : drafts) {
        nodes += draft.node.size();
        for (const Draft::Block& block : draft.block) {
            ++blocks_[static_cast<std::size_t>(block.kind)];
            numbers += block.number.size() + (draft.flat || block.kind == BlockKind::uncovered ? 0 : 2);
            const std::size_t light_numbers = block_light_numbers(block.kind);
            for (std::size_t i = 0; i < light_numbers; ++i)
                largest = std::max(largest, std::abs(block.number[i]));
        }
    }
    if (nodes > block_bit || numbers > offset_mask)
        throw common::InputError(
            fmt::format("an adaptive light map of {} numbers is too large: fewer texels, please", numbers));
    unit_ = unit_for_halves(largest);
    node_.reserve(nodes);
    number_.reserve(numbers);
    for (const Draft& draft : drafts) {
        const auto base = static_cast<Node>(node_.size());
        Face& face = face_[face_index(draft.face.region, draft.face.back)];
        face.root = base;
        if (draft.flat) face.normal = pack_normal(draft.normal);
        for (const Node node : draft.node) {
            if ((node & block_bit) == 0) {
                node_.push_back(base + node);
                continue;
            }
            const Draft::Block& block = draft.block[node & offset_mask];
            node_.push_back(block_node(block.kind, number_.size()));
            if (!draft.flat && block.kind != BlockKind::uncovered)
                for (const std::uint16_t half_of_normal : pack_normal(block.normal))
                    number_.push_back(half_of_normal);
            const std::size_t light_numbers = block_light_numbers(block.kind);
            for (std::size_t i = 0; i < block.number.size(); ++i)
                number_.push_back(half_of(block.number[i], i < light_numbers ? unit_ : 1).bits());
        }
    }
}

std::size_t AdaptiveMap::bytes() const {
    return places_.bytes() + face_.capacity() * sizeof(Face) + node_.capacity() * sizeof(Node) +
           number_.capacity() * sizeof(number_[0]);
}

AdaptiveMap::Found AdaptiveMap::find(const Face& face, const TexelRegion& region, std::uint32_t x,
                                     std::uint32_t y) const {
    Found found{node_[face.root], 0, 0, std::bit_ceil(std::max(region.width, region.height))};
    while ((found.node & block_bit) == 0) {
        found.size /= 2;
        const std::uint32_t right = x >= found.x + found.size, below = y >= found.y + found.size;
        found.x += right * found.size;
        found.y += below * found.size;
        found.node = node_[found.node + 2 * below + right];
    }
    return found;
}

AdaptiveMap::StoredBlock AdaptiveMap::block_of(const Face& face, Node node) const {
    const BlockKind kind = kind_of(node);
    if (kind == BlockKind::uncovered) return {kind};
    const std::uint16_t* stored = number_.data() + (node & offset_mask);
    const std::uint16_t* packed = face.has_one_normal() ? face.normal.data() : stored;
    return {kind, unpack_normal(packed[0], packed[1]), stored + (face.has_one_normal() ? 0 : 2)};
}

template <Basis B>
typename B::Numbers AdaptiveMap::StoredBlock::numbers() const {
    typename B::Numbers numbers;
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = number_at(number, i);
    return numbers;
}

template <class Use>
void AdaptiveMap::for_blocks(const Face& face, const TexelPlace& place, Use use) const {
    const TexelRegion& region = places_.region(place);
    const std::uint32_t x = place.column(region), y = place.row(region);
    const Found own = find(face, region, x, y);
    if (!smooth_) {
        use(own.node, 1.0f);
        return;
    }

    // The blocks across the nearer border on either axis, and their weights.
    const auto half_size = static_cast<float>(own.size) / 2;
    const float from_x = place.at.x - (static_cast<float>(own.x) + half_size),
                from_y = place.at.y - (static_cast<float>(own.y) + half_size);
    const std::int64_t over_x = from_x < 0 ? std::int64_t{own.x} - 1 : std::int64_t{own.x} + own.size,
                       over_y = from_y < 0 ? std::int64_t{own.y} - 1 : std::int64_t{own.y} + own.size;
    const bool has_x = over_x >= 0 && over_x < region.width, has_y = over_y >= 0 && over_y < region.height;
    // The weight is a half on the border. It falls to 0 at a distance of half the width of the smaller block.
    const auto share = [&](float from, std::uint32_t other_size) {
        const float reach = static_cast<float>(std::min(own.size, other_size)) / 2;
        return std::clamp((std::abs(from) - (half_size - reach)) / (2 * reach), 0.0f, 0.5f);
    };
    Found beside{}, below{};
    float share_x = 0, share_y = 0;
    if (has_x) {
        beside = find(face, region, static_cast<std::uint32_t>(over_x), y);
        share_x = share(from_x, beside.size);
    }
    if (has_y) {
        below = find(face, region, x, static_cast<std::uint32_t>(over_y));
        share_y = share(from_y, below.size);
    }
    use(own.node, (1 - share_x) * (1 - share_y));
    if (share_x > 0) use(beside.node, share_x * (1 - share_y));
    if (share_y > 0) use(below.node, (1 - share_x) * share_y);
    if (share_x > 0 && share_y > 0)
        use(find(face, region, static_cast<std::uint32_t>(over_x), static_cast<std::uint32_t>(over_y)).node,
            share_x * share_y);
}

common::Rgb AdaptiveMap::irradiance(const common::SurfacePoint& point) const {
    const std::optional<TexelPlace> place = places_.find(point);
    if (!place) return {0, 0, 0};
    const Face& face = face_[face_index(place->region, place->back)];
    IrradianceMean mean;
    for_blocks(face, *place, [&](Node node, float weight) {
        const StoredBlock block = block_of(face, node);
        if (weight <= 0 || block.normal.dot(point.geometric_normal) <= common::same_surface_cosine) return;
        if (block.kind == BlockKind::dark) return mean.add(Rgb(0, 0, 0), weight);
        with_basis(block.kind, [&](auto basis) {
            using B = decltype(basis);
            mean.add(block_irradiance<B>(block.numbers<B>(), {face.has_one_normal(), block.normal},
                                         point.shading_normal),
                     weight);
        });
    });
    return mean.irradiance() * unit_;
}

std::optional<AdaptiveMap::FaceLight> AdaptiveMap::light_at(const TexelPlace& place) const {
    const Face& face = face_[face_index(place.region, place.back)];
    const Vec3 own = block_of(face, find(face, place).node).normal;
    if (own == Vec3(0, 0, 0)) return std::nullopt;
    TexelLight<2> sum;
    sum.fill(Rgb(0, 0, 0));
    float sum_of_weights = 0;
    for_blocks(face, place, [&](Node node, float weight) {
        const StoredBlock block = block_of(face, node);
        if (weight <= 0 || block.normal.dot(own) <= common::same_surface_cosine) return;
        sum_of_weights += weight;
        if (block.kind == BlockKind::dark) return;
        const TexelLight<2> moments = with_basis(block.kind, [&](auto basis) {
            return moments_of(basis, block.numbers<decltype(basis)>(), block.normal);
        });
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += moments[i] * weight;
    });
    for (Rgb& coefficient : sum) coefficient *= unit_ / sum_of_weights;
    return FaceLight{own, sum};
}

std::uint32_t AdaptiveMap::finest_block(std::uint32_t region) const {
    const TexelRegion& in = places_.region(region);
    std::uint32_t finest = 0;
    const auto look = [&](const auto& below, Node node, std::uint32_t size) -> void {
        if ((node & block_bit) == 0) {
            for (Node i = 0; i < 4; ++i) below(below, node_[node + i], size / 2);
        } else if (kind_of(node) != BlockKind::uncovered) {
            finest = finest == 0 ? size : std::min(finest, size);
        }
    };
    for (const bool back : {false, true})
        if (!back || in.both_faces)
            look(look, node_[face_[face_index(region, back)].root],
                 std::bit_ceil(std::max(in.width, in.height)));
    return finest;
}

std::optional<AdaptiveMap::BlockAt> AdaptiveMap::block_at(const common::SurfacePoint& point) const {
    const std::optional<TexelPlace> place = places_.find(point);
    if (!place) return std::nullopt;
    const Found own = find(face_[face_index(place->region, place->back)], *place);
    const BlockKind kind = kind_of(own.node);
    if (kind == BlockKind::uncovered) return std::nullopt;
    return BlockAt{kind, own.size};
}

}  // namespace shlm
