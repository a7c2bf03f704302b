#include "bench/experiments/bases/basis_figures.h"

#include <algorithm>
#include <map>

#include "bench/experiments/bases/basis_error.h"

namespace bench::bases {
namespace {

constexpr common::Vec3 own_normal(0, 0, 1);

/// Errors of one basis, one element per environment.
struct BasisErrors {
    std::vector<double> series, answered;  ///< errors in %
    std::vector<double> at_own_normal;     ///< series over truth
};

double mean_of(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

ErrorFigures figures_of(const std::vector<double>& errors) {
    return {mean_of(errors), *std::max_element(errors.begin(), errors.end())};
}

/// Adds the errors of one environment. `normals` ends with the surface's own normal, which is not part of the
/// error.
void add_errors(const Basis& basis, const OneTexel& texel, const common::HitBatch& photons,
                std::span<const common::Vec3> normals, std::span<const double> truth, BasisErrors& errors) {
    const BasisAnswers answers = basis.ask(texel, photons, normals);
    const std::size_t tilted = normals.size() - 1;
    const std::span series(answers.series), answered(answers.answered);
    errors.series.push_back(relative_rms_percent(series.first(tilted), truth.first(tilted)));
    errors.answered.push_back(relative_rms_percent(answered.first(tilted), truth.first(tilted)));
    errors.at_own_normal.push_back(series.back() / truth.back());
}

}  // namespace

std::optional<std::vector<BasisFigures>> measure_bases(std::span<const Basis> bases, LightKind kind,
                                                       std::size_t count, std::uint64_t seed,
                                                       const std::function<bool()>& go_on) {
    const OneTexel texel;
    std::vector<common::Vec3> normals = tilted_normals();
    normals.push_back(own_normal);
    const std::size_t environments = environment_count(kind, count);
    std::vector<BasisErrors> errors(bases.size());
    for (std::uint32_t i = 0; i < environments; ++i) {
        if (!go_on()) return std::nullopt;
        const Environment environment = make_environment(kind, i, environments, seed);
        const std::vector<double> truth = true_irradiance(environment, normals);
        const common::HitBatch photons = texel.photons_of(environment);
        for (std::size_t b = 0; b < bases.size(); ++b)
            add_errors(bases[b], texel, photons, normals, truth, errors[b]);
    }
    std::vector<BasisFigures> figures;
    for (std::size_t b = 0; b < bases.size(); ++b)
        figures.push_back({kind, bases[b], environments, figures_of(errors[b].series),
                           figures_of(errors[b].answered), mean_of(errors[b].at_own_normal)});
    return figures;
}

std::optional<ExpectedFigures> expected_figures(LightKind kind, const std::string& basis) {
    using enum LightKind;
    static const std::map<std::pair<LightKind, std::string>, ExpectedFigures> expected = {
        {{point, "L0/normalised"}, {79.6, 117}},  {{point, "L2/radiance"}, {8.7, 14}},
        {{point, "L4/radiance"}, {4.4, 7.3}},     {{room, "L0/normalised"}, {28.6, 47}},
        {{room, "L2/radiance"}, {0.8, 1.9}},      {{room, "L4/radiance"}, {0.2, 0.7}},

        {{uniform, "L0/normalised"}, {16.5, {}}}, {{uniform, "L2/radiance"}, {0, {}}},
        {{uniform, "L4/radiance"}, {0, {}}},      {{point, "F0/flux"}, {70.7, 120}},
        {{room, "F0/flux"}, {19.1, {}}},          {{point, "F1/radiance"}, {17.5, 41.4}},
        {{room, "F1/radiance"}, {2.98, {}}},      {{point, "F2/radiance"}, {7.17, 11.8}},
        {{room, "F2/radiance"}, {0.55, {}}},      {{uniform, "F0/flux"}, {0, {}}},
        {{uniform, "F1/radiance"}, {0, {}}},      {{uniform, "F2/radiance"}, {0, {}}}};
    const auto found = expected.find({kind, basis});
    return found == expected.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace bench::bases
