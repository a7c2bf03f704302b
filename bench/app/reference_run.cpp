#include "bench/app/reference_run.h"

#include <fmt/format.h>

#include <chrono>

#include "bench/setup/image_output.h"
#include "bench/setup/provenance.h"
#include "common/core/interrupt.h"
#include "common/core/progress.h"
#include "common/reference/paths_not_found.h"
#include "common/reference/strata.h"
#include "common/scene/fingerprint.h"

namespace bench {

namespace reference = common::reference;
using reference::samples_per_pass;

ReferenceRun::ReferenceRun(const LoadedScene& scene, const common::PhotonSource& source, std::uint64_t seed,
                           const std::filesystem::path& file, int width, int height)
    : loaded(scene),
      out(file),
      identity{common::fingerprint(scene.scene), seed, width, height, reference::describe(scene.camera)},
      pixels(common::visible_surfaces(scene.rays, scene.camera, width, height)),
      lights(scene.scene),
      most_surfaces(static_cast<int>(source.most_events())) {}

bool sample(const ReferenceRun& run, const ReferenceTarget& target, reference::ReferenceSums& sums) {
    using Clock = std::chrono::steady_clock;
    constexpr auto between_saves = std::chrono::minutes(1);
    const auto paths = [&](std::uint64_t passes) { return passes * samples_per_pass * run.pixels.size(); };
    const std::uint64_t passes_before = sums.passes;
    common::Progress progress("reference", "paths", 1);
    auto saved = Clock::now();
    while (true) {
        const double error = reference::relative_error(run.pixels, sums);
        if (target.reached(sums.passes, error)) return true;
        progress.set_total(paths(target.expected_passes(sums.passes, error) - passes_before));
        const auto keep_going = [&](std::size_t pixels_done) {
            progress.show(paths(sums.passes - passes_before) + pixels_done * samples_per_pass);
            return !common::interrupted();
        };
        if (!reference::add_pass(run.loaded.rays, run.lights, run.pixels, run.identity.seed, sums, keep_going,
                                 run.most_surfaces))
            return false;
        if (sums.passes >= fewest_passes && Clock::now() - saved > between_saves) {
            write(run, sums);
            saved = Clock::now();
        }
    }
}

void write(const ReferenceRun& run, const reference::ReferenceSums& sums) {
    common::ImageNotes notes = provenance_notes();
    notes.merge(reference::continuation_notes(run.identity, sums));
    const std::string lost = reference::paths_not_found(run.loaded.scene);
    notes["shlmbench:scene"] = run.loaded.name;
    notes["shlmbench:method"] = "reference";
    if (const Imath::V3d& origin = run.loaded.scene.origin; origin != Imath::V3d(0))
        notes["shlmbench:origin"] = fmt::format("{} {} {}", origin.x, origin.y, origin.z);
    notes["shlmbench:samples_per_pixel"] = std::to_string(sums.passes * samples_per_pass);
    notes["shlmbench:relative_error"] = fmt::format("{:.6g}", reference::relative_error(run.pixels, sums));
    notes[reference::paths_not_found_note] = lost.empty() ? "none" : lost;
    const common::Image image =
        reference::to_image(run.pixels, run.identity.width, run.identity.height, sums);
    common::write_exr(run.out, image, notes, common::Precision::single);
    common::write_png(picture_of(run.out), image, common::middle_grey_exposure(image));
}

std::string describe(const ReferenceRun& run, const reference::ReferenceSums& sums) {
    const std::string dropped =
        sums.dropped > 0 ? fmt::format(", {} samples not finite and counted as 0", sums.dropped) : "";
    return fmt::format("{}: {} samples per pixel, relative error {:.3g} %{}", run.out.string(),
                       sums.passes * samples_per_pass, 100 * reference::relative_error(run.pixels, sums),
                       dropped);
}

}  // namespace bench
