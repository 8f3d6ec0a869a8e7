// SPDX-License-Identifier: MIT
#include "render/layer/static_layer.hpp"
#include "support/pictures.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace frostfill
{
namespace
{

using testing_support::Numbers;

constexpr int kWidth = 40;
constexpr int kHeight = 28;

std::uint32_t coded(double depth)
{
    return static_cast<std::uint32_t>(depth * 0xffffff) << 8 | 0xff; // the last eight do not count
}

ProjectedSphere sphereIn(const PixelRectangle& pixels, double depth)
{
    ProjectedSphere sphere;
    sphere.pixels = pixels;
    sphere.nearestDepth = static_cast<float>(depth);
    return sphere;
}

TEST(OcclusionMap, HidesWhatIsFartherAndNothingElse)
{
    OcclusionMap map(kWidth, kHeight);
    const PixelRectangle all = {0, 0, kWidth, kHeight};
    EXPECT_FALSE(map.hides(sphereIn(all, 1))) << "nothing is known yet";
    map.build(all, std::vector<std::uint32_t>(std::size_t{kWidth} * kHeight, coded(0.5)));
    for (const PixelRectangle& pixels : {all, PixelRectangle{3, 5, 4, 6}, {7, 7, 30, 9}})
    {
        EXPECT_FALSE(map.hides(sphereIn(pixels, 0.4)));
        EXPECT_FALSE(map.hides(sphereIn(pixels, 0.499)));
        EXPECT_TRUE(map.hides(sphereIn(pixels, 0.501)));
    }
    EXPECT_FALSE(map.hides(sphereIn({}, 0.9))) << "out of view is not hidden";
    map.clear();
    EXPECT_FALSE(map.hides(sphereIn(all, 1)));
}

// The oracle is every pixel that the sphere may be seen in.
TEST(OcclusionMap, HidesNothingOfWhichAPixelIsNearer)
{
    Numbers numbers;
    const auto upTo = [&](int n) { return static_cast<int>(n * numbers.next()); };
    int hidden = 0;
    for (int trial = 0; trial < 200; ++trial)
    {
        // Beyond the part that is known nothing hides.
        const PixelRectangle part = {upTo(6), upTo(6), kWidth - upTo(6), kHeight - upTo(6)};
        std::vector<std::uint32_t> depths;
        for (std::int64_t k = 0; k < part.area(); ++k)
        {
            depths.push_back(coded(numbers.next() < 0.01 ? 1 : 0.5 + 0.1 * numbers.next()));
        }
        OcclusionMap map(kWidth, kHeight);
        map.build(part, depths);
        for (int k = 0; k < 50; ++k)
        {
            const int left = upTo(kWidth - 8);
            const int bottom = upTo(kHeight - 8);
            const PixelRectangle pixels = {left, bottom, left + 1 + upTo(8), bottom + 1 + upTo(8)};
            const ProjectedSphere sphere = sphereIn(pixels, 0.55 + 0.1 * numbers.next());
            if (!map.hides(sphere))
            {
                continue;
            }
            ++hidden;
            ASSERT_EQ(common(pixels, part), pixels);
            for (int y = pixels.bottom; y < pixels.top; ++y)
            {
                for (int x = pixels.left; x < pixels.right; ++x)
                {
                    const auto at = (y - part.bottom) * part.width() + x - part.left;
                    ASSERT_LT((depths[static_cast<std::size_t>(at)] >> 8) / double{0xffffff},
                              sphere.nearestDepth + 1e-6);
                }
            }
        }
    }
    EXPECT_GT(hidden, 500);
}

} // namespace
} // namespace frostfill
