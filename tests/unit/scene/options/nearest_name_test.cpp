// SPDX-License-Identifier: MIT
#include "scene/options/nearest_name.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace frostfill
{
namespace
{

TEST(NearestName, EditDistanceCountsInsertionsDeletionsAndSubstitutions)
{
    EXPECT_EQ(editDistance("", ""), 0u);
    EXPECT_EQ(editDistance("", "abc"), 3u);
    EXPECT_EQ(editDistance("abc", "abc"), 0u);
    EXPECT_EQ(editDistance("kitten", "sitting"), 3u);
    EXPECT_EQ(editDistance("sitting", "kitten"), 3u);
}

TEST(NearestName, FindsATypingErrorAndNothingForAForeignWord)
{
    const std::vector<std::string> names = {"spheres.radius", "spheres.count", "motion.dt"};
    EXPECT_EQ(nearestName("spheres.raduis", names), "spheres.radius");
    EXPECT_EQ(nearestName("sphere.count", names), "spheres.count");
    EXPECT_EQ(nearestName("zzzzzzzz", names), "");
    const std::vector<std::string> flags = {"--edges", "--count"};
    EXPECT_EQ(nearestName("--bogus", flags), "") << "dashes alone are alike";
    EXPECT_EQ(nearestName("--cuont", flags), "--count");
}

} // namespace
} // namespace frostfill
