#include "shlm/adaptive/block_costs.h"

#include <algorithm>

#include "common/core/sampling.h"

namespace shlm {
namespace {

using common::Rgb;
using common::Vec3;

/// The smallest block around a texel with this many hits determines how bright it is there.
constexpr double hits_to_know = 100;

/// What one hit of uniform light adds, divided by the squared sine of the angle between a normal and the
/// surface's: to the relative variance of (irradiance of the normal - that of the surface), and to the mean
/// squared relative difference of that irradiance from F2's. Integrated over hits with cosine density, whose
/// inverse cosine is clamped at 1000; AD by Monte Carlo. Accurate to a fifth from 15 to 60 degrees. YF2 has
/// the noise of F2, as all channels come with the same hits.
struct DirectionNoise {
    double of_irradiance, of_difference;
};
constexpr double f2_noise = 4.0;
constexpr std::array<DirectionNoise, block_kinds> direction_noise = {{{0, 0},           // uncovered
                                                                      {0, 0},           // dark
                                                                      {0, f2_noise},    // F0
                                                                      {4.5, 0.5},       // AD
                                                                      {f2_noise, 0},    // YF2
                                                                      {5.0, 0.4},       // F1
                                                                      {f2_noise, 0}}};  // F2

/// A mean of n squares is distinguished from noise if it exceeds the expected noise by this many standard
/// deviations. For normally distributed numbers its relative standard deviation is sqrt(2 / n).
constexpr double significance = 2;

/// Returns the part of a mean of squares that is light: the mean less the expected noise if it can be
/// distinguished from noise, else 0. To subtract two standard deviations as well would underestimate all
/// light.
double beyond_noise(double found, double expected, double squares) {
    const double largest = expected * (1 + significance * std::sqrt(2 / std::max(squares, 1.0)));
    return found > largest ? found - expected : 0;
}

/// Degrees of freedom of the noise over directions: about the coefficients of F1 other than its constant.
constexpr double direction_squares = 3;

/// The light and the density of hits around a texel.
struct Neighbourhood {
    Rgb irradiance{0, 0, 0};
    double hits_per_area = 0;
};

/// Sums over the texels of a block, per channel: of weight * area, weight * area * E, weight * area * E^2,
/// and weight * area * variance of E.
struct SquareSums {
    std::array<double, 3> weight{}, first{}, second{}, noise{};
    double texels = 0;

    void operator+=(const SquareSums& part) {
        for (std::size_t c = 0; c < 3; ++c) {
            weight[c] += part.weight[c];
            first[c] += part.first[c];
            second[c] += part.second[c];
            noise[c] += part.noise[c];
        }
        texels += part.texels;
    }
};

class CostsOfFace {
  public:
    CostsOfFace(const LightPyramid& pyramid, const NormalsInUse& normals, const LightStatistics& statistics)
        : pyramid_(pyramid), normals_(normals), statistics_(statistics), costs_(pyramid.block_count()) {
        for (const Vec3& bent : normals.bent) {
            const float sine = std::sqrt(std::max(1 - bent.z * bent.z, 0.0f));
            bent_.push_back({bent, {bent.z, sine}, {bent.z, sine}, {}, {}, {}, {}});
        }
        (void)visit(pyramid.levels() - 1, 0, 0, {}, true);
    }

    [[nodiscard]] std::vector<BlockCosts> take() && { return std::move(costs_); }

  private:
    SquareSums visit(std::size_t level, std::uint32_t x, std::uint32_t y, Neighbourhood around, bool asked) {
        const LightBlock& block = pyramid_.block(level, x, y);
        SquareSums sums;
        if (block.surface.area == 0) return sums;
        if (around.hits_per_area == 0 || (block.hits >= hits_to_know && block.surface.one))
            around = {block.light().surface, block.hits / block.surface.area};
        if (level == 0)
            sums = texel_sums(block, around);
        else
            pyramid_.for_children(level, x, y, [&](auto cx, auto cy) {
                sums += visit(level - 1, cx, cy, around, asked && !stays_whole(block));
            });
        if (asked) set_errors(block, around, sums, costs_[pyramid_.index(level, x, y)]);
        return sums;
    }

    [[nodiscard]] SquareSums texel_sums(const LightBlock& block, const Neighbourhood& around) const {
        SquareSums sums;
        sums.texels = 1;
        const Rgb own = block.light().surface;
        const double noise = noise_of(block.surface.area, around);
        for (std::size_t c = 0; c < 3; ++c) {
            const auto channel = static_cast<int>(c);
            const double e = own[channel], brightness_sq = square(around.irradiance[channel]);
            const double weight = block.surface.area / (brightness_sq + statistics_.epsilon);
            sums.weight[c] = weight;
            sums.first[c] = weight * e;
            sums.second[c] = weight * e * e;
            sums.noise[c] = weight * brightness_sq * noise;
        }
        return sums;
    }

    /// Returns the relative variance of an area's irradiance, from its expected, not its actual, number of
    /// hits.
    [[nodiscard]] double noise_of(double area, const Neighbourhood& around) const {
        return around.hits_per_area > 0 ? statistics_.noise_of_a_hit / (around.hits_per_area * area) : 0;
    }

    void set_errors(const LightBlock& block, const Neighbourhood& around, const SquareSums& sums,
                    BlockCosts& costs) {
        const BlockLight light = block.light();
        answer_by_f2(light, block.surface.unit_normal());
        double dark = 0, by_space = 0, noise = 0, relative_light = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const double e = light.surface[static_cast<int>(c)];
            dark += beyond_noise(sums.second[c], sums.noise[c], sums.texels);
            const double spread = sums.second[c] - 2 * e * sums.first[c] + e * e * sums.weight[c];
            const double expected = sums.noise[c] * (1 - 1 / sums.texels);
            by_space += beyond_noise(spread, expected, sums.texels - 1);
            noise += sums.noise[c] / sums.texels;
            relative_light += sums.weight[c] * square(around.irradiance[static_cast<int>(c)]);
        }
        const auto set = [&](BlockKind kind, double error_sq) {
            costs.error_sq[static_cast<std::size_t>(kind)] = static_cast<float>(error_sq / 3);
        };
        set(BlockKind::dark, dark);
        const double direction = relative_light * noise_of(block.surface.area, around) * normals_.sine_sq();
        for (std::size_t k = static_cast<std::size_t>(BlockKind::F0); k < block_kinds; ++k) {
            const auto kind = static_cast<BlockKind>(k);
            double left_out = 0;
            if (!bent_.empty() && kind != BlockKind::F2)
                left_out = beyond_noise(left_out_by(kind, light, block.surface.unit_normal(), sums),
                                        direction * direction_noise[k].of_difference, direction_squares);
            set(kind, by_space + noise + left_out + direction * direction_noise[k].of_irradiance);
        }
    }

    /// Turns the normals in use to the block and evaluates F2 for them.
    void answer_by_f2(const BlockLight& light, const Vec3& face_normal) {
        if (bent_.empty()) return;
        const common::Frame frame(face_normal);
        const auto numbers = numbers_of<HemisphereFit<2>>(light, face_normal);
        for (Bent& bent : bent_) {
            bent.normal = frame.to_world(bent.in_frame);
            const BlockFace face{pyramid_.is_flat(), face_normal};
            bent.factors_1 = block_factors<1>(face, bent.normal, [&] {
                return fitted_factors<1>(bent.cosine_1.of(face_normal, bent.normal));
            });
            bent.factors_2 = block_factors<2>(face, bent.normal, [&] {
                return fitted_factors<2>(bent.cosine_2.of(face_normal, bent.normal));
            });
            bent.by_f2 = HemisphereFit<2>::irradiance(numbers, bent.factors_2);
        }
    }

    /// Returns the mean squared difference from F2 over the normals in use, weighted as SquareSums::weight.
    [[nodiscard]] double left_out_by(BlockKind kind, const BlockLight& light, const Vec3& face_normal,
                                     const SquareSums& sums) const {
        return with_basis(kind, [&](auto basis) {
            using B = decltype(basis);
            const auto numbers = numbers_of<B>(light, face_normal);
            double error_sq = 0;
            for (const Bent& bent : bent_)
                error_sq += weighted_square(irradiance<B>(numbers, face_normal, bent) - bent.by_f2, sums);
            return error_sq / static_cast<double>(bent_.size());
        });
    }

    [[nodiscard]] static double weighted_square(const Rgb& error, const SquareSums& sums) {
        double sum = 0;
        for (std::size_t c = 0; c < 3; ++c) sum += sums.weight[c] * square(error[static_cast<int>(c)]);
        return sum;
    }

    [[nodiscard]] static double square(double x) { return x * x; }

    const LightPyramid& pyramid_;
    const NormalsInUse& normals_;
    const LightStatistics& statistics_;
    std::vector<BlockCosts> costs_;

    /// One of the normals in use.
    struct Bent {
        Vec3 in_frame;
        FittedClampedCosine<1> cosine_1;
        FittedClampedCosine<2> cosine_2;
        // For the block whose errors are set:
        Vec3 normal;
        ShValues<1> factors_1;
        ShValues<2> factors_2;
        Rgb by_f2;  ///< irradiance

        template <int Order>
        [[nodiscard]] const ShValues<Order>& factors() const {
            if constexpr (Order == 1)
                return factors_1;
            else
                return factors_2;
        }
    };
    std::vector<Bent> bent_;

    template <class B>
    [[nodiscard]] static Rgb irradiance(const typename B::Numbers& numbers, const Vec3& face_normal,
                                        const Bent& bent) {
        if constexpr (HasFactors<B>)
            return B::irradiance(numbers, bent.factors<B::order>());
        else
            return B::irradiance(numbers, face_normal, typename B::Question(bent.normal));
    }
};

/// Let n hits fall on parts at random, and let v be the relative variance of a hit's light. Then n times the
/// sum of share (E of the part / E of all - 1)^2 is distributed as v times a chi-squared variable, whatever
/// the parts' shares of the area. It has one degree of freedom less than there are parts. Differences of
/// light between the parts only add to it, so that its lower quartile is mostly noise. With one degree of
/// freedom, its few values are too coarse for a quartile.
constexpr std::size_t least_parts = 3;
constexpr std::array<double, 2> lower_quartile_of_chi_sq = {0.57536, 1.21253};  // for 2 and 3 degrees

/// Returns estimates of v, scaled so that their lower quartile is v. They come from all blocks of three and
/// four parts with similar coverage and few hits, so that noise is most of the differences. Such blocks exist
/// everywhere, whatever the texels' size.
std::vector<double> noise_ratios(const LightPyramid& pyramid) {
    constexpr double least_hits = 16, most_hits = 64, least_share = 0.15;
    std::vector<double> ratios;
    for (std::size_t level = 1; level < pyramid.levels(); ++level)
        for (std::uint32_t y = 0; y < pyramid.height(level); ++y)
            for (std::uint32_t x = 0; x < pyramid.width(level); ++x) {
                const LightBlock& block = pyramid.block(level, x, y);
                if (!block.surface.one || block.hits < least_hits || block.hits > most_hits) continue;
                const double mean = common::mean_component(block.light().surface);
                double spread = 0;
                std::size_t parts = 0;
                bool alike = mean > 0;
                pyramid.for_children(level, x, y, [&](auto cx, auto cy) {
                    const LightBlock& part = pyramid.block(level - 1, cx, cy);
                    const double share = part.surface.area / block.surface.area;
                    if (share == 0) return;
                    alike = alike && share > least_share;
                    const double difference = common::mean_component(part.light().surface) / mean - 1;
                    spread += share * difference * difference;
                    ++parts;
                });
                if (alike && parts >= least_parts)
                    ratios.push_back(block.hits * spread / lower_quartile_of_chi_sq[parts - least_parts]);
            }
    return ratios;
}

}  // namespace

LightStatistics light_statistics(std::span<const LightPyramid> pyramids) {
    double area = 0, light = 0;
    std::vector<double> ratios;
    for (const LightPyramid& pyramid : pyramids) {
        const LightBlock& all = pyramid.largest_block();
        area += all.surface.area;
        light += all.surface.area * double{common::mean_component(all.light().surface)};
        const std::vector<double> found = noise_ratios(pyramid);
        ratios.insert(ratios.end(), found.begin(), found.end());
    }
    LightStatistics statistics;
    if (light > 0) statistics.epsilon = 0.01 * (light / area) * (light / area);
    constexpr std::size_t least_ratios = 100;
    if (ratios.size() >= least_ratios) {
        const auto quartile = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 4);
        std::nth_element(ratios.begin(), quartile, ratios.end());
        statistics.noise_of_a_hit = std::max(*quartile, 1.0);
    }
    return statistics;
}

std::vector<BlockCosts> block_costs(const LightPyramid& pyramid, const NormalsInUse& normals,
                                    const LightStatistics& statistics) {
    return CostsOfFace(pyramid, normals, statistics).take();
}

}  // namespace shlm
