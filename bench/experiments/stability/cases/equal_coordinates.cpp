// 12. Equal coordinates: all photons of an axis-aligned wall have one coordinate in common.
#include "bench/experiments/stability/known_light.h"
#include "bench/experiments/stability/median_tree.h"
#include "bench/experiments/stability/stability_case.h"
#include "common/point_index/flann_index.h"
#include "photonmap/index/compact_build.h"
#include "photonmap/index/nanoflann_index.h"
#include "photonmap/index/nearest_selection.h"

namespace bench::stability {
namespace {

using common::Vec3;
using photonmap::NearestSelection;

/// Returns points on the six faces of a cube.
std::vector<Vec3> points_on_a_cube(std::size_t count, Generator& generator) {
    std::vector<Vec3> points(count);
    for (Vec3& p : points) {
        for (int axis = 0; axis < 3; ++axis) p[axis] = 2 * uniform(generator) - 1;
        p[static_cast<int>(generator() % 3)] = generator() % 2 == 0 ? -1.0f : 1.0f;
    }
    return points;
}

std::vector<Vec3> turned(std::vector<Vec3> points) {
    for (Vec3& p : points) {
        const Vec3 before = p;
        scene_builder::skew_rotation().multDirMatrix(before, p);
    }
    return points;
}

/// Counts the decisions of a search, which asks the collector for its reach whenever it decides whether to go
/// on: once per entry taken from its stack, and once per node or leaf that it opens.
struct CountingSelection {
    NearestSelection selection;
    mutable std::size_t asked = 0;

    void offer(float distance_sq, std::uint32_t index) { selection.offer(distance_sq, index); }
    [[nodiscard]] bool full() const { return selection.full(); }
    float reach_sq() const {
        ++asked;
        return selection.reach_sq();
    }
};

photonmap::CompactIndex compact_index(const std::vector<Vec3>& points) {
    struct Record {
        Vec3 position;
    };
    common::StableArray<Record> records(points.size());
    const auto room = records.grow(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) room[i] = {points[i]};
    return photonmap::build_compact_index(
        std::move(records), [](std::size_t) {}, [](std::size_t, const Record&) {});
}

/// Returns the number of decisions in searches for the nearest points, with queries at evenly spaced points
/// of the list.
template <class Index>
double decisions(const Index& index, const std::vector<Vec3>& points, std::size_t queries,
                 std::size_t wanted) {
    std::vector<NearestSelection::Key> room(NearestSelection::room_for(wanted));
    std::size_t asked = 0;
    for (std::size_t q = 0; q < queries; ++q) {
        CountingSelection collector{NearestSelection(room, wanted, std::numeric_limits<float>::infinity())};
        index.search(points[q * (points.size() / queries)], collector, common::accept_all);
        asked += collector.asked;
    }
    return static_cast<double>(asked);
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    const std::vector<double> sizes =
        run.full() ? std::vector<double>{1e4, 1e5, 1e6} : std::vector<double>{3e3, 1e4, 2e5};
    const std::size_t queries = run.either<std::size_t>(2000, 300);
    const std::size_t nearest = 50;
    const bool at_median = run.has_mutation("compact puts its planes at the median");
    const auto one = [](double) { return 1.0; };
    // Our compact index also has a grid of cells, whose bounds differ for the rotated points. A cell's tree
    // may have a level more or less, which is one entry taken and one node opened, in one or two cells. A
    // search has at least some forty decisions.
    constexpr double a_level_more = 0.1;
    std::vector<StabilityCurve> curves = {
        curve_at("compact", sizes, one, Expected::at_most, a_level_more),
        curve_at("flann", sizes, one, Expected::at_most),
        // Its boxes are not fitted to their points, so one may be widest across a wall that contains all its
        // points. Its middleSplit_ then halves equal coordinates, which shows at some sizes.
        curve_at("nanoflann", sizes, one, Expected::shown),
        curve_at("planes at the median, axes by turns", sizes, one, Expected::shown)};
    run.for_each_seed([&](std::uint64_t seed) {
        Generator generator(seed);
        for (std::size_t i = 0; i < sizes.size(); ++i) {
            const auto aligned = points_on_a_cube(static_cast<std::size_t>(sizes[i]), generator);
            const auto skew = turned(aligned);
            const auto measure = [&](std::size_t curve, auto index_over) {
                curves[curve].points[i].measured.push_back(
                    decisions(index_over(aligned), aligned, queries, nearest) /
                    decisions(index_over(skew), skew, queries, nearest));
            };
            using Points = std::vector<Vec3>;
            const auto median_tree = [](const Points& points) { return MedianTree(points); };
            if (at_median)
                measure(0, median_tree);
            else
                measure(0, compact_index);
            measure(1, [](const Points& points) { return common::FlannIndex(points); });
            measure(2, [](const Points& points) { return photonmap::NanoflannIndex(points); });
            measure(3, median_tree);
        }
    });
    return curves;
}

const RegisteredCase registered(
    121,
    {.name = "equal-coordinates",
     .purpose =
         "All photons of an axis-aligned wall share one coordinate. A tree that puts a plane there must "
         "look on both sides of it in every search on that wall.",
     .scene = "Photons on the faces of a cube, and the same photons turned so that no face is parallel to an "
              "axis; searches for the 50 nearest around photons. Seeds place them.",
     .swept = "photons",
     .measured = "work of a search, aligned / turned",
     .theory =
         "Decisions in a search: entries taken from its stack, and nodes and leaves opened. At most 1: "
         "boxes around points of one axis-aligned plane are flat, so that a search opens no more of them "
         "than of skew ones. Planes at the median come to lie on walls with many photons.",
     .advice = "Nothing to do with flann and compact; nanoflann loses a tenth at some sizes, a tree that "
               "halves its photons along x, y and z by turns a third from 1e5 on.",
     .mutations = {"compact puts its planes at the median"},
     .run = run,
     .logarithmic_swept = true});

}  // namespace
}  // namespace bench::stability
