#include "shlm/layout/texel_charts.h"

#include <oneapi/tbb/parallel_for.h>

#include <iterator>
#include <numeric>

#include "shlm/layout/face_charts.h"
#include "shlm/layout/texel_layout.h"
#include "shlm/layout/uv_chart.h"

namespace shlm {
namespace {

using common::Scene;

std::vector<TexelChart> charts_at_size(const Scene& scene, std::span<const LightmapUv> uv,
                                       TexelPlacement placement, double texel_size) {
    std::vector<std::vector<TexelChart>> of_instance(scene.instance.size());
    tbb::parallel_for(std::size_t{0}, of_instance.size(), [&](std::size_t i) {
        const common::MeshInstance& instance = scene.instance[i];
        std::vector<std::uint32_t> by_face;
        if (placed_by_uv(uv[i], placement)) {
            of_instance[i].push_back(uv_chart(scene, instance, uv[i], placement == TexelPlacement::uv));
            if (placement == TexelPlacement::automatic) by_face = uv[i].useless_triangles();
        } else if (placed_by_face(uv[i], placement)) {
            by_face.resize(instance.triangle_count);
            std::iota(by_face.begin(), by_face.end(), instance.first_triangle);
        }
        if (by_face.empty()) return;
        std::vector<TexelChart> charts =
            face_charts(scene, by_face, scene.material[instance.material].double_sided, texel_size);
        std::move(charts.begin(), charts.end(), std::back_inserter(of_instance[i]));
    });
    std::vector<TexelChart> charts;
    for (std::vector<TexelChart>& some : of_instance)
        std::move(some.begin(), some.end(), std::back_inserter(charts));
    return charts;
}

/// Returns the size if whole texels filled the area exactly.
double ideal_texel_size(const Scene& scene, std::span<const LightmapUv> uv, std::size_t wanted_texels) {
    double area = 0;
    for (std::size_t i = 0; i < uv.size(); ++i)
        area += (scene.material[scene.instance[i].material].double_sided ? 2 : 1) * uv[i].area;
    return std::sqrt(area / static_cast<double>(wanted_texels));
}

}  // namespace

bool placed_by_uv(const LightmapUv& uv, TexelPlacement placement) {
    if (uv.texcoord_set < 0 || placement == TexelPlacement::face) return false;
    return placement == TexelPlacement::uv || uv.is_lightmap();
}

bool placed_by_face(const LightmapUv& uv, TexelPlacement placement) {
    return uv.area > 0 && placement != TexelPlacement::uv && !placed_by_uv(uv, placement);
}

std::vector<TexelChart> texel_charts(const Scene& scene, std::span<const LightmapUv> uv,
                                     TexelPlacement placement, std::size_t wanted_texels) {
    // Surfaces may have pieces smaller than texels. Then texels must be larger, so that there are no more
    // than wanted: more of the surface is flat to them, and has fewer charts.
    constexpr int most_attempts = 20;
    const auto wanted = static_cast<double>(wanted_texels);
    double size = ideal_texel_size(scene, uv, wanted_texels);
    for (int attempt = 1;; ++attempt) {
        std::vector<TexelChart> charts = charts_at_size(scene, uv, placement, size);
        const double excess = texels_at_size(charts, size) / wanted;
        if (placement == TexelPlacement::uv || excess <= 1.1 || attempt == most_attempts) return charts;
        size *= std::min(std::sqrt(excess), 2.0);
    }
}

}  // namespace shlm
