#include "common/reference/reference_pass.h"

#include <oneapi/tbb/parallel_for.h>

namespace common::reference {
namespace {

using Imath::V3d;

/// Pixels between two calls of the progress function.
constexpr std::size_t pixels_per_part = 1024;

struct PixelPass {
    V3d mean{0, 0, 0};
    std::uint32_t dropped = 0;
};

PixelPass sample_pixel(const RayScene& rays, const Lights& lights, const SurfacePoint& point,
                       std::uint64_t seed, std::uint32_t pixel, std::uint32_t pass, int most_surfaces) {
    const PassStrata strata(seed, pixel, pass);
    PixelPass result;
    for (std::uint32_t i = 0; i < samples_per_pass; ++i) {
        RandomStream stream(seed, pixel, pass, i);
        const V3d sample =
            sample_irradiance(rays, lights, point, strata.numbers(i, stream), stream, most_surfaces);
        if (std::isfinite(sample.x + sample.y + sample.z))
            result.mean += sample;
        else
            ++result.dropped;
    }
    result.mean /= samples_per_pass;
    return result;
}

}  // namespace

bool add_pass(const RayScene& rays, const Lights& lights, std::span<const VisibleSurface> pixels,
              std::uint64_t seed, ReferenceSums& sums, const PassProgress& progress, int most_surfaces) {
    std::vector<PixelPass> pass(pixels.size());
    for (std::size_t first = 0; first < pixels.size(); first += pixels_per_part) {
        if (!progress(first)) return false;
        const std::size_t last = std::min(first + pixels_per_part, pixels.size());
        tbb::parallel_for(first, last, [&](std::size_t p) {
            if (pixels[p].present)
                pass[p] = sample_pixel(rays, lights, pixels[p].point, seed, static_cast<std::uint32_t>(p),
                                       static_cast<std::uint32_t>(sums.passes), most_surfaces);
        });
    }
    for (std::size_t p = 0; p < pixels.size(); ++p) {
        for (int c = 0; c < 3; ++c) sums.pixel[p][c].add(pass[p].mean[c], sums.passes);
        sums.dropped += pass[p].dropped;
    }
    ++sums.passes;
    return true;
}

double relative_error(std::span<const VisibleSurface> pixels, const ReferenceSums& sums) {
    double mean = 0, count = 0;
    for (std::size_t p = 0; p < pixels.size(); ++p)
        for (const RunningMean& channel : sums.pixel[p]) {
            if (!pixels[p].present) continue;
            mean += channel.mean().value();
            ++count;
        }
    if (mean == 0) return 0;
    mean /= count;
    double sum = 0;
    for (std::size_t p = 0; p < pixels.size(); ++p)
        for (const RunningMean& channel : sums.pixel[p]) {
            if (!pixels[p].present) continue;
            const double irradiance = channel.mean().value();
            sum += channel.variance().value() / (irradiance * irradiance + 0.01 * mean * mean);
        }
    return std::sqrt(sum / count);
}

}  // namespace common::reference
