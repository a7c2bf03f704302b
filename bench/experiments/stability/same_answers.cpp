#include "bench/experiments/stability/same_answers.h"

namespace bench::stability {

BoxAnswers answers_in_box(const common::Scene& box, const shlm::PreparedTexels& texels,
                          const common::HitBatch& hits, double max_radius, float factor,
                          Generator generator) {
    std::vector<common::SurfacePoint> points;
    for (std::uint32_t i = 0; i < 6 * 16; ++i) {
        const float s = uniform(generator), t = uniform(generator);
        points.push_back(scene_builder::front_of(box, scene_builder::on_quad(2 * (i % 6), s, t)));
    }
    const auto ask = [&](const auto& map) {
        std::vector<float> answers;
        for (const common::SurfacePoint& point : points) answers.push_back(map.irradiance(point).x * factor);
        return answers;
    };
    const auto gather = nearest(50, max_radius);
    return {ask(photon_map_of(box, hits, gather)),
            ask(map_of(photonmap::CompactPhotonSink(box, gather), hits)),
            ask(light_map_of(texels, hits, shlm::OwnTexel{})),
            ask(light_map_of(texels, hits, shlm::NearestTexels{4}))};
}

std::vector<StabilityCurve> curves_of_differences(std::span<const double> places, const std::string& suffix,
                                                  Expected expected) {
    std::vector<StabilityCurve> curves;
    for (const char* who : answering)
        curves.push_back(curve_at(
            who + suffix, places, [](double) { return 0.0; }, expected));
    return curves;
}

void measure_differences(std::span<StabilityCurve> curves, std::size_t point, const BoxAnswers& a,
                         const BoxAnswers& b) {
    for (std::size_t way = 0; way < a.size(); ++way) {
        double different = 0;
        for (std::size_t i = 0; i < a[way].size(); ++i) different += !(a[way][i] == b[way][i]);
        curves[way].points[point].measured.push_back(different / static_cast<double>(a[way].size()));
    }
}

}  // namespace bench::stability
