#include "common/reference/continuation.h"

#include <fmt/format.h>

#include <charconv>

#include "common/core/input_error.h"

namespace common::reference {
namespace {

namespace fs = std::filesystem;

constexpr const char* fingerprint_key = "shlmbench:fingerprint";
constexpr const char* seed_key = "shlmbench:seed";
constexpr const char* camera_key = "shlmbench:camera";
constexpr const char* passes_key = "shlmbench:passes";
constexpr const char* dropped_key = "shlmbench:samples_dropped";

std::string note(const ReferenceImage& image, const char* key) {
    const auto found = image.notes.find(key);
    return found == image.notes.end() ? "none" : found->second;
}

std::uint64_t count_in(const fs::path& file, const ReferenceImage& image, const char* key) {
    const std::string text = note(image, key);
    std::uint64_t count = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    if (error != std::errc{} || end != text.data() + text.size())
        throw InputError(fmt::format("{} is not a reference: its note {} is {}", file.string(), key, text));
    return count;
}

void require(const fs::path& file, const char* what, const std::string& there, const std::string& wanted) {
    if (there != wanted)
        throw InputError(fmt::format("{} is a reference with another {}: {} there, {} asked for",
                                     file.string(), what, there, wanted));
}

void require_same(const fs::path& file, const ReferenceImage& image, const ReferenceIdentity& identity) {
    require(file, "scene fingerprint", note(image, fingerprint_key), identity.fingerprint);
    require(file, "seed", note(image, seed_key), std::to_string(identity.seed));
    require(file, "size", fmt::format("{} x {}", image.width, image.height),
            fmt::format("{} x {}", identity.width, identity.height));
    require(file, "camera", note(image, camera_key), identity.camera);
}

}  // namespace

std::string describe(const Camera& camera) {
    const auto text = [](const Vec3& v) { return fmt::format("{},{},{}", v.x, v.y, v.z); };
    return fmt::format("eye {} forward {} up {} fov {}", text(camera.eye), text(camera.forward),
                       text(camera.up), camera.vertical_fov);
}

ImageNotes continuation_notes(const ReferenceIdentity& identity, const ReferenceSums& sums) {
    return {{fingerprint_key, identity.fingerprint},
            {seed_key, std::to_string(identity.seed)},
            {camera_key, identity.camera},
            {passes_key, std::to_string(sums.passes)},
            {dropped_key, std::to_string(sums.dropped)}};
}

std::optional<ReferenceSums> sums_to_go_on_from(const fs::path& file, const ReferenceIdentity& identity) {
    std::error_code error;
    const bool exists = fs::exists(file, error);
    if (error) throw InputError(fmt::format("{}: {}", file.string(), error.message()));
    if (!exists) return std::nullopt;
    const ReferenceImage image = read_reference(file);
    require_same(file, image, identity);
    ReferenceSums sums(image.pixel.size());
    sums.passes = count_in(file, image, passes_key);
    sums.dropped = count_in(file, image, dropped_key);
    for (std::size_t p = 0; p < image.pixel.size(); ++p) {
        const ReferencePoint& point = image.pixel[p];
        for (int c = 0; c < 3; ++c)
            sums.pixel[p][c] = {{point.irradiance[c], point.irradiance_low[c]},
                                {point.variance[c], point.variance_low[c]}};
    }
    return sums;
}

}  // namespace common::reference
