// 18. Very small and very large scenes.
#include "bench/experiments/stability/same_answers.h"
#include "bench/experiments/stability/traced_light.h"

namespace bench::stability {
namespace {

using common::Vec3;

constexpr double judged[] = {0x1p-20, 0x1p-10, 1, 0x1p10, 0x1p20},
                 beyond[] = {0x1p-40, 0x1p-30, 0x1p-23, 0x1p30, 0x1p40};

struct ScaledBox {
    float scale;  ///< half its side
    common::Scene scene;
    shlm::PreparedTexels texels;

    explicit ScaledBox(double half_side)
        : scale(static_cast<float>(half_side)), scene(lit_box_of(scale)), texels(texels_of(scene, 600)) {}

    static common::Scene lit_box_of(float s) {
        common::Scene scene = lit_box(0.5f);
        for (Vec3& p : scene.position) p *= s;
        scene.bounds = {scene.bounds.min * s, scene.bounds.max * s};
        scene.point_light[0].position *= s;
        return scene;
    }
};

std::vector<ScaledBox> boxes_of(std::span<const double> half_sides) {
    return {half_sides.begin(), half_sides.end()};
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    const float lengths = run.has_mutation("irradiance goes with the inverse length") ? 1 : 2;
    const bool absolute = run.has_mutation("the largest radius does not scale");
    std::vector<StabilityCurve> curves = curves_of_differences(judged, "", Expected::equal);
    const auto shown = curves_of_differences(beyond, ", beyond", Expected::shown);
    curves.insert(curves.end(), shown.begin(), shown.end());
    const std::vector<ScaledBox> judged_boxes = boxes_of(judged), boxes_beyond = boxes_of(beyond);
    const ScaledBox unit(1);
    run.for_each_seed([&](std::uint64_t seed) {
        const auto answers_in = [&](const ScaledBox& box) {
            const auto photons = common::photons_per_block * run.either<std::uint64_t>(8, 1);
            return answers_in_box(box.scene, box.texels, traced(box.scene, seed, {.photons = photons}).hits,
                                  0.4 * (absolute ? 1 : box.scale), std::pow(box.scale, lengths),
                                  Generator(seed));
        };
        const BoxAnswers at_1 = answers_in(unit);
        for (std::size_t i = 0; i < judged_boxes.size(); ++i)
            measure_differences(std::span(curves).first(4), i, answers_in(judged_boxes[i]), at_1);
        for (std::size_t i = 0; i < boxes_beyond.size(); ++i)
            measure_differences(std::span(curves).last(4), i, answers_in(boxes_beyond[i]), at_1);
    });
    return curves;
}

const RegisteredCase registered(
    180,
    {.name = "scene-scale",
     .purpose = "Offsets, radii and tolerances in fixed units make a scene in millimetres leak and one in "
                "kilometres blur.",
     .scene =
         "A closed box of albedo 0.5 with a point light, half its side swept in powers of two; 96 places on "
         "the walls. Seeds draw all photons.",
     .swept = "half the side of the box, world units",
     .measured = "part of the answers x area that differ from those at 1",
     .theory = "None, to the bit: all lengths are relative to the scene, and floats scale by powers of two "
               "without rounding. Irradiance goes with 1 / length^2. Not beyond: where 4 x area x cosine is "
               "below 10^-18, "
               "Embree says the first corner of the triangle for any place on it.",
     .advice =
         "Any unit will do, from 10^-6 to 10^6 of the scene's size; a photon map's largest radius must be "
         "given in it, or as a part of the scene's diagonal.",
     .mutations = {"irradiance goes with the inverse length", "the largest radius does not scale"},
     .run = run,
     .logarithmic_swept = true});

}  // namespace
}  // namespace bench::stability
