// SPDX-License-Identifier: MIT
#include "bed/distance_field.hpp"

#include "support/expect_error.hpp"
#include "unit/bed/bed_on_the_spot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace frostfill
{
namespace
{

Eigen::Vector3d placeOf(const DistanceField& field, std::size_t voxel)
{
    const auto x = static_cast<double>(voxel % field.count[0]);
    const auto y = static_cast<double>(voxel / field.count[0] % field.count[1]);
    const auto z = static_cast<double>(voxel / field.count[0] / field.count[1]);
    return field.origin + field.spacing * Eigen::Vector3d(x, y, z);
}

// The closed form of spheres in a box: the nearest of all spheres and of six planes.
TEST(DistanceField, IsTheNearestOfAllSpheresAndWalls)
{
    const test::Spheres spheres = test::touchingSpheres(200, 0.3, 8);
    BedSettings settings;
    settings.voxels = 41;
    settings.contacts = ContactTreatment::none;
    const Bed bed = test::bedOf(shapes::box({-1, -1, -1}, {1, 1, 1}), spheres, settings);
    const DistanceField field = sampleDistances(bed);
    ASSERT_EQ(field.size(), 41U * 41 * 41);
    EXPECT_DOUBLE_EQ(field.spacing, 2.0 / 41);
    for (std::size_t voxel = 0; voxel < field.size(); ++voxel)
    {
        const Eigen::Vector3d p = placeOf(field, voxel);
        const double wall = 1 - p.lpNorm<Eigen::Infinity>();
        double sphere = std::numeric_limits<double>::infinity();
        std::int32_t label = 0;
        for (std::size_t k = 0; k < spheres.radii.size(); ++k)
        {
            const double away = (p - spheres.centres[k]).norm() - spheres.radii[k];
            label = away < 0 ? static_cast<std::int32_t>(k) + 1 : label;
            sphere = std::min(sphere, away);
        }
        ASSERT_NEAR(field.distance[voxel], std::min(sphere, wall), 1e-6) << p.transpose();
        ASSERT_EQ(field.label[voxel], label);
    }
}

TEST(DistanceField, KnowsWhatIsOutsideATorus)
{
    BedSettings settings;
    settings.voxels = 60;
    const Bed bed = test::bedOf(shapes::torus(1, 0.4, 400, 200), {{{1, 0, 0}}, {0.3}}, settings);
    const DistanceField field = sampleDistances(bed);
    EXPECT_EQ(field.count[2], 18U); // the box is 2.8 x 2.8 x 0.8
    std::size_t outside = 0;
    for (std::size_t voxel = 0; voxel < field.size(); ++voxel)
    {
        const Eigen::Vector3d p = placeOf(field, voxel);
        const double wall = 0.4 - std::hypot(std::hypot(p.x(), p.y()) - 1, p.z());
        const double sphere = (p - Eigen::Vector3d(1, 0, 0)).norm() - 0.99 * 0.3;
        if (std::abs(wall) > 1e-3)
        {
            ASSERT_EQ(field.label[voxel], wall < 0 ? -1 : sphere < 0 ? 1 : 0);
        }
        ASSERT_NEAR(field.distance[voxel], wall < 0 ? wall : std::min(wall, sphere), 1e-3);
        outside += wall < 0 ? 1 : 0;
    }
    EXPECT_GT(outside, field.size() / 4);
}

TEST(DistanceField, HasTheSameBitsForAnyNumberOfThreads)
{
    const test::Spheres spheres = test::touchingSpheres(100, 0.3, 8);
    DistanceField first;
    for (const int threads : {1, 2, 3})
    {
        BedSettings settings;
        settings.voxels = 50;
        settings.threads = threads;
        const Bed bed = test::bedOf(shapes::box({-1, -1, -1}, {1, 1, 1}), spheres, settings);
        DistanceField field = sampleDistances(bed);
        if (threads == 1)
        {
            first = std::move(field);
            continue;
        }
        EXPECT_TRUE(field.distance == first.distance);
        EXPECT_TRUE(field.label == first.label);
    }
}

TEST(DistanceField, RefusesMoreVoxelsThanFit)
{
    BedSettings settings;
    settings.voxels = 4096;
    const Bed bed =
        test::bedOf(shapes::box({-1, -1, -1}, {1, 1, 1}), {{{0, 0, 0}}, {0.5}}, settings);
    test::expectError(
        ErrorCode::usage, [&] { (void)sampleDistances(bed); }, "4096 x 4096 x 4096", "--voxels");
}

} // namespace
} // namespace frostfill
