// Tests photons and cameras at surfaces that have vertex colours, partial coverage, or transmit light without
// refraction.
#include "tests/support/see_through.h"

#include <algorithm>

#include "bench/experiments/limit/recorded_run.h"
#include "common/reference/directions.h"
#include "common/reference/specular.h"
#include "common/scene/coverage.h"
#include "common/tracer/scatter.h"
#include "common/view/place_camera.h"
#include "common/view/visible_surfaces.h"
#include "tests/support/reference_tracing.h"
#include "tests/support/tracing.h"

namespace {

using namespace bench::limit;
using namespace tests;
using common::HitBatch;
using common::RayScene;
using common::VisibleSurface;
using common::reference::specular_arrival;

constexpr std::uint64_t seed = 1;
const Material black = diffuse(Rgb(0, 0, 0)), grey = diffuse(Rgb(0.5f, 0.5f, 0.5f));

// --- one surface

SurfaceId somewhere() {
    return {0, 0.2f, 0.3f};
}

Scene plate(const Material& material) {
    Scene scene;
    add(scene, quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), material);
    return scene;
}

/// The fates of photons that arrive from above at this cosine, or from below if it is negative, as fractions
/// of all.
struct Outcome {
    double straight = 0, reflected = 0, absorbed = 0;
};

Outcome scattered(const Scene& scene, double cosine, std::uint64_t count) {
    const Vec3 down = common::direction_at(static_cast<float>(-cosine), 0.3f);
    const Rgb flux(1, 2, 3);
    std::mt19937_64 engine(seed);
    Outcome outcome;
    for (std::uint64_t i = 0; i < count; ++i) {
        std::array<float, 4> u;
        for (float& value : u) value = static_cast<float>(engine() >> 40) * 0x1p-24f;
        const auto next = common::scatter(scene, somewhere(), down, flux, u);
        const double part = 1 / static_cast<double>(count);
        if (!next) {
            outcome.absorbed += part;
            continue;
        }
        EXPECT_GT(next->direction.dot(next->normal), 0);
        const bool goes_on = next->direction.dot(down) > 0.999f;
        if (goes_on) {
            EXPECT_EQ(next->direction, down) << "not a bit bent";
        }
        (goes_on ? outcome.straight : outcome.reflected) += part;
    }
    return outcome;
}

/// Expects a fraction within chance, with probability 1e-5 of a false alarm.
void expect_part(double actual, double expected, std::uint64_t count, const char* what) {
    const double error = std::sqrt(expected * (1 - expected) / static_cast<double>(count));
    EXPECT_NEAR(actual, expected, z_for(1e-5) * error + 1e-6) << what << ", seed " << seed;
}

constexpr std::uint64_t photon_count = count_for(100'000, 10'000);

TEST(Scatter, GoesStraightThroughHoles) {
    for (const float alpha : {0.0f, 0.25f, 0.8f})
        for (const double cosine : {0.9, -0.3}) {
            const Outcome outcome = scattered(plate(blended(grey, alpha)), cosine, photon_count);
            const double there = static_cast<double>(alpha);
            expect_part(outcome.straight, 1 - there, photon_count, "straight");
            expect_part(outcome.reflected, there / 2, photon_count, "reflected");
            expect_part(outcome.absorbed, there / 2, photon_count, "absorbed");
        }
}

TEST(Scatter, KeepsTheFluxOfWhatGoesThroughAHole) {
    const Scene scene = plate(blended(black, 0.5f));
    const auto next = common::scatter(scene, somewhere(), {0, 0, -1}, Rgb(0.1f, 2, 7), {0, 0, 0, 0.5f});
    ASSERT_TRUE(next);
    EXPECT_EQ(next->flux, Rgb(0.1f, 2, 7));
    EXPECT_EQ(next->normal, Vec3(0, 0, -1));
    EXPECT_FALSE(common::scatter(scene, somewhere(), {0, 0, -1}, Rgb(0.1f, 2, 7), {0, 0, 0, 0.4999f}));
}

/// Returns the reflectance of a sheet at this cosine with all reflections inside it, from Fresnel's formulae
/// of sines and tangents and from the series itself.
double reflected_by_sheet(double cosine, double index) {
    const double angle = std::acos(cosine), bent = std::asin(std::sin(angle) / index);
    const double s = std::sin(angle - bent) / std::sin(angle + bent);
    const double p = std::tan(angle - bent) / std::tan(angle + bent);
    const double once = 0.5 * (s * s + p * p);
    double sum = once, inside = 1 - once;
    for (int i = 0; i < 200; ++i) {
        inside *= once;
        sum += inside * (1 - once);
        inside *= once;
    }
    return sum;
}

TEST(ThinSheet, ReflectsWithAllReflectionsInside) {
    for (const double index : {1.1, 1.5, 2.4})
        for (double cosine = 0.02; cosine < 1; cosine += 0.02) {
            const double expected = reflected_by_sheet(cosine, index);
            EXPECT_NEAR(common::sheet_reflectance(static_cast<float>(cosine), static_cast<float>(index)),
                        expected, 2e-6)
                << cosine << ", " << index;
            EXPECT_NEAR(common::reference::reflected_by_sheet(cosine, index), expected, 1e-9);
        }
    EXPECT_EQ(common::sheet_reflectance(0.5f, 1), 0);
    EXPECT_NEAR(common::sheet_reflectance(1, 1.5f), 2 * 0.04 / 1.04, 1e-6);
}

TEST(ThinSheet, LetsPhotonsThroughUnbentOnBothFaces) {
    for (const bool both : {false, true})
        for (const double cosine : {1.0, 0.4, 0.1, -0.4, -1.0}) {
            Material material = thin_sheet(1.5f);
            material.double_sided = both;
            const Outcome outcome = scattered(plate(material), cosine, photon_count);
            const double expected =
                cosine * cosine == 1 ? 2 * 0.04 / 1.04 : reflected_by_sheet(std::abs(cosine), 1.5);
            expect_part(outcome.reflected, expected, photon_count, "reflected");
            EXPECT_EQ(outcome.absorbed, 0);
        }
}

TEST(ThinSheet, MayBeThereInPart) {
    // The random number that selects the hole is reused to select reflection.
    const Outcome outcome = scattered(plate(blended(thin_sheet(1.5f), 0.3f)), 0.1, photon_count);
    const double reflected = 0.3 * reflected_by_sheet(0.1, 1.5);
    expect_part(outcome.reflected, reflected, photon_count, "reflected");
    expect_part(outcome.straight, 1 - reflected, photon_count, "straight");
    const Outcome in_mirror = scattered(plate(blended(mirror(), 0.3f)), 0.5, photon_count);
    expect_part(in_mirror.reflected, 0.3, photon_count, "reflected by a mirror");
}

// --- many photons

TEST(SeeThrough, PhotonsAreTracedTogetherAsOneByOne) {
    const Scene scene = see_through_room();
    const RayScene rays(scene);
    const common::PhotonSource source(scene);
    const RecordedRun run =
        record_run(rays, source, seed, 5000, std::size_t{1} << 30, [](const RecordedRun&) { return true; });
    ASSERT_LT(run.report.fates.emitted, common::photons_per_block);
    common::TracedBlock traced;
    common::BlockTracer(rays, source, seed).trace(0, traced);
    traced.keep_photons(0, run.report.fates.emitted);
    common::PhotonFates fates;
    fates.add(traced.fate);
    EXPECT_EQ(run.report.hits, traced.hits.size());
    EXPECT_EQ(run.report.fates.escaped, fates.escaped);
    EXPECT_EQ(run.report.fates.absorbed, fates.absorbed);
}

struct Faces {
    std::vector<LitFace> face;
    double area = 0;
};

/// Returns one side of an instance.
Faces faces_of(const Scene& scene, std::uint32_t instance, bool from_back = false) {
    Faces faces;
    const common::MeshInstance& range = scene.instance[instance];
    for (std::uint32_t t = range.first_triangle; t < range.first_triangle + range.triangle_count; ++t) {
        faces.face.push_back({t, from_back});
        faces.area += static_cast<double>(common::triangle_area(scene, t));
    }
    return faces;
}

/// Sums the flux that arrives on each instance from either side, and what the surfaces absorb of it, in W
/// times the number emitted.
class FluxSums {
  public:
    explicit FluxSums(const Scene& scene)
        : scene_(&scene), arriving_(2 * scene.instance.size(), V3d(0, 0, 0)) {}

    void consume(std::span<const HitBatch> wave) {
        for (const HitBatch& hits : wave)
            for (std::size_t i = 0; i < hits.size(); ++i) {
                const SurfaceId& on = hits.surface[i];
                const bool from_back = hits.direction[i].dot(scene_->geometric_normal[on.triangle]) > 0;
                const V3d flux(hits.flux[i]);
                arriving_[2 * scene_->instance_of[on.triangle] + (from_back ? 1 : 0)] += flux;
                const V3d left = V3d(1, 1, 1) - V3d(common::base_color_at(*scene_, on));
                absorbed_ += flux * left * static_cast<double>(common::coverage_at(*scene_, on));
            }
    }

    [[nodiscard]] const V3d& arriving(std::uint32_t instance, bool from_back) const {
        return arriving_[2 * instance + (from_back ? 1 : 0)];
    }
    [[nodiscard]] const V3d& absorbed() const { return absorbed_; }

  private:
    const Scene* scene_;
    std::vector<V3d> arriving_;
    V3d absorbed_{0, 0, 0};
};

/// Makes independent runs of the same scene, for means with errors.
template <class Use>
void for_each_run(const Scene& scene, std::uint64_t runs, std::uint64_t photons, Use use) {
    for (std::uint64_t run = 0; run < runs; ++run) {
        FluxSums sums(scene);
        const common::TraceReport report = trace(scene, 100 + run, {.photons = photons}, sums);
        use(sums, static_cast<double>(report.watts_per_flux()));
    }
}

constexpr std::uint64_t runs = 40, photons_per_run = count_for(20'000, 1'000);

TEST(SeeThrough, SurfacesKeepThePowerOfTheLights) {
    Scene scene = see_through_room();
    scene.point_light.push_back({scene.bounds.center(), Rgb(1, 2, 3)});
    scene.material[pane].base_color = Rgb(1, 1, 1);  // clear: it absorbs nothing
    const common::PhotonSource source(scene);
    std::array<Sample, 3> absorbed;
    for_each_run(scene, runs, photons_per_run, [&](const FluxSums& sums, double watts) {
        for (int c = 0; c < 3; ++c) absorbed[static_cast<std::size_t>(c)].add(sums.absorbed()[c] * watts);
    });
    for (int c = 0; c < 3; ++c) {
        const Sample& sample = absorbed[static_cast<std::size_t>(c)];
        // The lamp's power is estimated on a grid over its holes; its true emission is that of half its area.
        const double lamp_power = V3d(6, 5, 4)[c] * pi * 0.5, point_power = 4 * pi * (c + 1);
        EXPECT_NEAR(sample.mean(), lamp_power + point_power, t_for(1e-5, runs - 1) * sample.standard_error())
            << "channel " << c;
        EXPECT_NEAR(static_cast<double>(source.power()[c]), lamp_power + point_power, 0.05 * lamp_power);
    }
}

TEST(SeeThrough, EveryPhotonHasOneFate) {
    const common::TraceReport report = record(see_through_room(), seed, {.photons = 20'000}).report;
    EXPECT_EQ(report.fates.emitted, 20'000u);
    EXPECT_EQ(report.fates.absorbed + report.fates.without_light, 20'000u) << "a closed room";
    EXPECT_GT(report.fates.without_light, 5'000u) << "from the lamp's holes";
}

TEST(SeeThrough, HolesAreHitsAndWhatIsNowhereIsNot) {
    Scene scene = plate(black);
    scene.point_light.push_back({{0, 0, 1}, Rgb(1, 1, 1)});
    for (const Material& material :
         {blended(black, 0.5f), masked(checkered(scene, black)), blended(black, 0), masked(black, 0.2f)}) {
        const bool nowhere = material.alpha < 0.4f;
        Scene covered = scene;
        const std::uint32_t sheet = add(covered, quad({-1, -1, 0.5f}, {2, 0, 0}, {0, 2, 0}), material);
        const TracedRun run = record(covered, seed, {.photons = 10'000});
        std::uint64_t on_sheet = 0;
        for (const SurfaceId& on : run.hits.surface) on_sheet += covered.instance_of[on.triangle] == sheet;
        // A square of 2 x 2, seen from 1/2 in front of its middle, covers this fraction of all directions.
        if (nowhere)
            EXPECT_EQ(on_sheet, 0u);
        else
            expect_part(static_cast<double>(on_sheet) / 10'000, std::atan(4.0 / 3) / pi, 10'000, "met");
    }
}

/// Expects the same flux on every wall, within chance of 1 in 1e5 for both together.
void expect_twins(const Scene& scene, const Scene& twin, std::uint32_t walls) {
    std::vector<Sample> flux(walls), twin_flux(walls);
    for (const bool first : {true, false})
        for_each_run(first ? scene : twin, runs, photons_per_run / 2,
                     [&](const FluxSums& sums, double watts) {
                         for (std::uint32_t wall = 0; wall < walls; ++wall)
                             (first ? flux : twin_flux)[wall].add(sums.arriving(wall, false).x * watts);
                     });
    for (std::uint32_t wall = 0; wall < walls; ++wall) {
        EXPECT_NEAR(flux[wall].mean(), twin_flux[wall].mean(),
                    t_for(1e-5 / walls, runs - 1) *
                        std::hypot(flux[wall].standard_error(), twin_flux[wall].standard_error()))
            << "wall " << wall;
        EXPECT_LT(flux[wall].standard_error(), 0.05 * flux[wall].mean());
    }
}

Scene lit_box(const Rgb& albedo) {
    Scene scene = closed_box(diffuse(albedo));
    scene.point_light.push_back({{0.1f, 0.2f, 0.3f}, Rgb(3, 2, 1)});
    return scene;
}

Mesh sheet_below_the_light() {
    return quad({-1, -1, -0.5f}, {2, 0, 0}, {0, 2, 0});
}

TEST(SeeThrough, WhatIsMaskedAwayChangesNothing) {
    const Scene room = lit_box(Rgb(0.5f, 0.5f, 0.5f));
    for (const Material& material : {masked(black, 0.4f), blended(black, 0), masked(thin_sheet(), 0)}) {
        Scene with_sheet = room;
        add(with_sheet, sheet_below_the_light(), double_sided(material));
        expect_twins(with_sheet, room, 6);
    }
}

TEST(SeeThrough, VertexColorsMultiplyTheBaseColor) {
    Scene colored = lit_box(Rgb(0.8f, 0.8f, 0.8f));
    for (std::uint32_t wall = 0; wall < 6; ++wall)
        set_color(colored, wall, [](const Vec3&) { return Rgb(0.5f, 0.5f, 0.5f); });
    const Scene twin = lit_box(Rgb(0.4f, 0.4f, 0.4f));
    expect_twins(colored, twin, 6);
    const common::TraceReport report = record(colored, seed, {.photons = photon_count}).report;
    const auto per_photon = static_cast<double>(report.hits) / static_cast<double>(photon_count);
    // The number is geometric: mean 1 / (1 - 0.4), variance 0.4 / (1 - 0.4)^2.
    EXPECT_NEAR(per_photon, 1 / 0.6, z_for(1e-5) * std::sqrt(0.4 / 0.36 / static_cast<double>(photon_count)));
}

// Walls emit 1 and reflect half, so radiance is 2 everywhere. Objects that keep this balance do not change
// it.
Scene furnace() {
    Scene scene = closed_box(diffuse(Rgb(0.5f, 0.5f, 0.5f), Rgb(1, 1, 1)));
    const Material glowing = double_sided(diffuse(Rgb(0.5f, 0.5f, 0.5f), Rgb(1, 1, 1)));
    add(scene, quad({-0.6f, -0.7f, -0.5f}, {1.2f, 0, 0}, {0, 1.3f, 0.1f}), blended(glowing, 0.4f));
    add(scene, quad({-0.6f, -0.7f, 0.5f}, {1.2f, 0, 0}, {0, 1.3f, 0.1f}), masked(checkered(scene, glowing)));
    add(scene, quad({-0.8f, -0.7f, 0.1f}, {1.6f, 0, 0.1f}, {0, 1.5f, 0.1f}), thin_sheet(1.8f));
    add(scene, sphere({0, 0.1f, -0.1f}, 0.15f, 1), blended(thin_sheet(1.5f), 0.7f));
    // The products of colours and base colours are one half.
    for (const std::uint32_t wall : {0u, 3u}) {
        scene.material[wall].base_color = Rgb(0.8f, 1, 0.625f);
        set_color(scene, wall, [](const Vec3&) { return Rgb(0.625f, 0.5f, 0.8f); });
    }
    return scene;
}

TEST(SeeThrough, PhotonsFillAFurnaceEvenly) {
    const Scene scene = furnace();
    std::array<std::vector<Sample>, 2> irradiance = {std::vector<Sample>(8), std::vector<Sample>(8)};
    for_each_run(scene, runs, photons_per_run, [&](const FluxSums& sums, double watts) {
        for (std::uint32_t part = 0; part < 8; ++part)
            for (const bool back : {false, true})
                irradiance[back][part].add(sums.arriving(part, back).y * watts / faces_of(scene, part).area);
    });
    for (std::uint32_t part = 0; part < 8; ++part)
        for (const bool back : {false, true}) {
            if (back && part < 6) continue;
            const Sample& sample = irradiance[back][part];
            EXPECT_NEAR(sample.mean(), 2 * pi, t_for(1e-5 / 10, runs - 1) * sample.standard_error())
                << "instance " << part << (back ? ", back" : "");
            EXPECT_LT(sample.standard_error(), 0.05 * sample.mean());
        }
}

TEST(SeeThrough, ReferenceIsRightInAFurnace) {
    const Scene scene = furnace();
    std::mt19937 engine(static_cast<unsigned>(seed));
    std::vector<SurfacePoint> points;
    for (int i = 0; i < 20; ++i) points.push_back(random_point(scene, fronts(0, 16), engine));
    const std::vector<double> expected(points.size(), 2 * pi);
    expect_irradiance(trace_reference(scene, points, seed, count_for(65, 17)), std::span(expected));
}

/// All kinds of light and surfaces: each side of each surface must get what the reference says.
TEST(SeeThrough, PhotonsAndReferenceAgree) {
    const Scene scene = see_through_room();
    struct Part {
        std::uint32_t instance;
        bool back;
        Sample photons = {};
    };
    std::vector<Part> parts;
    for (std::uint32_t wall = 0; wall < 6; ++wall) parts.push_back({wall, false});
    for (const std::uint32_t sheet : {fence, veil})
        for (const bool back : {false, true}) parts.push_back({sheet, back});
    for (const std::uint32_t ball : {colored_ball, blended_ball}) parts.push_back({ball, false});
    for_each_run(scene, runs, photons_per_run, [&](const FluxSums& sums, double watts) {
        for (Part& part : parts)
            part.photons.add(sums.arriving(part.instance, part.back).x * watts /
                             faces_of(scene, part.instance).area);
    });
    for (const Part& part : parts) {
        const Sample reference =
            mean_irradiance(scene, faces_of(scene, part.instance, part.back).face, count_for(1'000, 60));
        EXPECT_NEAR(part.photons.mean(), reference.mean(),
                    t_for(1e-5 / static_cast<double>(parts.size()), runs - 1) *
                        std::hypot(part.photons.standard_error(), reference.standard_error()))
            << "instance " << part.instance << (part.back ? ", back" : "");
        EXPECT_LT(std::hypot(part.photons.standard_error(), reference.standard_error()),
                  (count_for(1, 0) == 1 ? 0.04 : 0.2) * reference.mean());
    }
}

// --- the reference along straight lines

constexpr std::uint64_t passes = count_for(65, 17);

/// Makes a floor of 4 x 4 in the plane y = 0, facing up, below a sheet that covers it completely.
Scene floor_below(const Material& sheet, float height = 1) {
    Scene scene;
    add(scene, quad({-2, 0, -2}, {0, 0, 4}, {4, 0, 0}), black);
    add(scene, quad({-20, height, -20}, {40, 0, 0}, {0, 0, 40}), sheet);
    return scene;
}

std::vector<SurfacePoint> on_floor(const Scene& scene) {
    std::vector<SurfacePoint> points;
    for (const Vec2& p : {Vec2(0.4f, 0.6f), Vec2(0.9f, 0.2f)})
        points.push_back(front_of(scene, on_quad(0, p.x, p.y)));
    return points;
}

/// For lights without size, every sample is exact.
TEST(ReferenceSeeThrough, LightsWithoutSizeShineStraightThrough) {
    const V3d tint(0.9, 0.6, 0.3);
    struct Case {
        Material sheet;
        std::function<V3d(double cosine)> part;
    };
    Material both = blended(thin_sheet(1.5f, Rgb(0.9f, 0.6f, 0.3f)), 0.25f);
    for (const auto& [sheet, part] : std::vector<Case>{
             {blended(black, 0.25f), [](double) { return V3d(0.75); }},
             {blended(mirror(), 0.5f), [](double) { return V3d(0.5); }},
             {masked(black, 0.3f), [](double) { return V3d(1); }},
             {black, [](double) { return V3d(0); }},
             {glass(1.5f), [](double) { return V3d(0); }},
             {thin_sheet(1.5f, Rgb(0.9f, 0.6f, 0.3f)),
              [&](double c) { return tint * (1 - reflected_by_sheet(c, 1.5)); }},
             {both,
              [&](double c) { return V3d(0.75) + tint * (0.25 * (1 - reflected_by_sheet(c, 1.5))); }}}) {
        for (const int lights : {0, 1, 2}) {
            Scene scene = floor_below(sheet);
            add(scene, quad({-20, 2, -20}, {0, 0, 40}, {40, 0, 0}), sheet);  // and another, facing up
            const Vec3 at(0.3f, 3, 0.2f), down = Vec3(0.3f, -1, 0.2f).normalized();
            if (lights == 0) scene.point_light.push_back({at, Rgb(9, 9, 9)});
            if (lights == 1) scene.spot_light.push_back({at, {0, -1, 0}, Rgb(9, 9, 9), 0.1f, 0.05f});
            if (lights == 2) scene.directional_light.push_back({down, Rgb(9, 9, 9)});
            const std::vector<SurfacePoint> points = on_floor(scene);
            std::vector<V3d> expected;
            for (const SurfacePoint& p : points) {
                const V3d joining = lights == 2 ? -V3d(down) : V3d(at) - V3d(p.position);
                const double cosine = joining.normalized().y;
                const double falloff = lights == 2 ? 1 : 1 / joining.length2();
                expected.push_back(part(cosine) * part(cosine) * (9 * cosine * falloff));
            }
            // Sampled directions add nothing: the floor is black, and rays hit no light.
            const ReferenceSums sums = trace_reference(scene, points, seed, 1);
            for (std::size_t i = 0; i < points.size(); ++i)
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(estimate(sums, i, c), expected[i][c], 2e-4 * expected[i][c]) << lights;
        }
    }
}

TEST(ReferenceSeeThrough, HalfASheetHalvesDirectLight) {
    Scene open = floor_below(masked(black, 0)), half = floor_below(blended(black, 0.5f));
    for (Scene* scene : {&open, &half}) scene->point_light.push_back({{0.3f, 3, 0.2f}, Rgb(9, 9, 9)});
    const ReferenceSums whole = trace_reference(open, on_floor(open), seed, 1),
                        part = trace_reference(half, on_floor(half), seed, 1);
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_NEAR(estimate(part, i, 0), estimate(whole, i, 0) / 2, 1e-6 * estimate(whole, i, 0));
    half.point_light[0].position = {0, 3, 0};
    const TracedRun run = record(half, seed, {.photons = photon_count});
    std::uint64_t below = 0;
    for (const SurfaceId& on : run.hits.surface) below += half.instance_of[on.triangle] == 0;
    // The fraction of all directions that the floor covers, without the sheet.
    const double without = std::atan(4 / (3 * std::sqrt(17.0))) / pi;
    expect_part(static_cast<double>(below) / static_cast<double>(photon_count), without / 2, photon_count,
                "on the floor");
}

/// Panels are sampled by points on them and by directions that hit them; the weights must account for both
/// ways.
TEST(ReferenceSeeThrough, PanelsShineThroughSheets) {
    const Vec3 corner(-1, 1.5f, -1), edge_u(2, 0, 0), edge_v(0, 0, 2);
    const double tint = static_cast<double>(0.8f);
    struct Case {
        Material sheet;
        std::function<double(double cosine)> part;
    };
    for (const auto& [sheet, part] :
         std::vector<Case>{{thin_sheet(1.5f, Rgb(0.8f, 0.8f, 0.8f)),
                            [&](double c) { return tint * (1 - reflected_by_sheet(c, 1.5)); }},
                           {blended(black, 0.3f), [](double) { return 0.7; }}}) {
        Scene scene = floor_below(sheet, 1.2f);
        // The panel itself has partial coverage.
        add(scene, quad(corner, edge_u, edge_v), blended(diffuse(Rgb(0, 0, 0), Rgb(5, 5, 5)), 0.6f));
        const std::vector<SurfacePoint> points = on_floor(scene);
        std::vector<double> expected;
        constexpr int steps = 300;
        for (const SurfacePoint& p : points) {
            double sum = 0;
            for (int i = 0; i < steps * steps; ++i) {
                const Vec3 at = corner + edge_u * ((static_cast<float>(i % steps) + 0.5f) / steps) +
                                edge_v * ((static_cast<float>(i / steps) + 0.5f) / steps);
                const V3d joining = V3d(at) - V3d(p.position);
                const double distance_sq = joining.length2(), cosine = joining.y / std::sqrt(distance_sq);
                sum += part(cosine) * cosine * cosine / distance_sq * 4 / (steps * steps);
            }
            expected.push_back(5 * 0.6 * sum);
        }
        expect_irradiance(trace_reference(scene, points, seed, passes), std::span(expected));
    }
}

TEST(ReferenceSeeThrough, SkyShinesThroughAThinSheet) {
    Scene scene = floor_below(thin_sheet(1.5f), 0.1f);
    scene.sky = common::Sky{Rgb(1, 1, 1)};
    double expected = 0;
    constexpr int steps = 100'000;
    for (int i = 0; i < steps; ++i)
        expected += (1 - reflected_by_sheet(std::sqrt((i + 0.5) / steps), 1.5)) * pi / steps;
    EXPECT_NEAR(expected / pi, 0.85, 0.02);
    const SurfacePoint point = on_floor(scene)[0];
    const std::vector<double> all = {expected};
    expect_irradiance(trace_reference(scene, std::span(&point, 1), seed, passes), std::span(all));
}

/// Does the same as IsTheAdjointOfThePhotonTracer in reference_specular_test.cpp, but here a radiance of 1
/// comes from above, and the smooth normals are tilted.
TEST(ReferenceSeeThrough, SheetIsTheAdjointOfThePhotonTracer) {
    using common::reference::cosine_direction;
    Scene scene;
    Mesh mesh;
    mesh.position = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normal = {Vec3(1, 0.3f, 1).normalized(), Vec3(-0.5f, 1, 0.9f).normalized(),
                   Vec3(1.2f, -0.8f, 0.7f).normalized()};
    mesh.triangle = {{0, 1, 2}};
    add(scene, mesh, thin_sheet(1.9f));
    const V3d a = V3d(1, 2, 3).normalized(), b = V3d(-2, 1, 0.5).normalized();
    const auto features = [&](const V3d& from, const V3d& to) {
        const double i = from.dot(a), o = to.dot(b), across = from.z * to.z < 0;
        return std::array<double, 6>{1, across, across * i * i, (1 - across) * i * i, o * o, i * o};
    };
    for (const Vec2& uv : {Vec2(0.1f, 0.1f), Vec2(0.8f, 0.1f), Vec2(0.1f, 0.8f), Vec2(0.33f, 0.33f)}) {
        const SurfaceId place{0, uv.x, uv.y};
        std::mt19937 engine(static_cast<unsigned>(seed));
        std::uniform_real_distribution<double> uniform(0, 1);
        std::array<Sample, 6> difference;
        for (std::uint64_t n = 0; n < count_for(400'000, 10'000); ++n) {
            const Vec3 side(0, 0, n % 2 == 0 ? 1.0f : -1.0f);
            const auto direction = [&] { return cosine_direction(side, {uniform(engine), uniform(engine)}); };
            std::array<double, 6> by_photon{}, by_adjoint{};
            const Vec3 from = direction(), to = direction();
            const auto u = static_cast<float>(uniform(engine));
            if (const auto photon = common::scatter(scene, place, -from, Rgb(1, 1, 1), {0, 0, 0, u}))
                by_photon = features(V3d(from), V3d(photon->direction));
            if (const auto arrival = specular_arrival(scene, place, to, uniform(engine))) {
                EXPECT_EQ(arrival->index_ratio_sq, 1);
                EXPECT_EQ(arrival->straight, arrival->towards == -to);
                by_adjoint = features(V3d(arrival->towards), V3d(to));
                for (double& feature : by_adjoint) feature *= arrival->factor;
            }
            for (std::size_t f = 0; f < 6; ++f) difference[f].add(by_photon[f] - by_adjoint[f]);
        }
        for (std::size_t f = 0; f < 6; ++f)
            EXPECT_NEAR(difference[f].mean(), 0, z_for(1e-5 / 24) * difference[f].standard_error() + 1e-12)
                << "feature " << f << " at " << uv.x << ", " << uv.y;
    }
}

// --- what a camera sees

std::vector<VisibleSurface> look_down(const Scene& scene, int pixels) {
    const RayScene rays(scene);
    return common::visible_surfaces(rays, common::look_at({0.1f, 1.9f, 0.1f}, {0, 0, 0}, 0.8f), pixels,
                                    pixels);
}

std::size_t count_on(const std::vector<VisibleSurface>& seen, const Scene& scene, std::uint32_t instance) {
    return static_cast<std::size_t>(std::ranges::count_if(seen, [&](const VisibleSurface& s) {
        return s.present && scene.instance_of[s.point.surface.triangle] == instance;
    }));
}

TEST(VisibleSurfaces, ShowWhatIsBehindHoles) {
    const Scene scene = floor_below(blended(diffuse(Rgb(1, 1, 1), Rgb(1, 1, 1)), 0.3f));
    const auto seen = look_down(scene, 64);
    const double sheet = static_cast<double>(count_on(seen, scene, 1)) / 4096;
    expect_part(sheet, 0.3, 4096, "seen of a sheet of which 0.3 is there");
    EXPECT_EQ(count_on(seen, scene, 0) + count_on(seen, scene, 1), seen.size());
    const auto again = look_down(scene, 64);
    for (std::size_t i = 0; i < seen.size(); ++i) {
        ASSERT_EQ(seen[i].point.position, again[i].point.position) << "every look shows the same";
        ASSERT_EQ(seen[i].throughput, Rgb(1, 1, 1));
    }
}

TEST(VisibleSurfaces, ChooseAnewAtEverySheet) {
    // Two sheets of one half each show a quarter of the floor below both.
    Scene scene = floor_below(blended(black, 0.5f));
    add(scene, quad({-20, 1.5f, -20}, {0, 0, 40}, {40, 0, 0}), blended(black, 0.5f));
    const auto seen = look_down(scene, 64);
    expect_part(static_cast<double>(count_on(seen, scene, 0)) / 4096, 0.25, 4096, "the floor");
    expect_part(static_cast<double>(count_on(seen, scene, 1)) / 4096, 0.25, 4096, "the lower sheet");
}

TEST(VisibleSurfaces, MasksCutWhereTheirAlphaSays) {
    Scene scene = floor_below(masked(black, 0));
    add(scene, quad({-0.5f, 1, -0.5f}, {0, 0, 1}, {1, 0, 0}), masked(checkered(scene, black)));
    const auto seen = look_down(scene, 64);
    for (const VisibleSurface& s : seen) {
        ASSERT_TRUE(s.present);
        ASSERT_EQ(common::coverage_at(scene, s.point.surface), 1);
    }
    EXPECT_GT(count_on(seen, scene, 0), 0u);
    EXPECT_GT(count_on(seen, scene, 2), 0u);
    EXPECT_EQ(count_on(seen, scene, 1), 0u);
}

TEST(VisibleSurfaces, ThinSheetsAreLookedStraightThrough) {
    for (const bool both : {false, true}) {
        Material sheet = thin_sheet(1.5f, Rgb(0.5f, 1, 0.9f));
        sheet.double_sided = both;
        const Scene open = floor_below(masked(black, 0)), behind = floor_below(sheet);
        const auto clear = look_down(open, 16), seen = look_down(behind, 16);
        for (std::size_t i = 0; i < seen.size(); ++i) {
            ASSERT_TRUE(seen[i].present);
            ASSERT_LT((seen[i].point.position - clear[i].point.position).length(), 1e-3f);
            ASSERT_EQ(seen[i].throughput, Rgb(0.5f, 1, 0.9f));
        }
    }
}

TEST(VisibleSurfaces, HaveTheirVertexColors) {
    Scene scene = floor_below(masked(black, 0));
    scene.material[0].base_color = Rgb(0.5f, 0.5f, 0.5f);
    set_color(scene, 0, [](const Vec3&) { return Rgb(1, 0.5f, 0.25f); });
    for (const VisibleSurface& s : look_down(scene, 4)) EXPECT_EQ(s.reflectance, Rgb(0.5f, 0.25f, 0.125f));
}

}  // namespace
