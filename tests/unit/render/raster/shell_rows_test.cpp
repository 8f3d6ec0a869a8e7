// SPDX-License-Identifier: MIT
#include "render/raster/shell/shell_rows.hpp"

#include "render/raster/lanes/has_avx2.hpp"
#include "support/pictures.hpp"

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

using testing_support::Numbers;

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

/// Counter-clockwise, within a square of a tile.
PlainTriangle someTriangle(Numbers& numbers)
{
    const double size = 0.05 + 3.5 * numbers.next();
    const auto inTile = [&] { return size / 2 + (kTileEdge - size) * numbers.next(); };
    const glm::dvec2 middle(inTile(), inTile());
    std::array<glm::dvec2, 3> corners;
    for (glm::dvec2& corner : corners)
    {
        const double x = numbers.next() - 0.5;
        corner = middle + size * glm::dvec2(x, numbers.next() - 0.5);
    }
    const glm::dvec2 u = corners[1] - corners[0];
    const glm::dvec2 v = corners[2] - corners[0];
    if (u.x * v.y - u.y * v.x < 0)
    {
        std::swap(corners[1], corners[2]);
    }
    return plainTriangle(corners);
}

std::unique_ptr<SampleTile> someTile(Numbers& numbers)
{
    auto tile = std::make_unique<SampleTile>();
    for (std::size_t plane = 0; plane < kMaxTileSamples; ++plane)
    {
        for (std::size_t at = 0; at < kTilePixels; ++at)
        {
            tile->inverseDepth[plane][at] = numbers.next() < 0.8 ? kNothing : 1;
            tile->colour[plane][at] = static_cast<std::uint32_t>(numbers.next() * 0xffffffff);
        }
    }
    return tile;
}

void copy(const SampleTile& from, SampleTile& to, const PixelRectangle& pixels)
{
    for (std::size_t plane = 0; plane < kMaxTileSamples; ++plane)
    {
        for (int y = pixels.bottom; y < pixels.top; ++y)
        {
            const auto row = static_cast<std::ptrdiff_t>(y) * kTileEdge;
            std::copy(from.colour[plane].begin() + row + pixels.left,
                      from.colour[plane].begin() + row + pixels.right,
                      to.colour[plane].begin() + row + pixels.left);
        }
    }
}

TEST(ShellRows, DrawTheSameOfASmallTriangleTwoRowsAtATimeAsRowByRow)
{
    const TilePart whole = {0, 0, {0, 0, kTileEdge, kTileEdge}};
    const ShellRows frame = {0, 0, 0, 0, 1};
    Numbers numbers;
    const auto before = someTile(numbers);
    int small = 0;
    int changed = 0;
    for (int k = 0; k < 4000; ++k)
    {
        const PlainTriangle triangle = someTriangle(numbers);
        const int samples = k % 2 == 0 ? 1 : kMaxTileSamples;
        // Row by row, and what the bounds leave out as well: nothing.
        const auto byRows = std::make_unique<SampleTile>(*before);
        drawShellRows(lanes::hasAvx2(), samples, triangle.setup, frame, whole.pixels, whole,
                      *byRows);
        // A part of it.
        PixelRectangle pixels = triangle.pixels;
        pixels.left += k % 3 == 0 && pixels.width() > 1 ? 1 : 0;
        pixels.right -= k % 5 == 0 && pixels.width() > 1 ? 1 : 0;
        pixels.bottom += k % 7 == 0 && pixels.height() > 1 ? 1 : 0;
        pixels.top -= k % 11 == 0 && pixels.height() > 1 ? 1 : 0;
        small += pixels.width() <= 4 ? 1 : 0;
        const auto expected = std::make_unique<SampleTile>(*before);
        copy(*byRows, *expected, pixels.width() <= 4 ? pixels : inWholeLanes(pixels));
        const auto drawn = std::make_unique<SampleTile>(*before);
        drawShellRows(lanes::hasAvx2(), samples, triangle.setup, frame, pixels, whole, *drawn);
        ASSERT_EQ(drawn->colour, expected->colour) << k;
        ASSERT_EQ(drawn->inverseDepth, before->inverseDepth) << k;
        changed += drawn->colour != before->colour ? 1 : 0;
    }
    EXPECT_GT(small, 3000);
    EXPECT_GT(changed, 1000);
}

} // namespace
} // namespace frostfill
