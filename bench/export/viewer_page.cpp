#include "bench/export/viewer_page.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>

#include "bench/export/viewer_assets.h"
#include "common/difference/flip.h"
#include "common/estimator/irradiance_estimator.h"
#include "common/view/render.h"
#include "shlm/basis/sh_basis.h"

namespace bench {
namespace {

using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "the page reads little-endian floats");

/// In this order, joined into one function that runs at once.
constexpr std::array<const char*, 11> scripts = {"tools.js",    "glb.js",    "shading.js", "renderer.js",
                                                 "camera.js",   "state.js",  "points.js",  "probe.js",
                                                 "controls.js", "timing.js", "main.js"};

/// Returns bytes in zlib's format, which browsers call deflate; empty where that takes more than `most`
/// bytes.
std::string deflated(std::string_view bytes, std::size_t most) {
    uLongf size = std::min<std::size_t>(compressBound(bytes.size()), most);
    std::string packed(size, '\0');
    const int ended =
        compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                  reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), Z_BEST_COMPRESSION);
    if (ended == Z_BUF_ERROR) return "";
    if (ended != Z_OK) throw std::runtime_error("zlib cannot compress the page's data");
    packed.resize(size);
    return packed;
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t three = 0;
        for (std::size_t k = 0; k < 3; ++k)
            three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k > bytes.size() ? '=' : digits[three >> (18 - 6 * k) & 63];
    }
    return text;
}

void append(std::vector<float>& floats, float x, float y, float z) {
    floats.insert(floats.end(), {x, y, z});
}

/// Places, four floats a pixel: primitive, triangle, u, v; the primitive is -1 where a pixel sees no surface.
/// Then, three floats a pixel: positions; radiance towards the camera for an irradiance of 1 and for 0, which
/// mirrors and glass on the way are part of; each answer. Then one float a pixel for each FLIP map.
std::string view_floats(const AnsweredView& view) {
    std::vector<float> floats;
    for (const std::optional<PrimitivePoint>& place : view.place) {
        const PrimitivePoint at = place.value_or(PrimitivePoint{0, 0, 0, 0});
        const float primitive = place ? static_cast<float>(at.primitive) : -1;
        floats.insert(floats.end(), {primitive, static_cast<float>(at.triangle), at.u, at.v});
    }
    for (const common::VisibleSurface& seen : view.pixel) {
        const common::Vec3 at = seen.present ? seen.point.position : common::Vec3(0, 0, 0);
        append(floats, at.x, at.y, at.z);
    }
    for (const bool lit : {true, false})
        for (const common::VisibleSurface& seen : view.pixel) {
            const common::Rgb dark = common::radiance_towards_camera(seen, common::Rgb(0, 0, 0));
            const common::Rgb radiance =
                lit ? common::radiance_towards_camera(seen, common::Rgb(1, 1, 1)) - dark : dark;
            append(floats, radiance.x, radiance.y, radiance.z);
        }
    for (const auto& [name, answers] : view.answers)
        for (const common::Rgb& answer : answers) append(floats, answer.x, answer.y, answer.z);
    for (const auto& [name, map] : view.flip) floats.insert(floats.end(), map.begin(), map.end());
    std::string bytes(floats.size() * sizeof(float), '\0');
    std::memcpy(bytes.data(), floats.data(), bytes.size());
    return bytes;
}

Json description_of(const AnsweredView& view) {
    Json answers = Json::array(), flip = Json::array();
    for (const auto& [name, values] : view.answers) answers.push_back(name);
    for (const auto& [name, map] : view.flip)
        flip.push_back({{"of", name}, {"mean", common::flip_mean(map)}});
    return {{"width", view.width}, {"height", view.height}, {"answers", answers}, {"flip", flip}};
}

/// JSON that cannot end the script element that it stands in.
std::string script_json(const Json& json) {
    std::string text;
    for (const char c : json.dump(-1, ' ', true))
        text += c == '<' ? std::string("\\u003c") : std::string(1, c);
    return text;
}

std::string html_text(std::string_view text) {
    std::string safe;
    for (const char c : text)
        safe += c == '<' ? std::string("&lt;") : c == '&' ? std::string("&amp;") : std::string(1, c);
    return safe;
}

/// {{NAME}} in the template by its part; parts are not looked through.
std::string filled(std::string_view page, std::span<const std::pair<std::string_view, std::string>> parts) {
    std::string made;
    while (!page.empty()) {
        const std::size_t start = page.find("{{");
        made += page.substr(0, start);
        if (start == std::string_view::npos) break;
        const std::size_t end = page.find("}}", start);
        const std::string_view name = page.substr(start + 2, end - start - 2);
        for (const auto& [key, part] : parts)
            if (key == name) made += part;
        page.remove_prefix(end + 2);
    }
    return made;
}

}  // namespace

std::string glsl_constants() {
    using namespace shlm::sh_constants;
    std::string lines;
    for (const auto& [name, value] :
         {std::pair("C0", c0), std::pair("C1", c1), std::pair("C2", c2), std::pair("C20", c20),
          std::pair("C22", c22), std::pair("C40", c40), std::pair("C41", c41), std::pair("C42", c42),
          std::pair("C43", c43), std::pair("C44", c44),
          std::pair("SAME_SURFACE_COSINE", common::same_surface_cosine)})
        lines += fmt::format("const float {} = {:.9f};\n", name, value);
    return lines;
}

std::string viewer_page(const std::string& glb, const Json& facts, const AnsweredView& view) {
    Json about = facts;
    about["view"] = description_of(view);
    about["glsl_constants"] = glsl_constants();
    std::string script = "(() => {\n\"use strict\";\n";
    for (const char* name : scripts) script += std::string(viewer_asset(name)) + "\n";
    script += "})();";
    const std::string scene = base64(deflated(glb, most_page_bytes / 4 * 3));  // four digits for three bytes
    const std::array<std::pair<std::string_view, std::string>, 7> parts = {{
        {"title", html_text(facts.at("scene").get<std::string>())},
        {"style", std::string(viewer_asset("viewer.css"))},
        {"vertex", std::string(viewer_asset("lit.vert"))},
        {"fragment", std::string(viewer_asset("lit.frag"))},
        {"about", script_json(about)},
        {"data", fmt::format("{{\"glb\":\"{}\",\"view\":\"{}\"}}", scene,
                             base64(deflated(view_floats(view), SIZE_MAX)))},
        {"script", script},
    }};
    return filled(viewer_asset("viewer.html"), parts);
}

}  // namespace bench
