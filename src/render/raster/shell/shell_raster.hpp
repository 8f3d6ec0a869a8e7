// SPDX-License-Identifier: MIT
// Room: the shell in tiles: its triangles, row by row, its lines, and the colours that are kept
// from picture to picture.
#pragma once

#include "render/picture/mesh_shading.hpp"
#include "render/picture/painter_settings.hpp"
#include "render/raster/lanes/sample_tile.hpp"
#include "render/raster/spheres/resting_tile.hpp"
#include "render/raster/spheres/sphere_raster.hpp"

#include <glm/vec3.hpp>

#include <array>
#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// The planes of a cutaway before the camera.
struct ShellCut
{
    /// Of the distance from the cut, at distance 1: triangles that are seen edge-on end sharply at
    /// the cut. They would leave specks beyond it. [1 / pixel]
    float steepest = 0;
    float steepestBefore = 0;                     ///< the same before the cut, where its line is
    std::array<std::array<float, 4>, 2> planes{}; ///< as CutPlanes, in eye space
};

/// What drawing a triangle needs beside it.
struct ShellRows
{
    PixelGrid grid;
    float lineWidth = 1;
    bool print = false; ///< lines lie in the film and not over it
    ShellCut cut{};
};

/// The colours that a triangle blends over kLanes samples of one plane of a tile.
struct ShellPiece
{
    std::array<float, kLanes> inverseDepth;
    std::array<std::uint32_t, kLanes> colour; ///< premultiplied, 0 for none
    std::uint16_t plane = 0;
    std::uint16_t at = 0; ///< the first sample in the plane

    [[nodiscard]] int row() const { return at / kTileEdge; }
};

/// Draws the shell as mesh.vert and mesh.frag do, a sample at a time. A length in the picture that
/// is the same over most of a triangle is worked out once for it.
class ShellRaster
{
public:
    /// `mesh` must stay.
    ShellRaster(const ShadedMesh& mesh, const ShaderVariant& variant, const Palette& palette,
                const MeshStrokes& strokes, int samples);

    /// `edgeStrengths` must stay.
    void lookFrom(const SphereUniforms& uniforms, bool orthographic, const PictureSize& size,
                  std::span<const std::array<std::uint8_t, 3>> edgeStrengths);
    /// [#T] All are active before.
    void setStates(std::span<const PolygonState> states)
    {
        states_.assign(states.begin(), states.end());
    }

    /// Around the samples that a triangle may cover; empty if it covers none.
    [[nodiscard]] PixelRectangle bounds(std::uint32_t triangle) const
    {
        return places_[triangle].pixels();
    }
    /// Those that may cover a sample, whatever their state: first those that turn their backs to
    /// the viewer, then those that face the viewer.
    [[nodiscard]] std::vector<std::uint32_t> inDrawingOrder() const;
    /// Blends one after another. What spheres at rest hide may be left out. Several threads may
    /// draw, each into a tile of its own.
    void draw(std::span<const std::uint32_t> triangles, const TilePart& part, SampleTile& tile,
              const RestingTile* resting = nullptr) const;
    /// Notes what draw() would blend over a tile in which nothing lies.
    void record(std::span<const std::uint32_t> triangles, const TilePart& part,
                std::vector<ShellPiece>& pieces) const;
    /// Blends what record() has noted of a tile, sorted by rows.
    void blend(std::span<const ShellPiece> pieces, const PixelRectangle& pixels,
               SampleTile& tile) const;

    /// How one triangle looks to a camera.
    struct Setup
    {
        /// Distance from each edge: across * x + upwards * y + from, inside positive [pixel].
        std::array<float, 3> across, upwards, from;
        std::array<float, 3> least; ///< the distance has to be more; of two triangles at an edge
                                    ///< one has what lies exactly on it
        std::array<float, 3> share; ///< barycentric coordinate = share * distance / sum of all
        std::array<float, 3> near;  ///< inverse depth = sum of near * distance
        std::array<glm::vec3, 3> normals; ///< towards the viewer [eye space]
        std::array<float, 3> light;       ///< on the corners
        std::array<float, 3> facing;      ///< cosine of the angle to the viewer at the corners
        std::array<float, 3> strength;    ///< of the lines along the edges
        float contour = 0;                ///< strength of the outline of the smooth surface
        float pixelsOfFacing = 0;         ///< the length over which facing changes by 1 [pixel]
        float crease = 0;                 ///< strength of others' creases
        float pixelsOfCrease = 0;
        std::array<float, 3> creaseDistance{};
        glm::vec3 base; ///< colour [0..255]
        float density = 0, rimDensity = 0;
        glm::vec3 ink;      ///< [0..255]
        bool seen = false;  ///< is not clear
        bool lines = false; ///< has any, of which kind ever
        bool edges = false; ///< has lines along edges
        bool flat = false;  ///< light and angle are those of the corners, mixed
        bool cut = false;   ///< the cutaway may take a part of it
    };

private:
    /// What most triangles are passed over for, apart from what it takes to draw one.
    struct Place
    {
        std::array<std::int16_t, 4> edges{}; ///< as a PixelRectangle; empty if it shows no sample
        float nearest = 0;                   ///< no point of it is nearer; see kNothing
        bool front = false;                  ///< faces the viewer
        bool cut = false;                    ///< the cutaway may take a part of it

        [[nodiscard]] PixelRectangle pixels() const
        {
            return {edges[0], edges[1], edges[2], edges[3]};
        }
        [[nodiscard]] bool empty() const { return edges[0] == edges[2]; }
    };

    /// A vertex before the camera.
    struct Vertex
    {
        /// (x, y, 1) in the picture times what they are divided by: the sides of a triangle are
        /// then planes through the origin, also where the eye's plane cuts it [Olano & Greer 1997].
        glm::dvec3 corner;
        double height;              ///< inverse depth times corner.z
        glm::dvec2 pixel;           ///< in the picture
        float nearest;              ///< inverse depth; largest where it is not ahead of the eye
        float facing;               ///< cosine of the angle between the normal and the viewer
        glm::vec3 normal;           ///< [eye space]
        std::array<float, 2> light; ///< on the side that turns its back, and on the other
    };
    using Corners = std::array<const Vertex*, 3>;

    /// Of a state, and one side.
    struct Paint
    {
        glm::vec3 base, ink; ///< [0..255]
        shading::ShellPaint own;
    };

    void placeVertex(std::size_t index);
    [[nodiscard]] Corners cornersOf(std::uint32_t triangle) const;
    [[nodiscard]] Place placeOf(std::uint32_t triangle) const;
    [[nodiscard]] Setup setUp(std::uint32_t triangle) const;
    /// Finds what the cutaway may take of a triangle.
    void cut(const std::array<glm::vec3, 3>& corners, Place& place) const;
    static void setSides(const Corners& corners, Setup& setup);
    void setStrokes(std::uint32_t triangle, const shading::ShellPaint& paint,
                    const Corners& corners, Setup& setup) const;

    const ShadedMesh& mesh_;
    ShaderVariant variant_;
    MeshStrokes strokes_;
    int samples_;
    std::array<std::array<Paint, 2>, 2> paints_; ///< [PolygonState][front]
    glm::mat4 view_{1};
    ShellRows rows_{};
    PictureSize size_;
    std::vector<Vertex> vertices_;                       ///< of the mesh, for this camera
    std::span<const std::array<std::uint8_t, 3>> edges_; ///< [#T]
    std::vector<PolygonState> states_;                   ///< [#T]
    std::vector<Place> places_;                          ///< [#T] for this camera
};

/// Draws the shell tile by tile. Once it has drawn a tile's worth of pixels and nothing of the
/// shell has changed since, it keeps the colours of that tile and only blends them.
class KeptShell
{
public:
    /// Keeps up to so many bytes.
    static constexpr std::size_t kMostBytes = std::size_t{96} << 20;

    /// `shell` must stay.
    KeptShell(const ShellRaster& shell, std::size_t tiles, std::size_t mostBytes = kMostBytes);

    /// The camera has moved.
    void forget();
    /// The shell has changed in this tile.
    void forget(std::size_t tile);

    /// As ShellRaster::draw does. Several threads may draw, each a tile of its own.
    void draw(std::size_t tile, std::span<const std::uint32_t> triangles, const TilePart& part,
              SampleTile& to, const RestingTile& resting);

    [[nodiscard]] bool keeps(std::size_t tile) const { return tiles_[tile].isKept; }

private:
    struct Tile
    {
        std::vector<ShellPiece> pieces; ///< row by row, in the order in which they are blended
        std::int64_t drawn = 0;         ///< pixels since it changed
        bool isKept = false;            ///< and there may be none
    };

    void keep(Tile& tile, std::span<const std::uint32_t> triangles, const TilePart& part);

    const ShellRaster& shell_;
    std::size_t mostBytes_;
    std::vector<Tile> tiles_;
    std::atomic<std::size_t> bytes_ = 0;
};

} // namespace frostfill
