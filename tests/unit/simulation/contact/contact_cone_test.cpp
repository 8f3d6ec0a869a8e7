// SPDX-License-Identifier: MIT
#include "base/random.hpp"
#include "simulation/contact/contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace frostfill
{
namespace
{

using Normals = std::vector<Eigen::Vector3d>;
const Eigen::Vector3d kDown(0, -1, 0);

TEST(ContactCone, WithoutContactsNothingIsTakenAway)
{
    EXPECT_EQ(projectToFree(kDown, Normals{}), kDown);
}

TEST(ContactCone, FloorCarriesTheWholeWeight)
{
    EXPECT_EQ(projectToFree(kDown, Normals{{0, 1, 0}}).norm(), 0);
}

TEST(ContactCone, InclineLeavesTheSineOfItsAngle)
{
    const double angle = 0.3;
    const auto left = projectToFree(kDown, Normals{{std::sin(angle), std::cos(angle), 0}});
    EXPECT_NEAR(left.norm(), std::sin(angle), 1e-15);
}

TEST(ContactCone, IsTheProjectionForRandomContacts)
{
    std::size_t compared = 0;
    for (std::uint64_t trial = 0; trial < 300; ++trial)
    {
        Normals normals;
        const auto count = 1 + mixBits(trial) % 6;
        for (std::uint64_t k = 0; k < count; ++k)
        {
            const auto random = [&](std::uint64_t d)
            { return 2 * uniformRandom(5, trial, 3 * k + d) - 1; };
            normals.push_back(Eigen::Vector3d(random(0), random(1), random(2)).normalized());
        }
        // The projection p of v onto a cone is the point of it with (v - p) . p = 0 for which no
        // direction u of the cone has a larger v . u than |p| [Moreau 1962].
        const Eigen::Vector3d projection = projectToFree(kDown, normals);
        EXPECT_NEAR((kDown - projection).dot(projection), 0, 1e-12) << "trial " << trial;
        const auto isInCone = [&](const Eigen::Vector3d& u, double tolerance)
        {
            return std::all_of(normals.begin(), normals.end(),
                               [&](const Eigen::Vector3d& n) { return n.dot(u) >= -tolerance; });
        };
        EXPECT_TRUE(isInCone(projection, 1e-9)) << "trial " << trial;
        for (std::uint64_t k = 0; k < 2000; ++k)
        {
            const auto random = [&](std::uint64_t d)
            { return 2 * uniformRandom(6, trial, 3 * k + d) - 1; };
            const Eigen::Vector3d u = Eigen::Vector3d(random(0), random(1), random(2)).normalized();
            if (isInCone(u, 0))
            {
                EXPECT_LE(kDown.dot(u), projection.norm() + 1e-9) << "trial " << trial;
                ++compared;
            }
        }
    }
    EXPECT_GT(compared, 10000U);
}

} // namespace
} // namespace frostfill
