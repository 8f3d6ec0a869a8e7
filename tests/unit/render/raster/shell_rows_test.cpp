// SPDX-License-Identifier: MIT
#include "render/raster/shell_rows.hpp"

#include "base/random.hpp"
#include "render/raster/has_avx2.hpp"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace frostfill
{
namespace
{

struct PlainTriangle
{
    ShellRaster::Setup setup;
    PixelRectangle pixels;
};

/// Before everything else, in the first pixels of a picture; counter-clockwise.
PlainTriangle plainTriangle(const std::array<glm::dvec2, 3>& corners)
{
    ShellRaster::Setup setup;
    glm::dvec2 low = corners[0];
    glm::dvec2 high = corners[0];
    for (std::size_t i = 0; i < 3; ++i)
    {
        const glm::dvec2 from = corners[(i + 1) % 3];
        const glm::dvec2 side = glm::normalize(corners[(i + 2) % 3] - from);
        setup.across[i] = static_cast<float>(-side.y);
        setup.upwards[i] = static_cast<float>(side.x);
        setup.from[i] = static_cast<float>(side.y * from.x - side.x * from.y);
        setup.least[i] = 0;
        setup.share[i] = 1;
        setup.near[i] = 0;
        setup.light[i] = 1;
        setup.facing[i] = 1;
        setup.normals[i] = {0, 0, 1};
        low = glm::min(low, corners[i]);
        high = glm::max(high, corners[i]);
    }
    const PixelRectangle pixels = {static_cast<int>(low.x), static_cast<int>(low.y),
                                   static_cast<int>(std::ceil(high.x)),
                                   static_cast<int>(std::ceil(high.y))};
    setup.flat = true;
    setup.base = glm::vec3(255);
    setup.density = 0.5F;
    return {setup, pixels};
}

bool drawsAnything(int samples, const PlainTriangle& triangle, SampleTile& tile)
{
    for (auto& plane : tile.inverseDepth)
    {
        plane.fill(kNothing);
    }
    for (auto& plane : tile.colour)
    {
        plane.fill(0);
    }
    const TilePart part = {0, 0, {0, 0, kTileEdge, kTileEdge}};
    // With room around it: what the bounds leave out must draw nothing either.
    const PixelRectangle rows = part.within({triangle.pixels.left - 2, triangle.pixels.bottom - 2,
                                             triangle.pixels.right + 2, triangle.pixels.top + 2});
    drawShellRows(lanes::hasAvx2(), samples, triangle.setup, {0, 0, 0, 0, 1}, rows, part, tile);
    return std::any_of(tile.colour.begin(), tile.colour.end(),
                       [](const auto& plane)
                       {
                           return std::any_of(plane.begin(), plane.end(),
                                              [](std::uint32_t colour) { return colour != 0; });
                       });
}

TEST(ShellRows, DrawNothingOfATriangleThatCoversNoSampleAndSomethingOfEveryOther)
{
    const auto tile = std::make_unique<SampleTile>();
    std::array<int, 2> drawn = {};
    constexpr int kTriangles = 4000;
    for (int k = 0; k < kTriangles; ++k)
    {
        const auto draw = [&](std::uint64_t n)
        { return uniformRandom(5, static_cast<std::uint64_t>(k), n); };
        const double size = 0.05 + 1.9 * draw(0);
        const glm::dvec2 middle(4 + 8 * draw(1), 4 + 8 * draw(2));
        std::array<glm::dvec2, 3> corners;
        for (std::size_t i = 0; i < 3; ++i)
        {
            corners[i] = middle + size * (glm::dvec2(draw(3 + 2 * i), draw(4 + 2 * i)) - 0.5);
        }
        const glm::dvec2 u = corners[1] - corners[0];
        const glm::dvec2 v = corners[2] - corners[0];
        if (u.x * v.y - u.y * v.x < 0)
        {
            std::swap(corners[1], corners[2]);
        }
        const PlainTriangle triangle = plainTriangle(corners);
        for (const int samples : {1, 4})
        {
            const bool is = drawsAnything(samples, triangle, *tile);
            ASSERT_EQ(coversSample(samples, triangle.setup, triangle.pixels), is)
                << k << ", " << samples << " samples";
            drawn[samples > 1 ? 1 : 0] += is ? 1 : 0;
        }
    }
    for (const int count : drawn)
    {
        EXPECT_GT(count, kTriangles / 20);
        EXPECT_LT(count, kTriangles * 19 / 20);
    }
    EXPECT_GT(drawn[1], drawn[0]);
}

TEST(ShellRows, TakeALargeTriangleForOneThatMayCoverASample)
{
    const PlainTriangle triangle = plainTriangle({{{4, 4}, {12, 4.001}, {4, 4.001}}});
    EXPECT_TRUE(coversSample(4, triangle.setup, triangle.pixels));
}

} // namespace
} // namespace frostfill
