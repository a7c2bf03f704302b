// viewer.html: the lit scene, and a page that draws it, in one file that needs no server.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "bench/export/lit_mesh.h"
#include "common/view/visible_surfaces.h"

namespace bench {

/// What the program answers at the points that the stored camera sees: what the page's pixels are held
/// against.
struct AnsweredView {
    int width = 0, height = 0;
    std::vector<std::optional<PrimitivePoint>> place;  ///< of each pixel's point in lit.glb
    std::vector<common::VisibleSurface> pixel;         ///< row by row from the top left one
    /// By name, "reference" among them where there is one: irradiance at each pixel's point, W/m^2; zero
    /// where the pixel sees no surface.
    std::vector<std::pair<std::string, std::vector<common::Rgb>>> answers;
    /// By the name of an answer: what a viewer sees of its error at each pixel (common::flip_map), where
    /// there is a reference.
    std::vector<std::pair<std::string, std::vector<float>>> flip;
};

/// Larger scenes are not put into the page, which then asks for lit.glb.
inline constexpr std::size_t most_page_bytes = std::size_t{6} << 20;

/// `facts`: what the page says of where the scene comes from.
[[nodiscard]] std::string viewer_page(const std::string& glb, const nlohmann::ordered_json& facts,
                                      const AnsweredView& view);

/// The constants of the fragment program: GLSL lines, made from those that the library uses.
[[nodiscard]] std::string glsl_constants();

}  // namespace bench
