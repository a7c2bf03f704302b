#include "photonmap/index/cell_grid.h"

namespace photonmap {

CellGrid::CellGrid(const Imath::Box3f& bounds, std::size_t points)
    : low_(points > 0 ? bounds.min : common::Vec3(0, 0, 0)), cells_per_unit_(0), levels_(0) {
    const common::Vec3 size = points > 0 ? bounds.size() : common::Vec3(0, 0, 0);
    const float widest = std::max({size.x, size.y, size.z});
    if (widest > 0 && std::isfinite(16 / widest)) cells_per_unit_ = 16 / widest;
    // Photons lie on surfaces, which pass through only some cells. A cell of this size is worth its own tree.
    constexpr std::size_t points_per_cell = 1024;
    while (levels_ < max_levels && points >> (4 * (levels_ + 1)) >= points_per_cell) ++levels_;
}

}  // namespace photonmap
