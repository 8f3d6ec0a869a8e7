// SPDX-License-Identifier: MIT
#include "render/picture/painter_settings.hpp"
#include "render/raster/shell/shell_raster.hpp"
#include "support/pictures.hpp"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

using testing_support::Numbers;

/// Triangles of up to some pixels, apart from each other.
TriangleMesh confetti(int count, double size)
{
    TriangleMesh mesh;
    Numbers numbers;
    const auto point = [&](double reach)
    {
        const double x = numbers.next() - 0.5;
        const double y = numbers.next() - 0.5;
        return Eigen::Vector3d(reach * Eigen::Vector3d(x, y, numbers.next() - 0.5));
    };
    for (int i = 0; i < count; ++i)
    {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        const Eigen::Vector3d middle = point(2);
        for (int corner = 0; corner < 3; ++corner)
        {
            mesh.vertices.emplace_back(middle + point(size));
        }
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

class ShellPlaces : public testing::TestWithParam<int>
{
protected:
    ShellPlaces()
    {
        settings_.size = {160, 96};
        framing_ = frame(mesh_.vertices, settings_, {0, 0, 160, 96});
        for (const Eigen::Vector3d& vertex : mesh_.vertices)
        {
            positions_.emplace_back(framing_.toUnit(vertex));
        }
        shaded_ = shadeMesh(mesh_, positions_);
        edges_ = edgeStrengths(shaded_, glm::vec3(framing_.eye), false);
    }

    [[nodiscard]] ShellRaster shell() const
    {
        ShellRaster result(shaded_, {.fadingLines = true}, shellPalette(settings_.style),
                           strokesFor(settings_), GetParam());
        result.lookFrom(uniformsOf(framing_, settings_), false, settings_.size, edges_);
        return result;
    }

    /// The corners of a triangle in the picture [pixel].
    [[nodiscard]] std::array<glm::dvec2, 3> corners(std::uint32_t triangle) const
    {
        const SphereUniforms uniforms = uniformsOf(framing_, settings_);
        std::array<glm::dvec2, 3> result;
        for (std::size_t i = 0; i < 3; ++i)
        {
            const glm::vec4 clip = uniforms.projection * uniforms.view *
                                   glm::vec4(positions_[mesh_.triangles[triangle][i]], 1);
            result[i] = {(double{clip.x} / clip.w + 1) / 2 * settings_.size.width,
                         (double{clip.y} / clip.w + 1) / 2 * settings_.size.height};
        }
        return result;
    }

    TriangleMesh mesh_ = confetti(3001, 0.08); // not a multiple of the lanes
    RenderSettings settings_;
    Framing framing_;
    std::vector<glm::vec3> positions_;
    ShadedMesh shaded_;
    std::vector<std::array<std::uint8_t, 3>> edges_;
};

double area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Around the pixels of which a sample lies in the triangle, by more than rounding may do.
PixelRectangle covered(const std::array<glm::dvec2, 3>& at, int samples)
{
    PixelRectangle result;
    const double whole = area(at[0], at[1], at[2]);
    for (int y = 0; y < 96; ++y)
    {
        for (int x = 0; x < 160; ++x)
        {
            for (std::size_t k = 0; k < static_cast<std::size_t>(samples); ++k)
            {
                const SampleOffset offset = samples > 1 ? kFourSamples[k] : SampleOffset{};
                const glm::dvec2 point(x + 0.5 + offset.x, y + 0.5 + offset.y);
                bool inside = std::abs(whole) > 1e-3;
                for (std::size_t i = 0; inside && i < 3; ++i)
                {
                    inside = area(at[i], at[(i + 1) % 3], point) / whole > 1e-3;
                }
                result = inside ? around(result, {x, y, x + 1, y + 1}) : result;
            }
        }
    }
    return result;
}

TEST_P(ShellPlaces, HoldEverySampleOfATriangleAndNoRowBeyondItsSamples)
{
    const ShellRaster shell = this->shell();
    const double gap = GetParam() > 1 ? 0.125 : 0.5; // from a pixel's edge to its samples
    constexpr double kRoom = 0.06;
    int empty = 0;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
    {
        const auto at = corners(t);
        const PixelRectangle& is = shell.bounds(t);
        const PixelRectangle least = covered(at, GetParam());
        if (is.empty())
        {
            ASSERT_TRUE(least.empty()) << t;
            ++empty;
            continue;
        }
        ASSERT_EQ(around(is, least), is) << t;
        const auto [left, right] = std::minmax({at[0].x, at[1].x, at[2].x});
        const auto [bottom, top] = std::minmax({at[0].y, at[1].y, at[2].y});
        ASSERT_GT(is.left + 1 - gap, left - kRoom) << t;
        ASSERT_LT(is.right - 1 + gap, right + kRoom) << t;
        ASSERT_GT(is.bottom + 1 - gap, bottom - kRoom) << t;
        ASSERT_LT(is.top - 1 + gap, top + kRoom) << t;
    }
    EXPECT_GT(empty, 0);
    EXPECT_LT(empty, 2000);
}

TEST_P(ShellPlaces, AreDrawnWithTheirBacksFirst)
{
    const std::vector<std::uint32_t> order = shell().inDrawingOrder();
    const auto isFront = [&](std::uint32_t t)
    {
        const auto at = corners(t);
        return area(at[0], at[1], at[2]) > 0;
    };
    EXPECT_TRUE(std::is_partitioned(order.begin(), order.end(),
                                    [&](std::uint32_t t) { return !isFront(t); }));
    const auto middle = std::find_if(order.begin(), order.end(), isFront);
    EXPECT_TRUE(std::is_sorted(order.begin(), middle));
    EXPECT_TRUE(std::is_sorted(middle, order.end()));
    EXPECT_GT(middle - order.begin(), 200);
    EXPECT_GT(order.end() - middle, 200);
}

TEST_P(ShellPlaces, AndLooksAreTheSameBitsWithAvx2AndWithout)
{
    const ShellRaster shell = this->shell();
    const std::vector<std::uint32_t> order = shell.inDrawingOrder();
    const auto drawn = [&](bool avx2, int left, int bottom)
    {
        const bool before = std::exchange(drawsWithAvx2, avx2);
        auto tile = std::make_unique<SampleTile>();
        for (std::size_t plane = 0; plane < kMaxTileSamples; ++plane)
        {
            tile->inverseDepth[plane].fill(kNothing);
            tile->colour[plane].fill(0);
        }
        shell.draw(order, {left, bottom, {0, 0, kTileEdge, kTileEdge}}, *tile);
        drawsWithAvx2 = before;
        return tile;
    };
    for (int bottom = 0; bottom < 96; bottom += kTileEdge)
    {
        for (int left = 0; left < 160; left += kTileEdge)
        {
            EXPECT_EQ(drawn(false, left, bottom)->colour,
                      drawn(drawsWithAvx2, left, bottom)->colour);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Samples, ShellPlaces, testing::Values(1, kMaxTileSamples));

} // namespace
} // namespace frostfill
