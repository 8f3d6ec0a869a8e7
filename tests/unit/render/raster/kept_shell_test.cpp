// SPDX-License-Identifier: MIT
#include "render/picture/painter_settings.hpp"
#include "render/raster/lanes/sample_tile.hpp"
#include "render/raster/shell/shell_raster.hpp"
#include "support/pictures.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <memory>

namespace frostfill
{
namespace
{

using namespace testing_support;

/// Triangles behind each other, across the picture.
TriangleMesh stackOf(int count)
{
    TriangleMesh mesh;
    for (int i = 0; i < count; ++i)
    {
        const double z = 0.02 * i;
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), {{-1, -1, z}, {1, -1, z}, {0, 1, z}});
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

/// A shell before a camera, drawn plainly and as kept.
class ShellOfTiles
{
public:
    ShellOfTiles(const TriangleMesh& mesh, int samples,
                 std::size_t mostBytes = KeptShell::kMostBytes)
        : samples_(samples)
    {
        settings_.size = {160, 96};
        framing_ = frame(mesh.vertices, settings_, {0, 0, 160, 96});
        std::vector<glm::vec3> positions;
        for (const Eigen::Vector3d& vertex : mesh.vertices)
        {
            positions.emplace_back(framing_.toUnit(vertex));
        }
        shaded_ = shadeMesh(mesh, positions);
        shell_ = std::make_unique<ShellRaster>(shaded_, ShaderVariant{.fadingLines = true},
                                               shellPalette(settings_.style), strokesFor(settings_),
                                               samples);
        edges_ = edgeStrengths(shaded_, glm::vec3(framing_.eye), false);
        shell_->lookFrom(uniformsOf(framing_, settings_), false, settings_.size, edges_);
        kept_ = std::make_unique<KeptShell>(*shell_, tiles(), mostBytes);
    }

    [[nodiscard]] ShellRaster& shell() { return *shell_; }
    [[nodiscard]] KeptShell& kept() { return *kept_; }
    [[nodiscard]] std::size_t tiles() const { return TileGrid(settings_.size).count(); }

    /// Draws part of a tile over what lies before, within and behind the mesh. Returns how many
    /// samples that changes; the same has to change both ways.
    int draw(std::size_t tile, const PixelRectangle& pixels = {0, 0, kTileEdge, kTileEdge})
    {
        const auto before = somethingAround();
        const auto plain = std::make_unique<SampleTile>(*before);
        const auto asKept = std::make_unique<SampleTile>(*before);
        TilePart part = TileGrid(settings_.size).part(tile);
        part.pixels = pixels;
        const auto triangles = shell_->inDrawingOrder();
        shell_->draw(triangles, part, *plain);
        kept_->draw(tile, triangles, part, *asKept, RestingTile({255, 255, 255, 255}, samples_));
        EXPECT_EQ(asKept->colour, plain->colour) << "tile " << tile;
        int changed = 0;
        for (std::size_t at = 0; at < kTilePixels; ++at)
        {
            changed += plain->colour[0][at] != before->colour[0][at] ? 1 : 0;
        }
        return changed;
    }

    int drawAll()
    {
        int changed = 0;
        for (std::size_t tile = 0; tile < tiles(); ++tile)
        {
            changed += draw(tile);
        }
        return changed;
    }

private:
    std::unique_ptr<SampleTile> somethingAround()
    {
        auto tile = std::make_unique<SampleTile>();
        const double distance = glm::length(framing_.eye);
        for (std::size_t plane = 0; plane < kMaxTileSamples; ++plane)
        {
            for (std::size_t at = 0; at < kTilePixels; ++at)
            {
                tile->inverseDepth[plane][at] =
                    static_cast<float>(1 / (distance + 2 * numbers_.next() - 1));
                tile->colour[plane][at] =
                    0xff000000U | static_cast<std::uint32_t>(numbers_.next() * 0xffffff);
            }
        }
        return tile;
    }

    int samples_;
    RenderSettings settings_;
    Framing framing_;
    ShadedMesh shaded_;
    std::vector<std::array<std::uint8_t, 3>> edges_;
    std::unique_ptr<ShellRaster> shell_;
    std::unique_ptr<KeptShell> kept_;
    Numbers numbers_;
};

TEST(KeptShell, BlendsWhatDrawingBlendsBeforeAndBehindWhatLiesThere)
{
    for (const int samples : {1, kMaxTileSamples})
    {
        for (const bool avx2 : {false, drawsWithAvx2})
        {
            ShellOfTiles drawn(torusMesh(1, 0.4, 96, 48), samples);
            const bool before = std::exchange(drawsWithAvx2, avx2);
            for (int time = 0; time < 4; ++time)
            {
                EXPECT_GT(drawn.drawAll(), 500);
            }
            for (std::size_t tile = 0; tile < drawn.tiles(); ++tile)
            {
                EXPECT_TRUE(drawn.kept().keeps(tile));
                drawn.draw(tile, {8, 3, 24, 17});
            }
            drawsWithAvx2 = before;
        }
    }
}

TEST(KeptShell, KeepsATileOnceATilesWorthOfItHasBeenDrawn)
{
    ShellOfTiles drawn(torusMesh(1, 0.4, 48, 12), kMaxTileSamples);
    const PixelRectangle half = {0, 0, kTileEdge, kTileEdge / 2};
    drawn.draw(0, half);
    drawn.draw(0, half);
    EXPECT_FALSE(drawn.kept().keeps(0));
    drawn.draw(0, half);
    EXPECT_TRUE(drawn.kept().keeps(0));
    EXPECT_FALSE(drawn.kept().keeps(1)) << "it was not drawn";
}

TEST(KeptShell, KeepsNothingOfACameraThatMovesOrOfATileWhoseShellHasChanged)
{
    const TriangleMesh mesh = torusMesh(1, 0.4, 48, 12);
    ShellOfTiles drawn(mesh, kMaxTileSamples);
    drawn.drawAll();
    drawn.drawAll();
    const std::vector<PolygonState> discarded(mesh.triangles.size(), PolygonState::discarded);
    drawn.shell().setStates(discarded);
    drawn.kept().forget(1);
    EXPECT_FALSE(drawn.kept().keeps(1));
    EXPECT_TRUE(drawn.kept().keeps(0));
    drawn.kept().forget();
    for (int time = 0; time < 3; ++time)
    {
        EXPECT_FALSE(time == 0 && drawn.kept().keeps(0));
        drawn.drawAll();
    }
    EXPECT_TRUE(drawn.kept().keeps(0));
}

TEST(KeptShell, DrawsWhatItMayNotKeep)
{
    ShellOfTiles drawn(torusMesh(1, 0.4, 48, 12), kMaxTileSamples, 0);
    for (int time = 0; time < 3; ++time)
    {
        EXPECT_GT(drawn.drawAll(), 500);
    }
    EXPECT_FALSE(drawn.kept().keeps(0));
}

TEST(KeptShell, MayKeepMoreOnceItHasForgotten)
{
    ShellOfTiles drawn(torusMesh(1, 0.4, 48, 12), kMaxTileSamples, 1);
    drawn.draw(6);
    drawn.draw(6);
    drawn.draw(8);
    drawn.draw(8);
    EXPECT_TRUE(drawn.kept().keeps(6));
    EXPECT_FALSE(drawn.kept().keeps(8)) << "the first has taken all";
    drawn.kept().forget(6);
    drawn.draw(8);
    EXPECT_TRUE(drawn.kept().keeps(8));
}

TEST(KeptShell, KeepsAndDrawsTilesOfAnyDepth)
{
    for (const int count : {30, 40})
    {
        ShellOfTiles drawn(stackOf(count), kMaxTileSamples);
        EXPECT_GT(drawn.drawAll(), 500);
        drawn.drawAll();
        drawn.drawAll();
        int kept = 0;
        for (std::size_t tile = 0; tile < drawn.tiles(); ++tile)
        {
            kept += drawn.kept().keeps(tile) ? 1 : 0;
        }
        EXPECT_EQ(kept, static_cast<int>(drawn.tiles()));
    }
}

} // namespace
} // namespace frostfill
