// Builds meshes from patches, each a grid of cells, with texture and lightmap coordinates.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "common/core/vector.h"

namespace scenes {

using common::Rgb;
using common::Vec2;
using common::Vec3;

/// One glTF primitive: indexed triangles, counter-clockwise seen from the front.
struct Mesh {
    std::vector<Vec3> position;           ///< metres
    std::vector<Vec3> normal;             ///< unit, out of the front
    std::vector<Vec2> texcoord;           ///< TEXCOORD_0: in texture repeats, u along the patch, v down it
    std::vector<Vec2> lightmap_texcoord;  ///< TEXCOORD_1: in the unit square, no two triangles overlap
    std::vector<std::uint32_t> index;
};

/// Returns the position at (s, t), both from 0 to 1; the front is where ds x dt points. It must also work
/// slightly outside that range, for the normals at its border.
using Surface = std::function<Vec3(float s, float t)>;

/// Returns whether cell (i, j) of a grid exists.
using CellFilter = std::function<bool(int i, int j)>;

struct Cells {
    int along_s = 1;
    int along_t = 1;
};

class MeshBuilder {
  public:
    /// `texture_size`: metres per repeat of the textures.
    explicit MeshBuilder(float texture_size = 1.0f) : texture_size_(texture_size) {}

    /// Adds a plane quad with corners counter-clockwise from the front; s runs from the first corner to the
    /// second. Corners and edges shared by two quads with the same cells get bitwise equal coordinates, so
    /// that closed rooms have no cracks.
    void add_quad(const std::array<Vec3, 4>& corner, Cells cells = {}, const CellFilter& present = {});

    /// Adds a curved patch with smooth normals. If it closes on itself along s, it gets a whole number of
    /// texture repeats.
    void add_surface(Cells cells, const Surface& surface);

    /// Adds a copy of everything so far, rotated by half a turn about the y axis.
    void repeat_turned_half_round();

    /// Cuts long patches into charts, packs these, and returns the triangles without those of zero area.
    [[nodiscard]] Mesh finish() const;

  private:
    struct Patch;
    struct Chart;

    [[nodiscard]] std::vector<Chart> cut_into_charts(float longest_side) const;
    void append_chart(const Chart& chart, const std::function<Vec2(Vec2)>& to_lightmap, Mesh& mesh) const;

    float texture_size_;
    std::vector<Patch> patches_;
};

/// A grid of vertices, row after row along s, with ascending t.
struct MeshBuilder::Patch {
    Cells cells;
    bool is_plane = false;
    std::vector<Vec3> position{};
    std::vector<Vec3> normal{};
    std::vector<Vec2> texcoord{};
    std::vector<bool> present{};  ///< one per cell

    [[nodiscard]] std::size_t vertex(int i, int j) const {
        return static_cast<std::size_t>(j * (cells.along_s + 1) + i);
    }
    [[nodiscard]] std::size_t cell(int i, int j) const {
        return static_cast<std::size_t>(j * cells.along_s + i);
    }
};

/// A rectangular range of a patch's cells, flattened.
struct MeshBuilder::Chart {
    std::size_t patch;
    int first_i, first_j;
    Cells cells;
    std::vector<Vec2> flat{};  ///< metres; one per vertex of the range, smallest coordinates 0
    Vec2 size{0, 0};           ///< metres
};

}  // namespace scenes
