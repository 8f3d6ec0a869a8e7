// SPDX-License-Identifier: MIT
#include "render/picture/painter_settings.hpp"
#include "render/raster/lanes/sample_tile.hpp"
#include "render/raster/shell/shell_raster.hpp"
#include "support/pictures.hpp"

#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace frostfill
{
namespace
{

constexpr PictureSize kSize = {160, 96};

/// A torus of which most triangles are no larger than some pixels.
class ShellSamples : public testing::TestWithParam<int>
{
protected:
    ShellSamples()
    {
        settings_.size = kSize;
        framing_ = frame(mesh_.vertices, settings_, {0, 0, kSize.width, kSize.height});
        uniforms_ = uniformsOf(framing_, settings_);
        for (const Eigen::Vector3d& vertex : mesh_.vertices)
        {
            positions_.emplace_back(framing_.toUnit(vertex));
        }
        shaded_ = shadeMesh(mesh_, positions_);
        edges_ = edgeStrengths(shaded_, glm::vec3(framing_.eye), false);
        shell_.emplace(shaded_, ShaderVariant{.fadingLines = true}, shellPalette(settings_.style),
                       strokesFor(settings_), GetParam());
        shell_->lookFrom(uniforms_, false, settings_.size, edges_);
    }

    [[nodiscard]] std::array<glm::dvec2, 3> corners(std::uint32_t triangle) const
    {
        std::array<glm::dvec2, 3> result;
        for (std::size_t i = 0; i < 3; ++i)
        {
            const glm::vec4 clip = uniforms_.projection * uniforms_.view *
                                   glm::vec4(positions_[mesh_.triangles[triangle][i]], 1);
            result[i] = {(double{clip.x} / clip.w + 1) / 2 * kSize.width,
                         (double{clip.y} / clip.w + 1) / 2 * kSize.height};
        }
        return result;
    }

    [[nodiscard]] static std::unique_ptr<SampleTile> clearTile()
    {
        auto tile = std::make_unique<SampleTile>();
        for (std::size_t plane = 0; plane < kMaxTileSamples; ++plane)
        {
            tile->inverseDepth[plane].fill(kNothing);
            tile->colour[plane].fill(0);
        }
        return tile;
    }

    /// Calls visit(x, y, plane, colour) for the samples that some triangles draw to, in the
    /// picture.
    template <class Visit>
    void drawEach(std::span<const std::uint32_t> triangles, const PixelRectangle& bounds,
                  Visit visit) const
    {
        grid_.each(bounds,
                   [&](std::size_t index)
                   {
                       const auto tile = clearTile();
                       const TilePart part = grid_.part(index);
                       shell_->draw(triangles, part, *tile);
                       for (std::size_t plane = 0; plane < kMaxTileSamples; ++plane)
                       {
                           for (int at = 0; at < kTilePixels; ++at)
                           {
                               const auto colour =
                                   tile->colour[plane][static_cast<std::size_t>(at)];
                               if (colour != 0)
                               {
                                   visit(part.left + at % kTileEdge, part.bottom + at / kTileEdge,
                                         plane, colour);
                               }
                           }
                       }
                   });
    }

    TriangleMesh mesh_ = testing_support::torusMesh(1, 0.4, 151, 60);
    RenderSettings settings_;
    Framing framing_;
    SphereUniforms uniforms_;
    std::vector<glm::vec3> positions_;
    ShadedMesh shaded_;
    std::vector<std::array<std::uint8_t, 3>> edges_;
    std::optional<ShellRaster> shell_;
    TileGrid grid_{kSize};
};

double twiceArea(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// How far within a triangle a point lies. [pixel]
double depthWithin(const std::array<glm::dvec2, 3>& at, const glm::dvec2& point)
{
    const double sign = twiceArea(at[0], at[1], at[2]) > 0 ? 1 : -1;
    double least = 1e9;
    for (std::size_t i = 0; i < 3; ++i)
    {
        const glm::dvec2 side = at[(i + 1) % 3] - at[i];
        least = std::min(least, sign * twiceArea(at[i], at[(i + 1) % 3], point) /
                                    std::hypot(side.x, side.y));
    }
    return least;
}

TEST_P(ShellSamples, AreThoseThatLieInATriangle)
{
    constexpr double kRounding = 1e-3; // of single precision, in a picture of this size [pixel]
    const auto planes = static_cast<std::size_t>(GetParam());
    int covered = 0;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); t += 3)
    {
        const auto at = corners(t);
        const PixelRectangle bounds = shell_->bounds(t);
        const auto placeOf = [&](int x, int y, std::size_t plane)
        {
            const SampleOffset& offset = planes > 1 ? kFourSamples[plane] : SampleOffset{};
            return glm::dvec2(x + 0.5 + offset.x, y + 0.5 + offset.y);
        };
        int drawn = 0;
        drawEach(std::span(&t, 1), bounds,
                 [&](int x, int y, std::size_t plane, std::uint32_t)
                 {
                     ASSERT_LT(plane, planes);
                     ASSERT_GT(depthWithin(at, placeOf(x, y, plane)), -kRounding) << t;
                     ++drawn;
                 });
        int surely = 0;
        const auto [left, right] = std::minmax({at[0].x, at[1].x, at[2].x});
        const auto [bottom, top] = std::minmax({at[0].y, at[1].y, at[2].y});
        for (int y = std::max(0, static_cast<int>(bottom) - 1);
             y < std::min(kSize.height, static_cast<int>(top) + 2); ++y)
        {
            for (int x = std::max(0, static_cast<int>(left) - 1);
                 x < std::min(kSize.width, static_cast<int>(right) + 2); ++x)
            {
                for (std::size_t plane = 0; plane < planes; ++plane)
                {
                    surely += depthWithin(at, placeOf(x, y, plane)) > kRounding ? 1 : 0;
                }
            }
        }
        ASSERT_GE(drawn, surely) << t;
        covered += drawn;
    }
    EXPECT_GT(covered, 1000 * GetParam());
}

TEST_P(ShellSamples, LeaveNoGapAndShareNoSample)
{
    for (const bool front : {false, true})
    {
        std::vector<int> layers(static_cast<std::size_t>(kSize.width * kSize.height) *
                                kMaxTileSamples);
        std::vector<std::uint32_t> order;
        for (const std::uint32_t t : shell_->inDrawingOrder())
        {
            const auto at = corners(t);
            if ((twiceArea(at[0], at[1], at[2]) > 0) == front)
            {
                order.push_back(t);
                drawEach(
                    std::span(&t, 1), shell_->bounds(t),
                    [&](int x, int y, std::size_t plane, std::uint32_t) {
                        ++layers[static_cast<std::size_t>(y * kSize.width + x) * kMaxTileSamples +
                                 plane];
                    });
            }
        }
        // A line of sight goes into a torus twice at most, so often as it comes out; where it goes
        // in once, what is around has one layer, too, but at the outlines of its two parts.
        int alone = 0;
        for (int y = 1; y + 1 < kSize.height; ++y)
        {
            for (int x = 1; x + 1 < kSize.width; ++x)
            {
                const auto at = [&](int dx, int dy) {
                    return layers[static_cast<std::size_t>((y + dy) * kSize.width + x + dx) *
                                  kMaxTileSamples];
                };
                ASSERT_LE(at(0, 0), 2) << x << " " << y;
                const bool inside = at(-1, 0) == at(1, 0) && at(0, -1) == at(0, 1) &&
                                    at(-1, 0) == at(0, 1) && at(-1, -1) == at(1, 1) &&
                                    at(-1, -1) == at(-1, 0) && at(1, -1) == at(-1, 1) &&
                                    at(1, -1) == at(-1, 0);
                if (inside && at(-1, 0) == 1)
                {
                    ASSERT_EQ(at(0, 0), 1) << x << " " << y;
                    ++alone;
                }
            }
        }
        EXPECT_GT(alone, 500);
    }
}

TEST_P(ShellSamples, LookTheSameHoweverThePictureIsDivided)
{
    const std::vector<std::uint32_t> order = shell_->inDrawingOrder();
    for (std::size_t tile = 0; tile < grid_.count(); ++tile)
    {
        const auto whole = clearTile();
        shell_->draw(order, grid_.part(tile), *whole);
        const auto inParts = clearTile();
        for (int bottom = 0; bottom < kTileEdge; bottom += 3)
        {
            for (int left = 0; left < kTileEdge; left += kLanes)
            {
                TilePart part = grid_.part(tile);
                part.pixels = {left, bottom, left + kLanes, std::min(bottom + 3, kTileEdge)};
                shell_->draw(order, part, *inParts);
            }
        }
        EXPECT_EQ(inParts->colour, whole->colour) << tile;
    }
}

TEST_P(ShellSamples, ShowTheStatesOfNowAndNotThoseBefore)
{
    const std::size_t count = mesh_.triangles.size();
    std::vector<PolygonState> states(count, PolygonState::discarded);
    shell_->setStates(states);
    testing_support::Numbers numbers;
    for (PolygonState& state : states)
    {
        state = numbers.next() < 0.5 ? PolygonState::active : PolygonState::discarded;
    }
    shell_->setStates(states);
    ShellRaster anew(shaded_, {.fadingLines = true}, shellPalette(settings_.style),
                     strokesFor(settings_), GetParam());
    anew.setStates(states);
    anew.lookFrom(uniforms_, false, settings_.size, edges_);
    const std::vector<std::uint32_t> order = shell_->inDrawingOrder();
    EXPECT_EQ(anew.inDrawingOrder(), order);
    for (std::size_t tile = 0; tile < grid_.count(); ++tile)
    {
        const auto own = clearTile();
        const auto fresh = clearTile();
        shell_->draw(order, grid_.part(tile), *own);
        anew.draw(order, grid_.part(tile), *fresh);
        EXPECT_EQ(own->colour, fresh->colour) << tile;
    }
}

INSTANTIATE_TEST_SUITE_P(Samples, ShellSamples, testing::Values(1, kMaxTileSamples));

TEST(ShadedVertices, AreSplitOnlyWhereNormalsDiffer)
{
    const TriangleMesh box = testing_support::boxMesh({1, 1, 1});
    std::vector<glm::vec3> positions;
    for (const Eigen::Vector3d& vertex : box.vertices)
    {
        positions.emplace_back(vertex.x(), vertex.y(), vertex.z());
    }
    const ShadedMesh shaded = shadeMesh(box, positions);
    EXPECT_EQ(shaded.positions.size(), 24U) << "three at each corner";
    for (std::size_t t = 0; t < box.triangles.size(); ++t)
    {
        for (std::size_t corner = 0; corner < 3; ++corner)
        {
            const std::uint32_t vertex = shaded.triangles[t][corner];
            EXPECT_EQ(shaded.positions[vertex], positions[box.triangles[t][corner]]);
            EXPECT_GT(glm::dot(shaded.normals[vertex], shaded.faceNormals[t]), 0.99999F);
        }
    }
}

TEST(EdgeStrengths, HaveTheOutlineThatEachEyeSees)
{
    const TriangleMesh mesh = testing_support::torusMesh(1, 0.4, 30, 12);
    std::vector<glm::vec3> positions;
    for (const Eigen::Vector3d& vertex : mesh.vertices)
    {
        positions.emplace_back(vertex.x(), vertex.y(), vertex.z());
    }
    const ShadedMesh shaded = shadeMesh(mesh, positions);
    for (const glm::vec3 eye : {glm::vec3(0, 0, 5), glm::vec3(3, 1, 2), glm::vec3(-4, 0, 0.5F)})
    {
        const auto now = edgeStrengths(shaded, eye, false);
        std::size_t outlines = 0;
        for (const ShadedMesh::Edge& edge : shaded.edges)
        {
            const auto faces = [&](std::uint32_t t)
            { return glm::dot(shaded.faceNormals[t], eye - positions[mesh.triangles[t][0]]) > 0; };
            const bool outline = faces(edge.triangles[0]) != faces(edge.triangles[1]);
            outlines += outline ? 1 : 0;
            for (std::size_t side = 0; side < 2; ++side)
            {
                const int is = now[edge.triangles[side]][edge.corners[side]];
                EXPECT_EQ(is == line_strength::kOutline, outline);
            }
        }
        EXPECT_GT(outlines, 20U);
    }
}

} // namespace
} // namespace frostfill
