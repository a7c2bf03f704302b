#include "bench/experiments/fit/explanation.h"

#include <algorithm>

#include "bench/contenders/adaptive_map.h"
#include "bench/contenders/light_map.h"
#include "bench/experiments/fit/traced_run.h"
#include "common/core/input_error.h"
#include "common/view/visible_surfaces.h"
#include "shlm/adaptive/adaptive_map.h"

namespace bench::fit {
namespace {

constexpr int picture_width = 240, picture_height = 135;

/// Returns the measure with zero weight at all points that are not on this instance.
Measure measure_of(const Measure& all, const FitPoints& points, const common::Scene& scene,
                   std::uint32_t instance) {
    Measure measure = all;
    for (std::size_t i = 0; i < points.point.size(); ++i)
        if (scene.instance_of[points.point[i].surface.triangle] != instance)
            measure.weight[i] = common::Rgb(0, 0, 0);
    return measure;
}

std::vector<SurfaceError> surface_errors(const FitResult& result, const PilotSubject& subject) {
    const Proposal& choice = result.light_map.choice.proposal;
    const PilotSample& sample = result.samples[choice.candidate];
    if (!sample.present()) return {};
    const FitPoints& points = subject.points;
    const common::Scene& scene = subject.loaded.scene;
    const Measure all(result.estimates.best_answers, points.tile, points.tiling);
    std::vector<double> points_of(scene.instance.size());
    for (const common::SurfacePoint& point : points.point)
        ++points_of[scene.instance_of[point.surface.triangle]];
    std::vector<SurfaceError> surfaces;
    for (std::uint32_t i = 0; i < points_of.size(); ++i) {
        if (points_of[i] == 0) continue;
        const Measure measure = measure_of(all, points, scene, i);
        surfaces.push_back(
            {.instance = i,
             .points = points_of[i] / static_cast<double>(points.point.size()),
             .noise_sq = noise_sq(sample.halves, measure) * sample.cost.hits / choice.hits,
             .bias_sq = squared_difference(sample.halves, result.estimates.truth, measure).value});
    }
    std::stable_sort(surfaces.begin(), surfaces.end(), [](const SurfaceError& a, const SurfaceError& b) {
        return a.noise_sq + a.bias_sq > b.noise_sq + b.bias_sq;
    });
    return surfaces;
}

/// Traces the adaptive map again with the pilot's seed.
shlm::AdaptiveMap traced_map(const Contender& contender, std::uint64_t hits, const PilotSubject& subject) {
    FilledStore store({contender}, subject.prepared, subject.source);
    const common::TraceReport trace = traced_run(contender.name, subject.loaded, subject.source, subject.seed,
                                                 {.hits = hits}, std::span(&store, 1), StopRule());
    return dynamic_cast<const AdaptiveLightMap&>(*contender.technique).map_of(*store.store, trace);
}

/// Returns the widths that texels would have if they were covered whole, in scene units. Adaptive maps
/// measure the widths of their blocks in this way.
std::vector<float> widths_of_whole_texels(const shlm::PreparedTexels& texels) {
    std::vector<float> width(texels.geometry.size());
    for (const shlm::TexelRegion& region : texels.layout.regions())
        for (const bool back : {false, true}) {
            if (back && !region.both_faces) continue;
            const std::uint32_t first = region.first_texel_of(back);
            const std::size_t count = region.texels_per_face();
            std::fill_n(width.begin() + first, count,
                        shlm::texel_width(std::span(texels.geometry).subspan(first, count)));
        }
    return width;
}

/// Returns the width of each texel in scene units; for an adaptive map, the width of a block of one texel.
std::vector<float> widths_of_texels(const shlm::PreparedTexels& texels, bool adaptive) {
    if (adaptive) return widths_of_whole_texels(texels);
    std::vector<float> width;
    for (const shlm::TexelGeometry& texel : texels.geometry) width.push_back(std::sqrt(texel.area));
    return width;
}

std::optional<SeenBlock> seen_block(const common::VisibleSurface& seen, const shlm::TexelLayout& layout,
                                    std::span<const float> width, const common::Scene& scene,
                                    const std::string& basis, const shlm::AdaptiveMap* adaptive) {
    if (!seen.present) return std::nullopt;
    const common::SurfaceId& surface = seen.point.surface;
    const shlm::TriangleTexels& triangle = layout.triangle(surface.triangle);
    if (triangle.width == 0 || (!seen.point.front && !triangle.both_faces)) return std::nullopt;
    const std::uint32_t texel = shlm::texel_at(triangle, surface.u, surface.v, seen.point.front);
    SeenBlock block{scene.instance_of[surface.triangle], basis, width[texel]};
    if (!adaptive) return block;
    const auto at = adaptive->block_at(seen.point);
    if (!at) return std::nullopt;
    block.kind = shlm::block_kind_names[static_cast<std::size_t>(at->kind)];
    block.width *= static_cast<float>(at->width);
    return block;
}

}  // namespace

Explanation explain(const FitResult& result, const PilotSubject& subject) {
    const Proposal& choice = result.light_map.choice.proposal;
    if (choice.hits == 0) throw common::InputError("--explain: no light map could be measured");
    const Candidate& candidate = result.candidates[choice.candidate];
    const auto hits = static_cast<std::uint64_t>(choice.hits);
    const Contender method = candidate.contender(hits);
    const shlm::PreparedTexels& texels = method.light_map()->texels_of(subject.prepared);
    const std::vector<float> width = widths_of_texels(texels, candidate.is_adaptive());
    std::optional<shlm::AdaptiveMap> adaptive;
    if (candidate.is_adaptive()) adaptive = traced_map(method, hits, subject);

    Explanation explanation{surface_errors(result, subject), picture_width, picture_height, {}};
    const std::string basis = candidate.basis.substr(0, candidate.basis.find('/'));
    for (const common::VisibleSurface& seen :
         common::visible_surfaces(subject.loaded.rays, subject.loaded.camera, picture_width, picture_height))
        explanation.pixel.push_back(seen_block(seen, texels.layout, width, subject.loaded.scene, basis,
                                               adaptive ? &*adaptive : nullptr));
    return explanation;
}

}  // namespace bench::fit
