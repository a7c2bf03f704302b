#include "common/difference/plane.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

namespace common {
namespace {

/// sum += weight * values, `count` numbers of each.
void add_scaled(float* sum, const float* values, float weight, int count) {
    for (int i = 0; i < count; ++i) sum[i] += weight * values[i];
}

Plane filtered_along_rows(const Plane& plane, const Kernel& kernel) {
    const int radius = kernel.radius();
    Plane result(plane.width, plane.height);
    tbb::parallel_for(0, plane.height, [&](int y) {
        const float* row = plane.row(y);
        std::vector<float> padded(plane.width + 2 * radius, row[0]);
        std::copy_n(row, plane.width, padded.begin() + radius);
        std::fill_n(padded.end() - radius, radius, row[plane.width - 1]);
        for (int i = 0; i <= 2 * radius; ++i)
            add_scaled(result.row(y), padded.data() + i, kernel.weights[i], plane.width);
    });
    return result;
}

Plane filtered_along_columns(const Plane& plane, const Kernel& kernel) {
    const int radius = kernel.radius();
    Plane result(plane.width, plane.height);
    tbb::parallel_for(0, plane.height, [&](int y) {
        for (int i = 0; i <= 2 * radius; ++i) {
            const int from = std::clamp(y + i - radius, 0, plane.height - 1);
            add_scaled(result.row(y), plane.row(from), kernel.weights[i], plane.width);
        }
    });
    return result;
}

}  // namespace

Plane filtered(const Plane& plane, const Kernel& horizontal, const Kernel& vertical) {
    return filtered_along_columns(filtered_along_rows(plane, horizontal), vertical);
}

}  // namespace common
