// Finds the texels that contribute to a point, and their weights.
#pragma once

#include <cmath>
#include <vector>

#include "common/estimator/irradiance_estimator.h"
#include "common/point_index/nearest_set.h"
#include "shlm/layout/prepared_texels.h"
#include "shlm/layout/texel_places.h"
#include "shlm/map/gather.h"

namespace shlm {

/// What a lookup needs to know of a texel of the finished map.
struct TexelFace {
    common::Vec3 normal;  ///< unit, out of the face
    float area;           ///< in one unit for all texels of a map; 0: no triangle covers the texel

    [[nodiscard]] bool looks_the_way_of(const common::SurfacePoint& point) const {
        return area > 0 && normal.dot(point.geometric_normal) > common::same_surface_cosine;
    }

    [[nodiscard]] const TexelFace& unpacked() const { return *this; }
};

// Each lookup determines which texels of the layout the finished map holds, in its own order. It calls
// `use(index, weight)` for those that contribute to a point; `face(index)` is the TexelFace of one of them.
// Weights need not add up to 1.

/// The texel that contains the point; nothing if there is none.
class OwnTexelLookup {
  public:
    OwnTexelLookup(const PreparedTexels& texels, OwnTexel) : places_(texels.layout) {}

    [[nodiscard]] static std::vector<std::uint32_t> held_texels(const PreparedTexels& texels);

    template <class Face, class Use>
    void visit(const common::SurfacePoint& point, Face, Use use) const {
        const std::optional<TexelPlace> place = places_.find(point);
        if (!place) return;
        const TexelRegion& region = places_.region(*place);
        use(region.first_texel_of(place->back) + place->row(region) * region.width + place->column(region),
            1.0f);
    }

    [[nodiscard]] std::size_t bytes() const { return places_.bytes(); }

  private:
    TexelPlaces places_;
};

/// The four texels around the point in its chart's rectangle of the lightmap, weighted by their
/// covered areas too, without those that face another way. It does not interpolate across seams of the
/// lightmap.
class BilinearLookup {
  public:
    explicit BilinearLookup(const TexelLayout& layout) : places_(layout) {}
    BilinearLookup(const PreparedTexels& texels, Bilinear) : BilinearLookup(texels.layout) {}

    [[nodiscard]] static std::vector<std::uint32_t> held_texels(const PreparedTexels& texels) {
        return OwnTexelLookup::held_texels(texels);
    }

    template <class Face, class Use>
    void visit(const common::SurfacePoint& point, Face face, Use use) const {
        const std::optional<TexelPlace> place = places_.find(point);
        if (!place) return;
        const TexelRegion& region = places_.region(*place);
        const common::Vec2 at = place->at - common::Vec2(0.5f, 0.5f);
        const float left = std::floor(at.x), top = std::floor(at.y);
        const std::uint32_t first = region.first_texel_of(place->back);
        for (int dy = 0; dy < 2; ++dy)
            for (int dx = 0; dx < 2; ++dx) {
                const int x = static_cast<int>(left) + dx, y = static_cast<int>(top) + dy;
                if (x < 0 || y < 0 || x >= static_cast<int>(region.width) ||
                    y >= static_cast<int>(region.height))
                    continue;
                const std::uint32_t texel =
                    first + static_cast<std::uint32_t>(y) * region.width + static_cast<std::uint32_t>(x);
                const float across = dx == 0 ? 1 - (at.x - left) : at.x - left;
                const float down = dy == 0 ? 1 - (at.y - top) : at.y - top;
                if (const TexelFace found = face(texel); found.looks_the_way_of(point))
                    use(texel, across * down * found.area);
            }
    }

    [[nodiscard]] std::size_t bytes() const { return places_.bytes(); }

  private:
    TexelPlaces places_;
};

/// The nearest texels in space that face as the point does, within TexelTree::max_radius, weighted by their
/// areas projected onto its surface. If NearestTexels asks for those of the own surface, others contribute
/// only if it has no texels within that radius.
class NearestTexelsLookup {
  public:
    NearestTexelsLookup(const PreparedTexels& texels, NearestTexels nearest)
        : tree_(texels.tree()),
          pieces_(nearest.of_own_surface ? texels.pieces : nullptr),
          count_(nearest.count) {}

    /// Returns the covered ones.
    [[nodiscard]] static std::vector<std::uint32_t> held_texels(const PreparedTexels& texels);

    template <class Face, class Use>
    void visit(const common::SurfacePoint& point, Face face, Use use) const {
        static thread_local std::vector<common::Neighbour> neighbours;  // a gather must not allocate
        neighbours.resize(count_);
        const auto use_nearest = [&](auto accept, auto keep) {
            common::NearestSet nearest(neighbours, tree_->max_radius() * tree_->max_radius());
            tree_->search(point.position, nearest,
                          [&](std::uint32_t i) { return face(i).looks_the_way_of(point) && accept(i); });
            bool used = false;
            for (const common::Neighbour& neighbour : nearest.found()) {
                if (!keep(neighbour.index)) continue;
                const TexelFace found = face(neighbour.index);
                use(neighbour.index, found.area * found.normal.dot(point.geometric_normal));
                used = true;
            }
            return used;
        };
        constexpr auto any = [](std::uint32_t) { return true; };
        if (!pieces_) {
            use_nearest(any, any);
            return;
        }
        const std::uint32_t own = pieces_->of_triangle(point.surface.triangle);
        const auto of_own_surface = [&](std::uint32_t i) { return pieces_->meet(own, tree_->piece(i)); };
        (void)(use_nearest(any, of_own_surface) || use_nearest(of_own_surface, any) || use_nearest(any, any));
    }

    [[nodiscard]] std::size_t bytes() const {
        return tree_->bytes() + (pieces_ ? tree_->bytes_of_pieces() + pieces_->bytes() : 0);
    }

  private:
    std::shared_ptr<const TexelTree> tree_;
    std::shared_ptr<const TexelPieces> pieces_;  ///< null if the nearest of all surfaces are used
    std::size_t count_;
};

using TexelLookup = std::variant<OwnTexelLookup, BilinearLookup, NearestTexelsLookup>;

[[nodiscard]] TexelLookup make_lookup(const PreparedTexels& texels, const Gather& gather);

}  // namespace shlm
