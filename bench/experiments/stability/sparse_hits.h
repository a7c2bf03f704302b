// Few hits for many texels, distributed at random.
#pragma once

#include <cmath>

#include "bench/experiments/stability/known_light.h"
#include "bench/experiments/stability/unit_floor.h"

namespace bench::stability {

/// Draws a Poisson number: how many exponentially distributed intervals of mean 1 fit into `mean` (Knuth
/// 1969, 3.4.1).
[[nodiscard]] inline std::size_t poisson(double mean, Generator& generator) {
    std::size_t count = 0;
    double used = -std::log(1.0 - uniform(generator));
    for (; used < mean; used -= std::log(1.0 - uniform(generator))) ++count;
    return count;
}

/// Returns P(x) of a Poisson number with this mean.
[[nodiscard]] inline double poisson_probability(double mean, int x) {
    return std::exp(x * std::log(mean) - mean - std::lgamma(x + 1.0));
}

/// Returns P(at least `least`) of a Poisson number with this mean.
[[nodiscard]] inline double poisson_tail(double mean, int least) {
    double below = 0;
    for (int x = 0; x < least; ++x) below += poisson_probability(mean, x);
    return std::max(0.0, 1 - below);
}

/// Returns the mean of `use(irradiance / truth)` over texels in uniform light, which are shown in blocks of
/// `least_hits` (shlm/map/texel_blocks.h). A texel gets `hits_per_texel` on average. A block of m expected
/// and x actual hits shows x / m. It is shown if it has fewer than least_hits, and its parent, with a Poisson
/// number of hits in the other three quarters, has at least that many. A single texel is a block in any case.
/// `levels` is how often the whole is divided.
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

/// Makes independent hits of vertical light on the scene's first quad, `expected` of them on average. Each
/// has the flux that gives 1 W/m^2 on average.
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

    /// Makes independent hits, a Poisson number in each texel with the mean `hits_per_texel`.
    [[nodiscard]] common::HitBatch hits(double hits_per_texel, Generator& generator) const {
        return poisson_hits(scene, hits_per_texel * texels_along * texels_along, generator);
    }

    /// Returns a point in each texel that is part of a 2 x 2 group, close to the corner that the group
    /// shares: the four nearest texels are the group.
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

    /// Returns 5 x 5 points far from the floor's edges.
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

/// Returns the squared error where the truth is 1.
[[nodiscard]] inline double square_of_error(double irradiance) {
    return (irradiance - 1) * (irradiance - 1);
}

/// Returns the mean of `use(irradiance)` over the points.
template <common::IrradianceEstimator Map, class Use>
[[nodiscard]] double mean_of(const Map& map, std::span<const common::SurfacePoint> points, Use use) {
    double sum = 0;
    for (const common::SurfacePoint& point : points)
        sum += use(common::mean_component(map.irradiance(point)));
    return sum / static_cast<double>(points.size());
}

}  // namespace bench::stability
