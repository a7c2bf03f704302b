// Which triangles form one surface, and which surfaces meet. This tells a surface from another that lies
// close to it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "common/scene/scene.h"

namespace common {

/// Triangles that meet at an edge within 25 degrees belong to one piece, however far it bends in total.
inline constexpr float same_piece_cosine = 0.9f;

/// The pieces of one scene. Edges are the same if both ends have the same positions, whatever mesh or
/// instance the triangles belong to. Two triangles that overlap from their common edge on do not meet there.
class SurfacePieces {
  public:
    explicit SurfacePieces(const Scene& scene);

    [[nodiscard]] std::uint32_t count() const {
        return static_cast<std::uint32_t>(first_touching_.size() - 1);
    }

    /// Returns a piece. Pieces are numbered from 0 in the order of their first triangles.
    [[nodiscard]] std::uint32_t of_triangle(std::uint32_t triangle) const { return piece_of_[triangle]; }

    /// Returns the pieces that share an edge with it, in ascending order.
    [[nodiscard]] std::span<const std::uint32_t> touching(std::uint32_t piece) const {
        return std::span(touching_).subspan(first_touching_[piece],
                                            first_touching_[piece + 1] - first_touching_[piece]);
    }

    /// Returns whether both are the same piece or share an edge.
    [[nodiscard]] bool meet(std::uint32_t a, std::uint32_t b) const {
        if (a == b) return true;
        const std::span<const std::uint32_t> others = touching(a);
        return std::binary_search(others.begin(), others.end(), b);
    }

    [[nodiscard]] std::size_t bytes() const {
        return (piece_of_.capacity() + first_touching_.capacity() + touching_.capacity()) *
               sizeof(std::uint32_t);
    }

  private:
    std::vector<std::uint32_t> piece_of_;        ///< per triangle
    std::vector<std::uint32_t> first_touching_;  ///< per piece, into `touching_`; one more at the end
    std::vector<std::uint32_t> touching_;
};

}  // namespace common
