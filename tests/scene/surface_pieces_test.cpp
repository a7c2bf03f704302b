// Tests which triangles form one surface, and which surfaces meet.
#include "common/scene/surface_pieces.h"

#include <gtest/gtest.h>

#include "tests/support/scene_builder.h"

namespace {

using common::SurfacePieces;
using common::Vec3;
using namespace tests;

/// Makes a tile from (x, 0) to (x + 1, 1) in the plane at `height`, facing up.
Mesh tile(float x, float height = 0) {
    return quad({x, height, 1}, {1, 0, 0}, {0, 0, -1});
}

/// Makes the tile at the same position, facing down.
Mesh tile_from_below(float x) {
    return quad({x, 0, 0}, {1, 0, 0}, {0, 0, 1});
}

Scene scene_of(const std::vector<Mesh>& meshes) {
    Scene scene;
    for (const Mesh& mesh : meshes) add(scene, mesh, diffuse({0.5f, 0.5f, 0.5f}));
    return scene;
}

/// Makes a strip that ends at x = 1 with this slope in degrees, and is flat before.
Mesh slope(double degrees) {
    const auto turned = static_cast<float>(degrees * pi / 180);
    return quad({1, 0, 1}, {std::cos(turned), std::sin(turned), 0}, {0, 0, -1});
}

TEST(SurfacePieces, AreWhatHangsTogetherSmoothly) {
    EXPECT_EQ(SurfacePieces(scene_of({tile(0), tile(1)})).count(), 1u) << "across instances";
    EXPECT_EQ(SurfacePieces(scene_of({tile(0), tile(2)})).count(), 2u) << "apart";
    EXPECT_EQ(SurfacePieces(scene_of({tile(0), slope(24)})).count(), 1u);
    EXPECT_EQ(SurfacePieces(scene_of({tile(0), slope(-24)})).count(), 1u);
    EXPECT_EQ(SurfacePieces(scene_of({tile(0), slope(27)})).count(), 2u);
    EXPECT_EQ(SurfacePieces(scene_of({sphere({0, 0, 0}, 1, 3)})).count(), 1u);
}

TEST(SurfacePieces, MeetAtEdges) {
    const SurfacePieces edge(scene_of({tile(0), slope(60)}));
    ASSERT_EQ(edge.count(), 2u);
    EXPECT_TRUE(edge.meet(0, 1) && edge.meet(1, 0) && edge.meet(0, 0));
    EXPECT_FALSE(SurfacePieces(scene_of({tile(0), tile(2)})).meet(0, 1));
    EXPECT_FALSE(SurfacePieces(scene_of({tile(0), tile(0, 0.001f)})).meet(0, 1)) << "a layer below";
}

TEST(SurfacePieces, InABoxMeetAllWallsButTheOneAcross) {
    const Scene box = closed_box(diffuse({0.5f, 0.5f, 0.5f}));
    const SurfacePieces pieces(box);
    ASSERT_EQ(pieces.count(), 6u);
    for (std::uint32_t wall = 0; wall < 6; ++wall)
        for (std::uint32_t other = 0; other < 6; ++other)
            EXPECT_EQ(pieces.meet(wall, other), wall == other || wall / 2 != other / 2)
                << wall << " " << other;
}

TEST(SurfacePieces, ThatLieOverEachOtherDoNotMeet) {
    Mesh divided_otherwise = tile(0);
    divided_otherwise.triangle = {{0, 1, 3}, {1, 2, 3}};
    const SurfacePieces copies(scene_of({tile(0), divided_otherwise}));
    ASSERT_EQ(copies.count(), 2u);
    EXPECT_FALSE(copies.meet(0, 1));
    const SurfacePieces back_to_back(scene_of({tile(0), tile_from_below(0)}));
    ASSERT_EQ(back_to_back.count(), 2u);
    EXPECT_FALSE(back_to_back.meet(0, 1));
}

TEST(SurfacePieces, GoOnWhereTheNextTriangleGoesRoundTheOtherWay) {
    EXPECT_EQ(SurfacePieces(scene_of({tile(0), tile_from_below(1)})).count(), 1u);
}

TEST(SurfacePieces, TellTheSidesOfARecessFromItsBottom) {
    // A floor, a step down of 0.001 at x = 1, and the floor of the recess.
    const Mesh riser = quad({1, -0.001f, 1}, {0, 0.001f, 0}, {0, 0, -1});
    const SurfacePieces pieces(scene_of({tile(0), riser, tile(1, -0.001f)}));
    ASSERT_EQ(pieces.count(), 3u);
    EXPECT_TRUE(pieces.meet(0, 1));
    EXPECT_TRUE(pieces.meet(1, 2));
    EXPECT_FALSE(pieces.meet(0, 2));
}

TEST(SurfacePieces, OfManyTrianglesAtOneEdgeAreFoundInTime) {
    // A book of 100,000 leaves with one spine: comparing each with each would take minutes.
    Mesh book;
    book.position = {{0, 0, 0}, {0, 1, 0}};
    for (std::uint32_t leaf = 0; leaf < 100'000; ++leaf) {
        const float turned = static_cast<float>(leaf) * 6e-5f;
        book.position.emplace_back(std::cos(turned), 0.5f, std::sin(turned));
        book.triangle.push_back({0, 1, leaf + 2});
    }
    const SurfacePieces pieces(scene_of({book}));
    EXPECT_EQ(pieces.count(), 100'000u) << "leaves lie over each other";
}

}  // namespace
