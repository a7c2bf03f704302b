// A floor cut into triangles of any size, under a lightmap whose texels do not fit them.
#pragma once

#include "bench/experiments/stability/known_light.h"

namespace bench::stability {

/// A floor of 1 x 1 in the plane z = 0, cut into `cells` x `cells` squares of two triangles each, as in
/// scene_builder::quad. A lightmap of `texels_along` x `texels_along` texels covers it.
struct TiledFloor {
    int cells, texels_along;
    common::Scene scene;
    shlm::PreparedTexels texels;

    TiledFloor(int cells_along, int texels_along_it)
        : cells(cells_along),
          texels_along(texels_along_it),
          scene(scene_of(cells_along)),
          texels(texels_of(scene, static_cast<std::size_t>(texels_along_it * texels_along_it))) {}

    /// Returns the surface coordinates of (x, y) on the floor.
    [[nodiscard]] common::SurfaceId at(double x, double y) const {
        const auto cell = [&](double along) { return std::min(static_cast<int>(along * cells), cells - 1); };
        const int i = cell(x), j = cell(y);
        return scene_builder::on_quad(static_cast<std::uint32_t>(2 * (j * cells + i)),
                                      static_cast<float>(x * cells - i), static_cast<float>(y * cells - j));
    }

    /// Returns for each triangle whether a texel's centre lies in it.
    [[nodiscard]] std::vector<bool> has_texel_center() const {
        std::vector<bool> has(scene.triangle.size(), false);
        for (int j = 0; j < texels_along; ++j)
            for (int i = 0; i < texels_along; ++i)
                has[at((i + 0.5) / texels_along, (j + 0.5) / texels_along).triangle] = true;
        return has;
    }

    [[nodiscard]] double triangle_area_in_texels() const {
        return 0.5 * texels_along * texels_along / (cells * cells);
    }

  private:
    static common::Scene scene_of(int cells_along) {
        scene_builder::Mesh mesh;
        const auto corners = static_cast<std::uint32_t>(cells_along + 1);
        for (std::uint32_t j = 0; j < corners; ++j)
            for (std::uint32_t i = 0; i < corners; ++i) {
                const common::Vec2 at = common::Vec2(static_cast<float>(i), static_cast<float>(j)) /
                                        static_cast<float>(cells_along);
                mesh.position.emplace_back(at.x, at.y, 0.0f);
                mesh.texcoord[1].push_back(at);
            }
        for (std::uint32_t j = 1; j < corners; ++j)
            for (std::uint32_t i = 1; i < corners; ++i) {
                const std::uint32_t d = j * corners + i, c = d - 1, b = d - corners, a = b - 1;
                mesh.triangle.push_back({a, b, d});
                mesh.triangle.push_back({a, d, c});
            }
        common::Scene scene;
        add(scene, mesh, scene_builder::diffuse({1, 1, 1}));
        return scene;
    }
};

}  // namespace bench::stability
