#include "bench/export/lit_mesh.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "common/scene/surface_point.h"

namespace bench {
namespace {

using common::Scene;
using common::Vec2;
using common::Vec3;
using Rectangle = shlm::TexelAtlas::Rectangle;

bool reads_the_same(const common::TextureUse& a, const common::TextureUse& b) {
    return a.texcoord_set == b.texcoord_set && a.transform == b.transform;
}

/// The place of the coordinates among the sets, which grow where they are new; -1 without a texture.
int set_of(const common::TextureUse& use, std::vector<common::TextureUse>& sets) {
    if (use.texture == common::no_texture) return -1;
    const auto found =
        std::find_if(sets.begin(), sets.end(), [&](const auto& set) { return reads_the_same(set, use); });
    if (found != sets.end()) return static_cast<int>(found - sets.begin());
    sets.push_back(use);
    return static_cast<int>(sets.size()) - 1;
}

/// One side of one instance.
class PrimitiveBuilder {
  public:
    PrimitiveBuilder(const Scene& scene, const shlm::TexelLayout& layout, const shlm::TexelPlaces& places,
                     const LightAtlas& atlas, std::uint32_t instance, bool back)
        : scene_(scene),
          layout_(layout),
          places_(places),
          atlas_(atlas.places),
          material_(scene.material[scene.instance[instance].material]),
          use_(texcoord_use(material_)) {
        made_.instance = instance;
        made_.back = back;
    }

    void add_triangle(std::uint32_t triangle) {
        const Rectangle* rectangle = rectangle_of(triangle);
        const common::MapTangent own = own_tangent(triangle);
        std::array<std::uint32_t, 3> corner;
        for (std::size_t i = 0; i < 3; ++i) corner[i] = vertex(triangle, i, rectangle, own);
        if (made_.back) std::swap(corner[1], corner[2]);
        made_.index.insert(made_.index.end(), corner.begin(), corner.end());
        made_.triangle.push_back(triangle);
        made_.lit |= rectangle != nullptr;
    }

    [[nodiscard]] LitPrimitive take() && {
        made_.both_faces = material_.double_sided && !made_.lit;
        return std::move(made_);
    }

  private:
    using Key = std::tuple<std::uint32_t, std::uint32_t, float, float, float, float>;

    /// Null where the triangle's side has no texels.
    [[nodiscard]] const Rectangle* rectangle_of(std::uint32_t triangle) const {
        const shlm::TriangleTexels& texels = layout_.triangle(triangle);
        if (texels.width == 0 || (made_.back && !texels.both_faces)) return nullptr;
        const shlm::TexelRegion& region = layout_.regions()[layout_.region_of(triangle)];
        return &atlas_.rectangle(region.first_texel_of(made_.back));
    }

    [[nodiscard]] bool has_normal_map() const { return use_.normal >= 0; }

    /// The triangle's own tangent where its vertices have none; zero where they do, or nobody asks.
    [[nodiscard]] common::MapTangent own_tangent(std::uint32_t triangle) const {
        if (!has_normal_map()) return {Vec3(0, 0, 0), 1};
        for (const std::uint32_t v : scene_.triangle[triangle])
            if (scene_.tangent[v].length2() > 0) return {Vec3(0, 0, 0), 1};
        return common::triangle_tangent(scene_, triangle, material_.normal_texture);
    }

    std::uint32_t vertex(std::uint32_t triangle, std::size_t corner, const Rectangle* rectangle,
                         const common::MapTangent& own) {
        const std::uint32_t v = scene_.triangle[triangle][corner];
        const Vec3& t = own.tangent;
        const Key key{v, rectangle ? rectangle->first_texel : shlm::no_texel, t.x, t.y, t.z, own.sign};
        const auto [found, is_new] =
            index_of_.try_emplace(key, static_cast<std::uint32_t>(made_.position.size()));
        if (is_new) {
            add_surface(v, own);
            add_place(triangle, corner, rectangle);
        }
        return found->second;
    }

    void add_surface(std::uint32_t v, const common::MapTangent& own) {
        const float side = made_.back ? -1.0f : 1.0f;
        made_.position.push_back(scene_.position[v]);
        made_.normal.push_back(scene_.normal[v] * side);
        if (has_normal_map()) {
            const bool by_vertex = scene_.tangent[v].length2() > 0;
            const Vec3 tangent = by_vertex ? scene_.tangent[v] : own.tangent;
            const float sign = by_vertex ? scene_.tangent_sign[v] : own.sign;
            // Where coordinates have no area any direction along the surface is as good.
            const Vec3 unit = tangent.length2() > 0 ? tangent.normalized() : perpendicular(scene_.normal[v]);
            made_.tangent.emplace_back(unit.x * side, unit.y * side, unit.z * side, sign * side);
        }
        for (std::size_t i = 0; i < use_.set.size(); ++i)
            made_.texcoord[i].push_back(use_.set[i].transform(scene_.texcoord[use_.set[i].texcoord_set][v]));
        if (!scene_.color.empty()) {
            const common::Rgb& color = scene_.color[v];
            made_.color.emplace_back(color.x, color.y, color.z, scene_.alpha.empty() ? 1 : scene_.alpha[v]);
        }
    }

    static Vec3 perpendicular(const Vec3& normal) {
        return normal.cross(std::abs(normal.x) < 0.5f ? Vec3(1, 0, 0) : Vec3(0, 1, 0)).normalized();
    }

    /// Coordinates as finished maps find them (TexelPlaces), so that all programs read the same texels.
    void add_place(std::uint32_t triangle, std::size_t corner, const Rectangle* rectangle) {
        if (!rectangle) {
            made_.light_texcoord.emplace_back(0.0f, 0.0f);
            made_.light_rectangle.emplace_back(0.0f, 0.0f, 0.0f, 0.0f);
            return;
        }
        common::SurfacePoint point{};
        point.surface = {triangle, corner == 1 ? 1.0f : 0.0f, corner == 2 ? 1.0f : 0.0f};
        point.position = scene_.position[scene_.triangle[triangle][corner]];
        point.front = !made_.back;
        const Vec2 at = places_.find(point)->at;
        const auto left = static_cast<float>(rectangle->left), top = static_cast<float>(rectangle->top);
        made_.light_texcoord.emplace_back((left + at.x) / static_cast<float>(atlas_.width()),
                                          (top + at.y) / static_cast<float>(atlas_.height()));
        made_.light_rectangle.emplace_back(left, top, static_cast<float>(rectangle->width),
                                           static_cast<float>(rectangle->height));
    }

    const Scene& scene_;
    const shlm::TexelLayout& layout_;
    const shlm::TexelPlaces& places_;
    const shlm::TexelAtlas& atlas_;
    const common::Material& material_;
    TexcoordUse use_;
    LitPrimitive made_;
    std::map<Key, std::uint32_t> index_of_;
};

}  // namespace

PrimitivePoints::PrimitivePoints(std::span<const LitPrimitive> primitives) {
    for (std::uint32_t p = 0; p < primitives.size(); ++p)
        for (std::uint32_t t = 0; t < primitives[p].triangle.size(); ++t)
            place_[{primitives[p].triangle[t], primitives[p].back}] = {p, t};
}

std::optional<PrimitivePoint> PrimitivePoints::find(const common::SurfacePoint& point) const {
    const auto found = place_.find({point.surface.triangle, !point.front});
    if (found == place_.end()) return std::nullopt;
    const auto [primitive, triangle] = found->second;
    const float u = point.surface.u, v = point.surface.v;
    if (point.front) return PrimitivePoint{primitive, triangle, u, v};
    return PrimitivePoint{primitive, triangle, v, u};  // a back's corners are turned round
}

TexcoordUse texcoord_use(const common::Material& material) {
    TexcoordUse use;
    use.base_color = set_of(material.base_color_texture, use.set);
    use.normal = set_of(material.normal_texture, use.set);
    use.emissive = set_of(material.emissive_texture, use.set);
    return use;
}

std::vector<LitPrimitive> lit_primitives(const Scene& scene, const shlm::TexelLayout& layout,
                                         const LightAtlas& atlas) {
    const shlm::TexelPlaces places(layout);
    std::vector<LitPrimitive> primitives;
    for (std::uint32_t i = 0; i < scene.instance.size(); ++i) {
        const common::MeshInstance& instance = scene.instance[i];
        if (instance.triangle_count == 0) continue;
        for (const bool back : {false, true}) {
            PrimitiveBuilder builder(scene, layout, places, atlas, i, back);
            std::size_t added = 0;
            for (std::uint32_t t = instance.first_triangle;
                 t < instance.first_triangle + instance.triangle_count; ++t) {
                if (back && !layout.triangle(t).both_faces) continue;
                builder.add_triangle(t);
                ++added;
            }
            if (added > 0) primitives.push_back(std::move(builder).take());
        }
    }
    return primitives;
}

}  // namespace bench
