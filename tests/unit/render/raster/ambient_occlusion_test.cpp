// SPDX-License-Identifier: MIT
#include "render/raster/spheres/ambient_occlusion.hpp"

#include "render/raster/lanes/has_avx2.hpp"
#include "support/pictures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace frostfill
{
namespace
{

constexpr double kReach = 0.3;

/// A picture without perspective: a square of 2 by 2, seen from the front.
struct FlatView
{
    Surfaces surfaces;
    Framing framing;

    explicit FlatView(int width, int height)
    {
        framing.orthographic = true;
        framing.projection = glm::dmat4(1);
        surfaces.width = width;
        surfaces.height = height;
        const auto count = static_cast<std::size_t>(width * height);
        surfaces.distance.assign(count, Surfaces::kNothing);
        surfaces.normal.assign(count, {128, 128, 255});
        surfaces.identity.assign(count, 0);
    }
    [[nodiscard]] float& distance(int x, int y)
    {
        return surfaces.distance[static_cast<std::size_t>(y * surfaces.width + x)];
    }
    template <class HeightAt>
    void fill(HeightAt heightAt)
    {
        for (int y = 0; y < surfaces.height; ++y)
        {
            for (int x = 0; x < surfaces.width; ++x)
            {
                distance(x, y) = 5 - heightAt(x, y);
            }
        }
    }
    [[nodiscard]] std::vector<float> light(bool avx2 = lanes::hasAvx2()) const
    {
        AmbientOcclusion occlusion(avx2);
        return occlusion.lightOn(surfaces, framing, kReach);
    }
};

/// In double precision, one pixel after another: what all samples of a tile of pixels would be if
/// each pixel had them all.
double lightBySums(const FlatView& view, int x, int y)
{
    const Surfaces& s = view.surfaces;
    const double pixel = 2.0 / s.width;
    const double pixels = kReach / pixel;
    const auto at = [&](int column, int row)
    { return s.distance[static_cast<std::size_t>(row * s.width + column)]; };
    double sum = 0;
    for (int turn = 0; turn < 16; ++turn)
    {
        for (int i = 0; i < 16; ++i)
        {
            const double share = (i + 0.5) / 16;
            const double angle = 2 * M_PI * (share * 7 + turn / 16.0);
            const auto column = x + static_cast<int>(std::lround(share * pixels * std::cos(angle)));
            const auto row = y + static_cast<int>(std::lround(share * pixels * std::sin(angle)));
            if (column < 0 || row < 0 || column >= s.width || row >= s.height)
            {
                continue;
            }
            const double rise = at(x, y) - at(column, row);
            const double flat = pixel * std::hypot(column - x, row - y);
            const double squared = rise * rise + flat * flat;
            if (squared > 0)
            {
                sum += std::max(0.0, rise / std::sqrt(squared) - 0.06) *
                       std::max(0.0, 1 - squared / (kReach * kReach));
            }
        }
    }
    return std::max(0.22, 1 - 5 * sum / 256);
}

TEST(AmbientOcclusion, LeavesAPlaneAndNothingLit)
{
    FlatView view(70, 70);
    EXPECT_EQ(view.light().size(), 70U * 70U);
    for (const float light : view.light())
    {
        EXPECT_EQ(light, 1);
    }
    view.fill([](int, int) { return 0.0F; });
    for (const float light : view.light())
    {
        EXPECT_EQ(light, 1);
    }
}

TEST(AmbientOcclusion, IsThatOfPlainSumsBesideAStep)
{
    FlatView view(100, 100);
    view.fill([](int x, int) { return x < 50 ? 0.12F : 0.0F; });
    const std::vector<float> light = view.light();
    for (int x = 53; x < 75; ++x)
    {
        double mean = 0; // of the tile that is evened out: columns x - 2 to x + 1
        for (int u = -2; u < 2; ++u)
        {
            mean += lightBySums(view, x + u, 50) / 4;
        }
        EXPECT_NEAR(light[static_cast<std::size_t>(50 * 100 + x)], mean, 0.02) << x;
    }
    EXPECT_LT(light[50 * 100 + 53], 0.8F);
    EXPECT_GT(light[50 * 100 + 66], 0.99F); // out of reach
    EXPECT_EQ(light[50 * 100 + 40], 1);     // above the step nothing is higher
}

TEST(AmbientOcclusion, KeepsShadesOnTheirOwnSurface)
{
    FlatView view(96, 64);
    // A post, far before a wall: its shade is not on the wall. Nor is that of a ridge on the post,
    // two columns from its edge, blurred over the edge.
    view.fill([](int x, int) { return x == 53 ? 2.1F : x >= 40 && x < 56 ? 2.0F : 0.0F; });
    const std::vector<float> light = view.light();
    const auto at = [&](int x, int y) { return light[static_cast<std::size_t>(y * 96 + x)]; };
    EXPECT_LT(at(55, 30), 0.9F);
    for (const int x : {30, 39, 56, 57, 60})
    {
        EXPECT_EQ(at(x, 30), 1) << x;
    }
}

TEST(AmbientOcclusion, IsTheSameWithNarrowVectorsAndInPicturesOfAnyWidth)
{
    testing_support::Numbers numbers;
    for (const auto& [width, height] :
         {std::pair{1, 1}, {3, 5}, {8, 4}, {13, 9}, {64, 40}, {101, 33}})
    {
        FlatView view(width, height);
        view.fill([&](int, int) { return 0.2F * static_cast<float>(numbers.next()); });
        view.distance(width / 2, height / 2) = Surfaces::kNothing;
        EXPECT_EQ(view.light(true), view.light(false)) << width;
    }
}

} // namespace
} // namespace frostfill
