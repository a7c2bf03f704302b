#include "common/gltf/duplicates.h"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <array>
#include <bit>
#include <limits>
#include <set>
#include <span>

namespace common::gltf {
namespace {

constexpr std::uint32_t empty = std::numeric_limits<std::uint32_t>::max();

using CornerPlaces = std::array<Vec3, 3>;

CornerPlaces corners_of(const Scene& scene, std::uint32_t triangle) {
    const auto [a, b, c] = scene.triangle[triangle];
    return {scene.position[a], scene.position[b], scene.position[c]};
}

/// Returns whether the corners are the same up to a cyclic shift.
bool are_the_same(const CornerPlaces& a, const CornerPlaces& b) {
    const auto shifted_by = [&](std::size_t shift) {
        return a[0] == b[shift] && a[1] == b[(shift + 1) % 3] && a[2] == b[(shift + 2) % 3];
    };
    return shifted_by(0) || shifted_by(1) || shifted_by(2);
}

std::uint64_t hash_of(const Vec3& position) {
    std::uint64_t hash = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto bits = std::bit_cast<std::uint32_t>(position[axis] + 0.0f);  // -0 is 0
        hash = (hash + bits + 1) * 0x9e3779b97f4a7c15;
        hash ^= hash >> 32;
    }
    return hash;
}

/// Returns one hash per triangle; duplicates have equal hashes.
std::vector<std::uint64_t> hashes_of(const Scene& scene) {
    std::vector<std::uint64_t> hashes(scene.triangle.size());
    tbb::parallel_for(std::size_t{0}, hashes.size(), [&](std::size_t t) {
        const auto [a, b, c] = corners_of(scene, static_cast<std::uint32_t>(t));
        hashes[t] = hash_of(a) + hash_of(b) + hash_of(c);
    });
    return hashes;
}

/// Returns the first duplicate of every triangle, or the triangle itself.
std::vector<std::uint32_t> first_of_the_same(const Scene& scene) {
    const std::vector<std::uint64_t> hashes = hashes_of(scene);
    const auto count = static_cast<std::uint32_t>(hashes.size());
    const std::size_t places = std::bit_ceil(2 * std::size_t{count});
    std::vector<std::uint32_t> table(places, empty), first(count);
    for (std::uint32_t t = 0; t < count; ++t) {
        const auto is_another = [&](std::uint32_t other) {
            return hashes[other] != hashes[t] ||
                   !are_the_same(corners_of(scene, other), corners_of(scene, t));
        };
        std::size_t place = hashes[t] & (places - 1);
        while (table[place] != empty && is_another(table[place])) place = (place + 1) & (places - 1);
        if (table[place] == empty) table[place] = t;
        first[t] = table[place];
    }
    return first;
}

bool is_glass(const Material& material) {
    return material.kind == SurfaceKind::dielectric || material.kind == SurfaceKind::thin_sheet;
}

/// Returns the priority of a triangle with this material among its duplicates: the highest is kept. 0 if it
/// has holes.
int claim_of(const Material& material) {
    if (material.alpha_mode != AlphaMode::opaque) return 0;
    if (is_glass(material)) return 1;
    return 2 + 2 * material.emits() + material.double_sided;
}

/// Returns for every triangle the one that is kept in its place: itself or a duplicate.
std::vector<std::uint32_t> kept_instead(const Scene& scene) {
    const std::vector<std::uint32_t> first = first_of_the_same(scene);
    std::vector<std::uint32_t> kept = first;  // per set of duplicates, indexed by its first
    for (std::uint32_t t = 0; t < first.size(); ++t)
        if (std::uint32_t& best = kept[first[t]];
            claim_of(scene.material_of(t)) > claim_of(scene.material_of(best)))
            best = t;
    std::vector<std::uint32_t> instead(first.size());
    for (std::uint32_t t = 0; t < first.size(); ++t) {
        const std::uint32_t best = kept[first[t]];
        const bool stays = claim_of(scene.material_of(t)) == 0 && claim_of(scene.material_of(best)) <= 1;
        instead[t] = stays ? t : best;
    }
    return instead;
}

void warn(const Scene& scene, std::span<const std::uint32_t> instead, Warnings& warnings) {
    double area = 0;
    std::size_t count = 0, with_another_material = 0;
    std::set<std::uint32_t> instances, instances_with_another_material;
    const auto material_of = [&](std::uint32_t t) { return scene.instance[scene.instance_of[t]].material; };
    for (std::uint32_t t = 0; t < instead.size(); ++t) {
        if (instead[t] == t) continue;
        ++count;
        area += double{triangle_area(scene, t)};
        instances.insert(scene.instance_of[t]);
        if (material_of(t) == material_of(instead[t])) continue;
        ++with_another_material;
        instances_with_another_material.insert(scene.instance_of[t]);
    }
    for (const std::uint32_t i : instances)
        warnings.add(
            fmt::format("{} triangles ({:.3g} m^2) lie exactly on others and are left out", count, area),
            scene.instance[i].name);
    for (const std::uint32_t i : instances_with_another_material)
        warnings.add(
            fmt::format("{} of the triangles left out have another material than those that they lie on",
                        with_another_material),
            scene.instance[i].name);
}

/// Removes the triangles in whose place another is kept, and instances without any left. Keeps the vertices.
void remove(Scene& scene, std::span<const std::uint32_t> instead) {
    std::vector<MeshInstance> instances;
    std::uint32_t next = 0;
    for (MeshInstance instance : scene.instance) {
        const std::uint32_t begin = instance.first_triangle, end = begin + instance.triangle_count;
        instance.first_triangle = next;
        for (std::uint32_t t = begin; t < end; ++t) {
            if (instead[t] != t) continue;
            scene.triangle[next] = scene.triangle[t];
            scene.geometric_normal[next] = scene.geometric_normal[t];
            scene.instance_of[next] = static_cast<std::uint32_t>(instances.size());
            ++next;
        }
        instance.triangle_count = next - instance.first_triangle;
        if (instance.triangle_count > 0) instances.push_back(instance);
    }
    scene.triangle.resize(next);
    scene.geometric_normal.resize(next);
    scene.instance_of.resize(next);
    scene.instance = std::move(instances);
}

}  // namespace

void leave_out_duplicates(Scene& scene, Warnings& warnings) {
    const std::vector<std::uint32_t> instead = kept_instead(scene);
    bool any = false;
    for (std::uint32_t t = 0; t < instead.size(); ++t) any = any || instead[t] != t;
    if (!any) return;
    warn(scene, instead, warnings);
    remove(scene, instead);
}

}  // namespace common::gltf
