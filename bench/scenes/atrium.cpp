// Two storeys of arcades round an open court under a skylight: the large scene.
#include "bench/scenes/architecture.h"
#include "bench/scenes/ornaments.h"
#include "bench/scenes/scenes.h"
#include "bench/scenes/shapes.h"

namespace scenes {
namespace {

// The court is measured between the corner piers.
constexpr int long_bays = 6, short_bays = 2;
constexpr float court_half_x = long_bays * arcade::bay / 2, court_half_z = short_bays * arcade::bay / 2;
constexpr float arcade_x = court_half_x + arcade::abacus / 2, arcade_z = court_half_z + arcade::abacus / 2;

constexpr float ground_springing = 3.2f, upper_springing = 2.4f;
constexpr float slab_bottom = ground_springing + arcade::wall_height, gallery_floor = slab_bottom + 0.4f;
constexpr float ceiling = gallery_floor + upper_springing + arcade::wall_height;
constexpr float lantern_top = ceiling + 1;

const Box hall{{-14, 0, -7}, {14, ceiling, 7}, {14, 5, 7}};            // cells of 2 m
const Box lantern{{-8, ceiling, -3}, {8, lantern_top, 3}, {8, 1, 3}};  // over the middle of the court

struct Materials {
    int bricks, floor_tiles, gallery_tiles, plaster, limestone, sandstone, marble, wood, brass, glaze, sky;
    int cloth[4];
};

SurfacePattern paving(int blocks, const Rgb& block) {
    return masonry({.columns = blocks,
                    .courses = blocks,
                    .running_bond = false,
                    .joint = 0.008f,
                    .relief = 0.004f,
                    .block = block,
                    .mortar = Rgb(0.36f, 0.34f, 0.31f),
                    .variation = 0.28f});
}

void add_cloths(SceneDescription& scene, Materials& materials) {
    constexpr Rgb colors[4]{Rgb(0.70f, 0.13f, 0.10f), Rgb(0.16f, 0.46f, 0.22f), Rgb(0.14f, 0.26f, 0.62f),
                            Rgb(0.78f, 0.55f, 0.16f)};
    const char* const names[4]{"red_cloth", "green_cloth", "blue_cloth", "ochre_cloth"};
    const int weave = scene.add_patterned("cloth", cloth(), 256);
    for (int i = 0; i < 4; ++i) {
        common::Material dyed = scene.material[weave];
        dyed.name = names[i];
        dyed.base_color = colors[i];
        dyed.double_sided = true;
        materials.cloth[i] = scene.add_material(std::move(dyed));
    }
}

Materials add_materials(SceneDescription& scene) {
    const SurfacePattern bricks = masonry({.columns = 4,
                                           .courses = 8,
                                           .running_bond = true,
                                           .joint = 0.010f,
                                           .relief = 0.010f,
                                           .block = Rgb(0.62f, 0.50f, 0.40f),
                                           .mortar = Rgb(0.56f, 0.53f, 0.48f),
                                           .variation = 0.25f});
    Materials materials{};
    materials.bricks = scene.add_patterned("bricks", bricks, 512);
    materials.floor_tiles = scene.add_patterned("floor_tiles", paving(4, Rgb(0.58f, 0.53f, 0.46f)), 512);
    materials.gallery_tiles = scene.add_patterned("gallery_tiles", paving(6, Rgb(0.60f, 0.42f, 0.32f)), 512);
    materials.plaster = scene.add_patterned("plaster", plaster(Rgb(0.68f, 0.65f, 0.60f)), 512);
    materials.limestone = scene.add_patterned("limestone", plaster(Rgb(0.66f, 0.61f, 0.53f)), 512);
    materials.sandstone = scene.add_patterned("sandstone", plaster(Rgb(0.63f, 0.54f, 0.42f)), 256);
    materials.marble = scene.add_patterned("marble", marble(Rgb(0.70f, 0.69f, 0.67f)), 512);
    materials.wood = scene.add_patterned("wood", wood(Rgb(0.42f, 0.27f, 0.15f)), 512);
    materials.brass = scene.add_diffuse("brass", {0.60f, 0.46f, 0.22f});
    materials.glaze = scene.add_diffuse("blue_glaze", {0.22f, 0.38f, 0.52f});
    materials.sky = scene.add_emitter("skylight", {9.0f, 10.0f, 11.0f});
    add_cloths(scene, materials);
    return materials;
}

bool under_lantern(int i, int j) {
    return i >= 3 && i < 11 && j >= 2 && j < 5;
}

/// Adds floor, walls, ceiling and lantern, which together are closed.
void add_shell(SceneDescription& scene, const Materials& materials) {
    MeshBuilder floor(4), walls(2.4f), roof(3), skylight;
    add_box_side(floor, hall, Side::bottom, Facing::inward);
    for (Side side : {Side::left, Side::right, Side::back, Side::front}) {
        add_box_side(walls, hall, side, Facing::inward);
        add_box_side(roof, lantern, side, Facing::inward);
    }
    add_box_side(roof, hall, Side::top, Facing::inward, [](int i, int j) { return !under_lantern(i, j); });
    add_box_side(skylight, lantern, Side::top, Facing::inward);
    scene.place("floor", floor, materials.floor_tiles);
    scene.place("walls", walls, materials.bricks);
    scene.place("roof", roof, materials.plaster);
    scene.place("skylight", skylight, materials.sky);
}

void add_rafters(SceneDescription& scene, const Materials& materials) {
    const float bottom = ceiling + 0.1f, top = ceiling + 0.45f, half_width = 0.09f;
    MeshBuilder rafter(1);
    add_box(rafter, {{-half_width, bottom, lantern.min.z}, {half_width, top, lantern.max.z}, {1, 1, 6}},
            {Side::back, Side::front});
    const int mesh = scene.add_mesh(rafter.finish());
    for (int i = -3; i <= 3; ++i)
        scene.place("rafter", mesh, materials.wood, translated({2.0f * static_cast<float>(i), 0, 0}));
}

/// Adds the gallery's floor: a ring around the court, whose inner edge is closed by a cornice.
void add_gallery(SceneDescription& scene, const Materials& materials) {
    MeshBuilder above(3), below(3);
    const Box ends[2]{
        {{hall.min.x, slab_bottom, -court_half_z}, {-court_half_x, gallery_floor, court_half_z}, {2, 1, 4}},
        {{court_half_x, slab_bottom, -court_half_z}, {hall.max.x, gallery_floor, court_half_z}, {2, 1, 4}}};
    const Box sides[2]{
        {{hall.min.x, slab_bottom, hall.min.z}, {hall.max.x, gallery_floor, -court_half_z}, {16, 1, 2}},
        {{hall.min.x, slab_bottom, court_half_z}, {hall.max.x, gallery_floor, hall.max.z}, {16, 1, 2}}};
    for (const Box& slab : {ends[0], ends[1], sides[0], sides[1]}) {
        add_box_side(above, slab, Side::top, Facing::outward);
        add_box_side(below, slab, Side::bottom, Facing::outward);
    }
    scene.place("gallery_floor", above, materials.gallery_tiles);
    scene.place("gallery_underside", below, materials.plaster);
    scene.place("gallery_cornice",
                scene.add_mesh(make_cornice(court_half_x, court_half_z, slab_bottom, gallery_floor)),
                materials.limestone);
}

/// Calls `place(to_world)` for every bay of the arcade; +z of the bay points out of the court or into it.
template <class Place>
void for_each_bay(float height, const Place& place) {
    for (int bay = 0; bay < long_bays; ++bay) {
        const float x = (static_cast<float>(bay) + 0.5f) * arcade::bay - court_half_x;
        for (float side : {-1.0f, 1.0f}) place(turned(0, {x, height, side * arcade_z}));
    }
    for (int bay = 0; bay < short_bays; ++bay) {
        const float z = (static_cast<float>(bay) + 0.5f) * arcade::bay - court_half_z;
        for (float side : {-1.0f, 1.0f}) place(turned(90, {side * arcade_x, height, z}));
    }
}

/// Calls `place(to_world)` for every free-standing column.
template <class Place>
void for_each_column(float height, const Place& place) {
    for (float side : {-1.0f, 1.0f}) {
        for (int bay = 1; bay < long_bays; ++bay)
            place(
                translated({static_cast<float>(bay) * arcade::bay - court_half_x, height, side * arcade_z}));
        for (int bay = 1; bay < short_bays; ++bay)
            place(
                translated({side * arcade_x, height, static_cast<float>(bay) * arcade::bay - court_half_z}));
    }
}

void add_corner_piers(SceneDescription& scene, const Materials& materials, float height, float springing) {
    const int pier = scene.add_mesh(make_corner_pier(springing));
    const float x = court_half_x, z = court_half_z;
    const std::pair<float, Vec3> corners[4]{
        {0, {x, height, z}}, {90, {x, height, -z}}, {180, {-x, height, -z}}, {270, {-x, height, z}}};
    for (const auto& [degrees, corner] : corners)
        scene.place("corner_pier", pier, materials.sandstone, turned(degrees, corner));
}

void add_arcades(SceneDescription& scene, const Materials& materials) {
    const int fluted = scene.add_mesh(make_fluted_column(ground_springing));
    const int slender = scene.add_mesh(make_slender_column(upper_springing));
    const int arch = scene.add_mesh(make_arch_bay());
    const int balustrade = scene.add_mesh(make_balustrade_bay());
    for_each_column(0,
                    [&](const auto& at) { scene.place("ground_column", fluted, materials.limestone, at); });
    for_each_column(gallery_floor,
                    [&](const auto& at) { scene.place("upper_column", slender, materials.limestone, at); });
    for (float springing : {ground_springing, gallery_floor + upper_springing})
        for_each_bay(springing, [&](const auto& at) { scene.place("arch", arch, materials.sandstone, at); });
    for_each_bay(gallery_floor,
                 [&](const auto& at) { scene.place("balustrade", balustrade, materials.limestone, at); });
    add_corner_piers(scene, materials, 0, ground_springing);
    add_corner_piers(scene, materials, gallery_floor, upper_springing);
}

/// Adds curtains in every second bay of the ground floor, and banners on the balustrade at every second
/// column.
void add_cloth(SceneDescription& scene, const Materials& materials) {
    const float rod_height = ground_springing - 0.15f, half_opening = 1.35f;
    const int curtain = scene.add_mesh(make_tied_curtain(rod_height, half_opening, 1.25f));
    const int banner = scene.add_mesh(make_banner(1.1f, 2.6f));
    MeshBuilder rod_builder(1);
    add_box(rod_builder, {{-1.45f, rod_height, -0.02f}, {1.45f, rod_height + 0.04f, 0.02f}, {8, 1, 1}});
    const int rod = scene.add_mesh(rod_builder.finish());
    int color = 0;
    for (int bay : {0, 2, 4}) {
        const float x = (static_cast<float>(bay) + 0.5f) * arcade::bay - court_half_x;
        for (float side : {-1.0f, 1.0f}) {
            const Vec3 middle(x, 0, side * arcade_z);
            const int dyed = materials.cloth[color++ % 4];
            scene.place("curtain_rod", rod, materials.brass, translated(middle));
            scene.place("curtain", curtain, dyed, translated(middle - Vec3(1.4f, 0, 0)));
            scene.place("curtain", curtain, dyed, turned(180, middle + Vec3(1.4f, 0, 0)));
        }
    }
    for (int column : {1, 3, 5}) {
        const float x = static_cast<float>(column) * arcade::bay - court_half_x;
        for (float side : {-1.0f, 1.0f})
            scene.place("banner", banner, materials.cloth[color++ % 4],
                        turned(side < 0 ? 0 : 180, {x, gallery_floor + 0.2f, side * (court_half_z - 0.22f)}));
    }
}

void add_ornaments(SceneDescription& scene, const Materials& materials) {
    const float pedestal_height = 1.0f, knot_radius = 0.8f;
    scene.place("pedestal", scene.add_mesh(make_pedestal(0.75f, pedestal_height)), materials.marble);
    scene.place("knot", scene.add_mesh(make_trefoil_knot(knot_radius, 0.15f)), materials.marble,
                turned(90, {0, pedestal_height + knot_radius - 0.01f, 0}));
    const int vase = scene.add_mesh(make_vase(0.9f));
    for (float x : {-7.0f, -3.5f, 3.5f, 7.0f})
        for (float z : {-2.85f, 2.85f}) scene.place("vase", vase, materials.glaze, translated({x, 0, z}));
    for (float x : {-13.2f, 13.2f})
        for (float z : {-6.2f, 6.2f})
            scene.place("gallery_vase", vase, materials.glaze, translated({x, gallery_floor, z}));
}

/// Adds warm pendants in the aisles of both storeys and a spot on the knot; most light comes from the
/// skylight.
void add_lamps(SceneDescription& scene, const Materials& materials) {
    const float rod_length = 1.7f;
    const int pendant = scene.add_mesh(make_pendant(rod_length));
    const float aisle_z = 0.5f * (arcade_z + arcade::wall_thickness / 2 + hall.max.z);
    const Rgb warm(16.0f, 10.5f, 5.5f);
    const auto hang = [&](const Vec3& from) {
        scene.place("pendant", pendant, materials.brass, translated(from));
        scene.add_point_light(from + Vec3(0, pendant_light_height(rod_length), 0), warm);
    };
    for (float x : {-7.0f, 0.0f, 7.0f})
        for (float z : {-aisle_z, aisle_z}) hang({x, slab_bottom, z});
    for (float x : {-12.55f, 12.55f}) hang({x, ceiling, 0});
    scene.add_spot_light({3.0f, ceiling - 0.05f, 0}, {0, 1.6f, 0}, {260.0f, 240.0f, 200.0f}, 7, 11);
}

}  // namespace

SceneDescription make_atrium() {
    SceneDescription scene;
    const Materials materials = add_materials(scene);
    add_shell(scene, materials);
    add_rafters(scene, materials);
    add_gallery(scene, materials);
    add_arcades(scene, materials);
    add_cloth(scene, materials);
    add_ornaments(scene, materials);
    add_lamps(scene, materials);
    scene.add_camera("court", {-9.9f, 1.75f, 0.6f}, {2.0f, 3.5f, -0.2f}, 60);
    scene.add_camera("gallery", {-10.75f, gallery_floor + 1.7f, 1.75f}, {2.0f, 3.4f, -0.9f}, 60);
    return scene;
}

}  // namespace scenes
