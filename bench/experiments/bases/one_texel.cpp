#include "bench/experiments/bases/one_texel.h"

namespace bench::bases {
namespace {

using common::Vec2;
using common::Vec3;

/// Where photons land and the map is evaluated; all points of one texel are alike.
constexpr common::SurfaceId middle = {0, 0.25f, 0.25f};

/// Makes two triangles at z = 0 that face +z. Their area is 4, as an area of 1 would hide a missing division
/// by it.
common::Scene quad() {
    common::Scene scene;
    scene.source = "one texel";
    for (const Vec2& corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)})
        scene.position.emplace_back(corner.x, corner.y, 0.0f);
    scene.normal.assign(4, Vec3(0, 0, 1));
    scene.texcoord.fill({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    scene.tangent.assign(4, Vec3(0, 0, 0));
    scene.tangent_sign.assign(4, 1.0f);
    scene.triangle = {{0, 1, 2}, {0, 2, 3}};
    scene.geometric_normal.assign(2, Vec3(0, 0, 1));
    scene.instance_of.assign(2, 0);
    scene.instance = {{"quad", 0, 2, 0, {true, true}}};
    scene.material.emplace_back();
    for (const Vec3& position : scene.position) scene.bounds.extendBy(position);
    return scene;
}

}  // namespace

OneTexel::OneTexel() : scene_(quad()), prepared_(scene_, shlm::find_lightmap_uv(scene_), 1) {}

common::HitBatch OneTexel::photons_of(std::span<const Arrival> arrivals) const {
    const double area = prepared_.geometry.front().area;
    const Vec3 position = common::position_at(scene_, middle);
    common::HitBatch photons;
    photons.reserve(arrivals.size());
    for (const Arrival& arrival : arrivals) {
        const auto flux = static_cast<float>(arrival.irradiance * area);
        photons.push_back(position, -arrival.towards_light, arrival.tint * flux, middle);
    }
    return photons;
}

common::SurfacePoint OneTexel::point_with(const Vec3& shading_normal) const {
    common::SurfacePoint point = common::surface_point_at(scene_, middle, {0, 0, -1});
    point.shading_normal = shading_normal;
    return point;
}

}  // namespace bench::bases
