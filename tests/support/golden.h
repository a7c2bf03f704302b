// Golden images: renders them, and judges whether an image still equals one.
#pragma once

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <string>

#include "bench/contenders/picture.h"

namespace golden {

namespace fs = std::filesystem;

inline constexpr std::array<const char*, 4> scenes = {"cornell", "bumpy", "caustic", "atrium"};
inline constexpr std::array<const char*, 2> methods = {"photonmap/flann", "shlm"};
inline constexpr std::uint64_t seed = 1;

/// Returns tests/golden/SCENE-METHOD.exr in the source tree.
inline fs::path file_of(const std::string& scene, std::string method) {
    std::replace(method.begin(), method.end(), '/', '-');
    return fs::path(SHLMBENCH_GOLDEN_FOLDER) / fmt::format("{}-{}.exr", scene, method);
}

/// Renders one of the project's own scenes with the settings of the golden images.
inline common::Image render(const std::string& scene, const std::string& method, std::uint64_t with_seed) {
    constexpr int width = 96, height = 54;
    constexpr std::uint64_t hits = 200'000;
    const bench::LoadedScene loaded(fmt::format("{}/scenes/{}.glb", SHLMBENCH_BINARY_DIR, scene), {});
    const common::PhotonSource source(loaded.scene);
    bench::ContenderSettings settings;
    settings.texels.count = 16'384;  // a dozen hits per texel
    bench::PreparedScene prepared(loaded, settings);
    const auto pixels = common::visible_surfaces(loaded.rays, loaded.camera, width, height);
    return bench::render_run(bench::parse_contender("golden", method), prepared,
                             {loaded.rays, source, with_seed, {.hits = hits}}, pixels, width, height);
}

/// Returns why two images cannot be compared at all: sizes, channels, or values that are not finite. Empty if
/// they can.
inline std::string obstacle(const OIIO::ImageBuf& image, const OIIO::ImageBuf& expected) {
    const OIIO::ImageSpec &a = image.spec(), &b = expected.spec();
    if (a.width != b.width || a.height != b.height)
        return fmt::format("{} x {} pixels instead of {} x {}", a.width, a.height, b.width, b.height);
    if (a.channelnames != b.channelnames)
        return fmt::format("channels {} instead of {}", fmt::join(a.channelnames, ","),
                           fmt::join(b.channelnames, ","));
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            for (int c = 0; c < a.nchannels; ++c)
                if (!std::isfinite(image.getchannel(x, y, 0, c)))
                    return fmt::format("channel {} of pixel ({}, {}) is not finite", a.channelnames[c], x, y);
    return "";
}

/// The difference of two images of the same size, over one group of channels.
struct Difference {
    double relative_rms;   ///< root mean square of the difference over that of the expected image
    double changed_share;  ///< fraction of pixels that differ by more than 1 % of the expected image's root
                           ///< mean square
};

/// Compares the channels from `first` to before `end`.
inline Difference difference(const OIIO::ImageBuf& image, const OIIO::ImageBuf& expected, int first,
                             int end) {
    OIIO::ROI channels = expected.roi();
    channels.chbegin = first;
    channels.chend = end;
    OIIO::ImageBuf black(expected.spec());
    OIIO::ImageBufAlgo::zero(black);
    const double rms = OIIO::ImageBufAlgo::compare(expected, black, 0, 0, channels).rms_error;
    const auto threshold = static_cast<float>(0.01 * rms);
    const auto result = OIIO::ImageBufAlgo::compare(image, expected, threshold, threshold, channels);
    return {result.rms_error / rms,
            static_cast<double>(result.nfail) / static_cast<double>(expected.spec().image_pixels())};
}

/// Bounds for an image to be the same: the largest fraction of changed pixels, and the largest relative RMS
/// as a fraction of the noise.
///
/// The same seed gives the same photons. But rounding differs between compilers, instruction sets and
/// versions of Embree and libm, and occasionally sends a photon past the other side of an edge. Such a photon
/// changes only the pixels that gather it or its later hits. A wrong factor, or light elsewhere, changes
/// nearly all pixels. If a fraction f of all photons differed, the RMS would be sqrt(f) of that between two
/// seeds: the second bound is f = 1/100.
///
/// Measured: nothing changes without optimisation, or when compiled for generic x86-64. With -ffast-math,
/// which rounds differently everywhere, one pixel in 5184 changes, and the RMS is 0.0004. Between two seeds 4
/// pixels of 5 change, and the RMS is 0.02 to 0.22.
inline constexpr double max_changed_share = 0.01, max_rms_to_noise = 0.1;

/// Returns how `image` differs from `expected`; empty if it is the same. `other_seed` is the same picture
/// from other photons; its difference is the noise.
inline std::string deviation(const OIIO::ImageBuf& image, const OIIO::ImageBuf& expected,
                             const OIIO::ImageBuf& other_seed) {
    struct Group {
        const char* name;
        int first, end;
    };
    for (const Group& group : {Group{"radiance", 0, 3}, Group{"irradiance", 4, 7}}) {
        const Difference found = difference(image, expected, group.first, group.end);
        if (!(found.changed_share <= max_changed_share))
            return fmt::format("{}: {:.1f} % of the pixels have changed", group.name,
                               100 * found.changed_share);
        const double noise = difference(other_seed, expected, group.first, group.end).relative_rms;
        if (!(found.relative_rms <= max_rms_to_noise * noise))
            return fmt::format("{}: relative rms difference {:.4f} where the noise is {:.4f}", group.name,
                               found.relative_rms, noise);
    }
    return "";
}

}  // namespace golden
