// Few hits for many texels: light as chance spreads it.
#pragma once

#include <cmath>

#include "bench/experiments/stability/known_light.h"
#include "bench/experiments/stability/unit_floor.h"

namespace bench::stability {

/// As many as intervals of mean 1, exponentially distributed, fit into `mean` (Knuth 1969, 3.4.1).
[[nodiscard]] inline std::size_t poisson(double mean, Generator& generator) {
    std::size_t count = 0;
    double used = -std::log(1.0 - uniform(generator));
    for (; used < mean; used -= std::log(1.0 - uniform(generator))) ++count;
    return count;
}

/// P(x) of a Poisson number x with this mean.
[[nodiscard]] inline double poisson_probability(double mean, int x) {
    return std::exp(x * std::log(mean) - mean - std::lgamma(x + 1.0));
}

/// P(at least `least`).
[[nodiscard]] inline double poisson_tail(double mean, int least) {
    double below = 0;
    for (int x = 0; x < least; ++x) below += poisson_probability(mean, x);
    return std::max(0.0, 1 - below);
}

/// The mean of `use(irradiance / truth)` over texels of even light in blocks of `least_hits`
/// (shlm/map/texel_blocks.h), where `hits_per_texel` fall on each on average: a block of m hits on average
/// shows x of them, which is x / m, if it has less than least_hits and its parent, with a Poisson number of
/// hits in its other three quarters, has as many. A texel is a block in any case. `levels`: how often the
/// whole is divided.
template <class Use>
[[nodiscard]] double mean_over_blocks(double hits_per_texel, int least_hits, int levels, Use use) {
    double sum = 0;
    for (int level = 0; level <= levels; ++level) {
        const double mean = hits_per_texel * std::pow(4.0, level);
        const int most = level > 0 ? least_hits - 1 : static_cast<int>(mean + 20 * std::sqrt(mean) + 50);
        for (int x = 0; x <= most; ++x) {
            const double divided = level == levels ? 1 : poisson_tail(3 * mean, std::max(0, least_hits - x));
            sum += poisson_probability(mean, x) * divided * use(x / mean);
        }
    }
    return sum;
}

/// Independent hits of vertical light on the quad that is the scene's first, `expected` of them on average;
/// each has the share of 1 W/m^2 that it has on average.
[[nodiscard]] inline common::HitBatch poisson_hits(const common::Scene& scene, double expected,
                                                   Generator& generator) {
    common::HitBatch hits;
    irradiate_quad(hits, scene, 0, poisson(expected, generator), generator, always({0, 0, -1}));
    const double area = common::triangle_area(scene, 0) + common::triangle_area(scene, 1);
    const auto each = static_cast<float>(area / expected);
    for (common::Rgb& flux : hits.flux) flux = {each, each, each};
    return hits;
}

/// A floor of 1 x 1 with 64 x 64 texels.
class SparseFloor {
  public:
    static constexpr int texels_along = 64, levels = 6;  // 64 = 2^6

    /// `hits_per_texel` hits to a texel on average, a Poisson number to each and independent.
    [[nodiscard]] common::HitBatch hits(double hits_per_texel, Generator& generator) const {
        return poisson_hits(scene, hits_per_texel * texels_along * texels_along, generator);
    }

    /// One in each texel from which four are seen, nearest to the corner that these share: the four nearest
    /// are these.
    [[nodiscard]] std::vector<common::SurfacePoint> points_among_four() const {
        std::vector<common::SurfacePoint> points;
        for (int j = 0; j + 1 < texels_along; ++j)
            for (int i = 0; i + 1 < texels_along; ++i)
                points.push_back(at((i + 0.8) / texels_along, (j + 0.8) / texels_along));
        return points;
    }

    [[nodiscard]] common::SurfacePoint middle_of_texel(int i, int j) const {
        return at((i + 0.5) / texels_along, (j + 0.5) / texels_along);
    }
    [[nodiscard]] std::vector<common::SurfacePoint> middles_of_texels() const {
        std::vector<common::SurfacePoint> points;
        for (int j = 0; j < texels_along; ++j)
            for (int i = 0; i < texels_along; ++i) points.push_back(middle_of_texel(i, j));
        return points;
    }

    /// 5 x 5 points far from the floor's edges.
    [[nodiscard]] std::vector<common::SurfacePoint> points_in_the_middle() const {
        std::vector<common::SurfacePoint> points;
        for (int j = 0; j < 5; ++j)
            for (int i = 0; i < 5; ++i) points.push_back(at(0.3 + 0.1 * i, 0.3 + 0.1 * j));
        return points;
    }

    const common::Scene& scene = unit_floor();
    shlm::PreparedTexels texels = texels_of(scene, texels_along* texels_along);

  private:
    [[nodiscard]] static common::SurfacePoint at(double x, double y) {
        return on_unit_floor(static_cast<float>(x), static_cast<float>(y));
    }
};

/// Where the truth is 1.
[[nodiscard]] inline double square_of_error(double irradiance) {
    return (irradiance - 1) * (irradiance - 1);
}

/// The mean of `use(irradiance)` over the points.
template <common::IrradianceEstimator Map, class Use>
[[nodiscard]] double mean_of(const Map& map, std::span<const common::SurfacePoint> points, Use use) {
    double sum = 0;
    for (const common::SurfacePoint& point : points)
        sum += use(common::mean_component(map.irradiance(point)));
    return sum / static_cast<double>(points.size());
}

}  // namespace bench::stability
