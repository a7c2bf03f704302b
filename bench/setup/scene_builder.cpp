#include "bench/setup/scene_builder.h"

namespace bench::scene_builder {

Mesh quad(const Vec3& corner, const Vec3& edge_u, const Vec3& edge_v) {
    const std::vector<Vec2> square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    return {"quad",
            {corner, corner + edge_u, corner + edge_u + edge_v, corner + edge_v},
            {square, square},
            {},
            {},
            1,
            {{0, 1, 2}, {0, 2, 3}}};
}

SurfaceId on_quad(std::uint32_t first_triangle, float s, float t) {
    if (s >= t) return {first_triangle, s - t, t};
    return {first_triangle + 1, s, t - s};
}

Mesh with_lightmap_uv(Mesh mesh, std::vector<Vec2> uv) {
    mesh.texcoord[1] = std::move(uv);
    return mesh;
}

Mesh joined(Mesh a, const Mesh& b) {
    const auto first = static_cast<std::uint32_t>(a.position.size());
    const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    append(a.position, b.position);
    append(a.normal, b.normal);
    append(a.tangent, b.tangent);
    for (std::size_t set = 0; set < 2; ++set) append(a.texcoord[set], b.texcoord[set]);
    for (const auto& [i, j, k] : b.triangle) a.triangle.push_back({first + i, first + j, first + k});
    return a;
}

Mesh sphere(const Vec3& center, float radius, int levels) {
    Mesh mesh;
    mesh.normal = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    mesh.triangle = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    const auto halfway = [&](std::uint32_t a, std::uint32_t b) {
        mesh.normal.push_back((mesh.normal[a] + mesh.normal[b]).normalized());
        return static_cast<std::uint32_t>(mesh.normal.size() - 1);
    };
    for (int level = 0; level < levels; ++level) {
        std::vector<common::TriangleVertices> finer;
        for (const auto& [a, b, c] : mesh.triangle) {
            const std::uint32_t ab = halfway(a, b), bc = halfway(b, c), ca = halfway(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        mesh.triangle = finer;
    }
    for (const Vec3& normal : mesh.normal) mesh.position.push_back(center + normal * radius);
    return mesh;
}

Material diffuse(const Rgb& albedo, const Rgb& emitted_radiance) {
    Material material;
    material.base_color = albedo;
    material.emitted_radiance = emitted_radiance;
    return material;
}

Material double_sided(Material material) {
    material.double_sided = true;
    return material;
}

Material mirror(const Rgb& reflectance) {
    Material material = diffuse(reflectance);
    material.kind = common::SurfaceKind::mirror;
    return material;
}

Material glass(float index_of_refraction) {
    Material material = diffuse(Rgb(1, 1, 1));
    material.kind = common::SurfaceKind::dielectric;
    material.index_of_refraction = index_of_refraction;
    return material;
}

std::uint32_t add(Scene& scene, const Mesh& mesh, const Material& material) {
    const auto first_vertex = static_cast<std::uint32_t>(scene.position.size());
    const std::size_t count = mesh.position.size();
    const auto append = [](auto& to, auto from, std::size_t size) {
        from.resize(size);
        to.insert(to.end(), from.begin(), from.end());
    };
    common::MeshInstance instance;
    instance.name = mesh.name;
    instance.first_triangle = static_cast<std::uint32_t>(scene.triangle.size());
    instance.triangle_count = static_cast<std::uint32_t>(mesh.triangle.size());
    instance.material = static_cast<std::uint32_t>(scene.material.size());
    append(scene.position, mesh.position, count);
    append(scene.normal, mesh.normal.empty() ? std::vector<Vec3>(count, Vec3(0, 0, 0)) : mesh.normal, count);
    append(scene.tangent, mesh.tangent.empty() ? std::vector<Vec3>(count, Vec3(0, 0, 0)) : mesh.tangent,
           count);
    append(scene.tangent_sign, std::vector<float>(count, mesh.tangent_sign), count);
    for (std::size_t set = 0; set < 2; ++set) {
        instance.has_texcoord[set] = !mesh.texcoord[set].empty();
        append(scene.texcoord[set], mesh.texcoord[set], count);
    }
    for (const auto& [i, j, k] : mesh.triangle) {
        const Vec3 &a = mesh.position[i], &b = mesh.position[j], &c = mesh.position[k];
        const Imath::V3d edge_b = Imath::V3d(b) - Imath::V3d(a), edge_c = Imath::V3d(c) - Imath::V3d(a);
        const Vec3 normal(edge_b.cross(edge_c).normalized());
        scene.triangle.push_back({first_vertex + i, first_vertex + j, first_vertex + k});
        scene.geometric_normal.push_back(normal);
        scene.instance_of.push_back(static_cast<std::uint32_t>(scene.instance.size()));
        if (mesh.normal.empty())
            for (std::uint32_t corner : {i, j, k}) scene.normal[first_vertex + corner] = normal;
    }
    for (const Vec3& p : mesh.position) scene.bounds.extendBy(p);
    scene.instance.push_back(instance);
    scene.material.push_back(material);
    return static_cast<std::uint32_t>(scene.instance.size() - 1);
}

std::array<Mesh, 6> box_walls(const Vec3& low, const Vec3& high) {
    const Vec3 size = high - low, x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z);
    return {quad(low, y, z),     quad(low + x, z, y), quad(low, z, x),
            quad(low + y, x, z), quad(low, x, y),     quad(low + z, y, x)};
}

Scene closed_box(const Material& material, const Vec3& low, const Vec3& high) {
    Scene scene;
    for (const Mesh& wall : box_walls(low, high)) add(scene, wall, material);
    return scene;
}

Imath::M44f skew_rotation() {
    return Imath::M44f().rotate(Imath::V3f(0.4f, 0.7f, 1.1f));
}

Scene moved(Scene scene, const Imath::M44f& rotation, const Vec3& offset) {
    const auto turned = [&](const Vec3& v) {
        Vec3 result;
        rotation.multDirMatrix(v, result);
        return result;
    };
    scene.bounds.makeEmpty();
    for (Vec3& p : scene.position) scene.bounds.extendBy(p = turned(p) + offset);
    for (std::size_t t = 0; t < scene.triangle.size(); ++t) {
        const auto [a, b, c] = scene.triangle[t];
        const Imath::V3d origin(scene.position[a]);
        scene.geometric_normal[t] = Vec3((Imath::V3d(scene.position[b]) - origin)
                                             .cross(Imath::V3d(scene.position[c]) - origin)
                                             .normalized());
    }
    for (Vec3& n : scene.normal) n = turned(n).normalized();
    for (Vec3& t : scene.tangent) t = turned(t);
    for (auto& light : scene.point_light) light.position = turned(light.position) + offset;
    for (auto& light : scene.spot_light) {
        light.position = turned(light.position) + offset;
        light.axis = turned(light.axis).normalized();
    }
    for (auto& light : scene.directional_light) light.direction = turned(light.direction).normalized();
    return scene;
}

SurfacePoint front_of(const Scene& scene, const SurfaceId& surface) {
    return common::surface_point_at(scene, surface, -scene.geometric_normal[surface.triangle]);
}

SurfacePoint tilted(SurfacePoint point, double angle, double turn) {
    point.shading_normal =
        common::Frame(point.geometric_normal)
            .to_world(common::direction_at(static_cast<float>(std::cos(angle)), static_cast<float>(turn)));
    return point;
}

}  // namespace bench::scene_builder
