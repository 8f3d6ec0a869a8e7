// SPDX-License-Identifier: MIT
#include "analysis/slabs.hpp"
#include "support/shapes.hpp"
#include "unit/analysis/mixed_spheres.hpp"

#include <frostfill/analysis.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace frostfill
{
namespace
{

using std::numbers::pi;

Packing oneAt(const Eigen::Vector3d& centre, double radius)
{
    Packing packing;
    packing.centres = {centre};
    packing.radii = {radius};
    packing.atRest = {true};
    return packing;
}

/// Of all that the mesh encloses, unless told otherwise.
PorosityProfiles porosityOf(const TriangleMesh& mesh, const Packing& packing,
                            AnalysisSettings settings = {})
{
    settings.only = {AnalysisKind::porosity};
    settings.below = settings.below.value_or(1e3);
    return *analysePacking(mesh, packing, settings).porosity;
}

/// Volume of a ball between two planes, by the integral of its sections.
double ballBetween(double radius, double low, double high)
{
    const auto integral = [&](double z)
    {
        z = std::clamp(z, -radius, radius);
        return pi * (radius * radius * z - z * z * z / 3);
    };
    return integral(high) - integral(low);
}

TEST(PorosityAlongAnAxis, OfASphereInABoxIsThatOfItsSections)
{
    constexpr double kRadius = 0.6;
    const Eigen::Vector3d centre(0.2, 1.3, 2.1);
    for (const Axis up : {Axis::x, Axis::y, Axis::z})
    {
        const auto axis = static_cast<Eigen::Index>(up);
        const PorosityProfiles profiles =
            porosityOf(shapes::box({-1, 0, 1}, {1, 4, 3}), oneAt(centre, kRadius),
                       {.up = up, .bins = 7, .samples = 4096});
        EXPECT_TRUE(profiles.slabsAreExact);
        ASSERT_EQ(profiles.height.size(), 7U);
        const double foot = Eigen::Vector3d(-1, 0, 1)[axis];
        const double tall = Eigen::Vector3d(2, 4, 2)[axis];
        const double floor = 16 / tall;
        for (std::size_t k = 0; k < 7; ++k)
        {
            const PorosityBin& bin = profiles.height[k];
            EXPECT_NEAR(bin.from, tall / 7 * static_cast<double>(k), 1e-12);
            EXPECT_NEAR(bin.objectVolume, 16.0 / 7, 1e-12);
            const double ball =
                ballBetween(kRadius, foot + bin.from - centre[axis], foot + bin.to - centre[axis]);
            EXPECT_NEAR(bin.porosity, 1 - ball / (floor * (bin.to - bin.from)), 1e-12) << k;
            EXPECT_EQ(bin.error, 0);
        }
    }
}

TEST(PorosityAlongAnAxis, HasTheVolumeOfSlabsOfSlantedWalls)
{
    TriangleMesh corner;
    corner.vertices = {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 3}};
    corner.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    const std::vector<double> heights = {0, 0.1, 0.5, 2, 3};
    const std::vector<double> slabs = meshSlabs(corner, 2, heights);
    const auto below = [](double height) { return 1 - std::pow(1 - height / 3, 3); };
    for (std::size_t k = 0; k + 1 < heights.size(); ++k)
    {
        EXPECT_NEAR(slabs[k], below(heights[k + 1]) - below(heights[k]), 1e-14) << k;
    }
}

TEST(PorosityAlongAnAxis, IsSampledWhereAMeshPassesThroughItself)
{
    TriangleMesh two = shapes::box({-1, -1, -1}, {1, 1, 1});
    const TriangleMesh other = shapes::box({0, 0, 0}, {2, 2, 2});
    for (const auto& triangle : other.triangles)
    {
        two.triangles.push_back({triangle[0] + 8, triangle[1] + 8, triangle[2] + 8});
    }
    two.vertices.insert(two.vertices.end(), other.vertices.begin(), other.vertices.end());
    const PorosityProfiles profiles =
        porosityOf(two, oneAt({0.5, 0.5, 0.5}, 0.5), {.bins = 3, .samples = 1 << 16});
    EXPECT_FALSE(profiles.slabsAreExact);
    ASSERT_EQ(profiles.height.size(), 3U);
    EXPECT_EQ(profiles.height[0].porosity, 1);
    EXPECT_NEAR(profiles.height[1].objectVolume, 4 + 4 - 1, 0.02); // what both have counts once
    EXPECT_NEAR(profiles.height[1].porosity, 1 - pi / 6 / 7, 5 * profiles.height[1].error);
    EXPECT_GT(profiles.height[1].error, 0);
}

TEST(PorosityAboutAnAxis, OfASphereOnItIsTheClosedForm)
{
    constexpr double kRadius = 0.8;
    const PorosityProfiles profiles =
        porosityOf(shapes::box({-1, -1, -1}, {1, 1, 1}), oneAt({0, 0, 0}, kRadius), {.bins = 20});
    // Of the ball within a cylinder.
    const auto within = [&](double distance)
    {
        const double rest = std::max(0.0, kRadius * kRadius - distance * distance);
        return 4 * pi / 3 * (std::pow(kRadius, 3) - std::pow(rest, 1.5));
    };
    std::size_t compared = 0;
    for (const PorosityBin& bin : profiles.radial)
    {
        if (bin.to < 1)
        {
            const double volume = 2 * pi * (bin.to * bin.to - bin.from * bin.from);
            EXPECT_NEAR(bin.objectVolume, volume, 0.02 * volume);
            EXPECT_NEAR(bin.porosity, 1 - (within(bin.to) - within(bin.from)) / volume,
                        5 * bin.error + 1e-12)
                << bin.from;
            EXPECT_LT(bin.error, 0.01);
            ++compared;
        }
    }
    EXPECT_EQ(compared, 14U);
}

TEST(PorosityAboutAnAxis, IsAboutTheCentreThatIsGiven)
{
    const PorosityProfiles profiles =
        porosityOf(shapes::box({-1, -1, -1}, {1, 1, 1}), oneAt({0.5, 0, -0.5}, 0.4),
                   {.centre = Eigen::Vector3d(0.5, 9, -0.5), .bins = 40, .samples = 1 << 16});
    EXPECT_NEAR(profiles.radial.back().to, 1.5 * std::sqrt(2.0), 1e-12);
    for (const PorosityBin& bin : profiles.radial)
    {
        EXPECT_EQ(bin.porosity < 1, bin.from < 0.4) << bin.from;
    }
}

TEST(PorosityFromTheWall, OfASphereInTheMiddleOfASphereBeginsWhereThatDoes)
{
    // Layers of a tenth of its diameter; a wall of triangles is up to 0.01 within the sphere.
    const PorosityProfiles profiles = porosityOf(loadMesh("sphere").mesh, oneAt({0, 0, 0}, 0.2),
                                                 {.range = 2.2, .samples = 1 << 16});
    const double radius = boundingBox(loadMesh("sphere").mesh).sizes().maxCoeff() / 2;
    std::size_t covered = 0;
    for (const PorosityBin& bin : profiles.wall)
    {
        EXPECT_TRUE(radius - bin.to < 0.21 || bin.porosity == 1) << bin.from;
        EXPECT_TRUE(radius - bin.from > 0.19 || bin.porosity == 0) << bin.from;
        covered += bin.porosity == 0 ? 1 : 0;
    }
    EXPECT_GT(covered, 1U);
    ASSERT_TRUE(profiles.bulk);
    EXPECT_EQ(profiles.bulk->porosity, 0);
    EXPECT_NEAR(profiles.bulk->from, 0.8, 1e-12);
}

TEST(PorosityFromTheWall, HasTheVolumeOfEachLayer)
{
    const PorosityProfiles profiles =
        porosityOf(shapes::box({-1, -1, -1}, {1, 1, 1}), oneAt({0, 0, 0}, 0.5), {.range = 0.8});
    for (const PorosityBin& bin : profiles.wall)
    {
        const double volume = std::pow(2 - 2 * bin.from, 3) - std::pow(2 - 2 * bin.to, 3);
        EXPECT_NEAR(bin.objectVolume, volume, 0.002 * volume) << bin.from;
    }
    EXPECT_FALSE(profiles.bulk);
    const PorosityProfiles small =
        porosityOf(shapes::box({-1, -1, -1}, {1, 1, 1}), oneAt({0, 0, 0}, 0.2));
    ASSERT_TRUE(small.bulk);
    EXPECT_NEAR(small.bulk->objectVolume, std::pow(0.4, 3), 0.001);
}

// Moving the sphere is as good as other places.
TEST(PorositySamples, HaveTheErrorThatTheyState)
{
    constexpr int kRuns = 40;
    double squares = 0;
    for (int run = 0; run < kRuns; ++run)
    {
        const double at = 0.01 * run;
        const PorosityBin whole =
            porosityOf(shapes::box({-1, -1, -1}, {1, 1, 1}), oneAt({at, -at / 2, at / 3}, 0.5),
                       {.samples = 1 << 14})
                .whole;
        const double expected = 1 - pi / 6 / 8;
        EXPECT_NEAR(whole.porosity, expected, 6 * whole.error);
        squares += std::pow((whole.porosity - expected) / whole.error, 2) / kRuns;
    }
    EXPECT_GT(squares, 0.1);
    EXPECT_LT(squares, 4);
}

TEST(PorositySamples, SeeSpheresOfEverySize)
{
    const Packing packing = test::mixedSpheres(300, 0.4, 50);
    const PorosityProfiles profiles =
        porosityOf(loadMesh("cube").mesh, packing, {.samples = 1 << 16});
    std::size_t covered = 0;
    constexpr std::size_t kPlaces = 40000;
    for (std::uint64_t k = 0; k < kPlaces; ++k)
    {
        const Eigen::Vector3d place(2 * uniformRandom(3, k, 0) - 1, 2 * uniformRandom(3, k, 1) - 1,
                                    2 * uniformRandom(3, k, 2) - 1);
        bool in = false;
        for (std::size_t s = 0; s < packing.radii.size() && !in; ++s)
        {
            in = (place - packing.centres[s]).norm() <= packing.radii[s];
        }
        covered += in ? 1 : 0;
    }
    const double share = static_cast<double>(covered) / kPlaces;
    EXPECT_NEAR(profiles.whole.porosity, 1 - share,
                5 * std::sqrt(share * (1 - share) / kPlaces) + 5 * profiles.whole.error);
}

} // namespace
} // namespace frostfill
