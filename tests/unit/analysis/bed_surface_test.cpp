// SPDX-License-Identifier: MIT
#include "unit/analysis/lattices.hpp"
#include "unit/analysis/mixed_spheres.hpp"

#include <frostfill/analysis.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace frostfill
{
namespace
{

using std::numbers::pi;

/// A box, or a pyramid without its tip, about the axis y from y = 0 on.
TriangleMesh vessel(double halfWidthBelow, double widening, double height)
{
    TriangleMesh mesh = shapes::box({-1, 0, -1}, {1, height, 1});
    for (Eigen::Vector3d& vertex : mesh.vertices)
    {
        const double halfWidth = halfWidthBelow + widening * vertex.y();
        vertex.x() *= halfWidth;
        vertex.z() *= halfWidth;
    }
    return mesh;
}

double heightOf(const Packing& packing)
{
    double height = 0;
    for (std::size_t k = 0; k < packing.radii.size(); ++k)
    {
        height = std::max(height, packing.centres[k].y() + packing.radii[k]);
    }
    return height;
}

/// Spheres at random in the vessel, up to a rough surface.
Packing roughBed(double halfWidthBelow, double widening)
{
    Packing packing = test::mixedSpheres(4000, 0.05, 2);
    std::vector<Eigen::Vector3d> centres;
    std::vector<double> radii;
    for (std::size_t k = 0; k < packing.radii.size(); ++k)
    {
        Eigen::Vector3d centre = packing.centres[k] + Eigen::Vector3d::UnitY();
        const double halfWidth = halfWidthBelow + widening * centre.y();
        centre.x() *= halfWidth;
        centre.z() *= halfWidth;
        if (centre.y() < 1 + 0.3 * std::sin(5 * centre.x()))
        {
            centres.push_back(centre);
            radii.push_back(packing.radii[k]);
        }
    }
    packing.centres = centres;
    packing.radii = radii;
    packing.atRest.assign(radii.size(), true);
    return packing;
}

void expectEqual(const std::vector<PorosityBin>& a, const std::vector<PorosityBin>& b)
{
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k)
    {
        EXPECT_NEAR(a[k].from, b[k].from, 1e-9) << k;
        EXPECT_NEAR(a[k].to, b[k].to, 1e-9) << k;
        EXPECT_NEAR(a[k].objectVolume, b[k].objectVolume, 1e-3 * b[k].objectVolume) << k;
        EXPECT_NEAR(a[k].porosity, b[k].porosity, 1e-3) << k;
    }
}

TEST(SurfaceOfABed, EndsTheBedOfALatticeInAContainerTwiceAsHigh)
{
    const Packing packing = test::packingOf(test::lattices()[0], 12, 1);
    const TriangleMesh cut = test::boxAround(packing);
    TriangleMesh high = cut;
    const double top = boundingBox(cut).max().z();
    for (Eigen::Vector3d& vertex : high.vertices)
    {
        vertex.z() += vertex.z() == top ? 12 : 0;
    }
    const AnalysisSettings settings = {.up = Axis::z, .bins = 24, .samples = 1 << 18};
    const PackingAnalysis inHigh = analysePacking(high, packing, settings);
    const PorosityProfiles& found = *inHigh.porosity;
    EXPECT_NEAR(found.whole.porosity, 1 - pi / 6, 5 * found.whole.error);
    EXPECT_NEAR(found.whole.objectVolume, 12 * 12 * 12, 1e-6);
    ASSERT_TRUE(found.bulk);
    EXPECT_NEAR(found.bulk->porosity, 1 - pi / 6, 5 * found.bulk->error);
    EXPECT_NEAR(found.bulk->objectVolume, 8 * 8 * 8, 2);
    ASSERT_EQ(found.height.size(), 24U);
    for (const PorosityBin& bin : found.height)
    {
        EXPECT_NEAR(bin.porosity, 1 - pi / 6, 1e-9) << bin.from; // half layers are mirror images
        EXPECT_EQ(bin.error, 0);
    }
    const PackingAnalysis inCut = analysePacking(cut, packing, settings);
    expectEqual(found.height, inCut.porosity->height);
    expectEqual(found.radial, inCut.porosity->radial);
    EXPECT_EQ(inHigh.pairs->centres, inCut.pairs->centres);
    EXPECT_EQ(inHigh.contacts->meanInside, 6);
    EXPECT_EQ(inHigh.order->inside, inCut.order->inside);
}

TEST(SurfaceOfABed, EndsARoughBedInAnyContainer)
{
    for (const double widening : {0.0, 0.4, -0.1})
    {
        const Packing packing = roughBed(1, widening);
        const double height = heightOf(packing);
        const PackingAnalysis cut = analysePacking(vessel(1, widening, height), packing);
        const PackingAnalysis high = analysePacking(vessel(1, widening, 2 * height), packing);
        expectEqual(high.porosity->height, cut.porosity->height);
        expectEqual(high.porosity->radial, cut.porosity->radial);
        EXPECT_NEAR(high.porosity->whole.porosity, cut.porosity->whole.porosity, 1e-4);
        ASSERT_TRUE(high.porosity->bulk && cut.porosity->bulk);
        EXPECT_NEAR(high.porosity->bulk->porosity, cut.porosity->bulk->porosity,
                    5 * cut.porosity->bulk->error);
        EXPECT_EQ(high.sizes->height.size(), cut.sizes->height.size());
        EXPECT_LT(high.porosity->whole.objectVolume, 0.9 * cut.meshVolume); // it is rough
    }
}

TEST(SurfaceOfABed, IsAtAHeightThatIsGiven)
{
    const Packing packing = test::packingOf(test::lattices()[0], 12, 1);
    const PackingAnalysis analysis = analysePacking(
        test::boxAround(packing), packing,
        {.below = 6, .bins = 6, .samples = 1 << 16, .only = {AnalysisKind::porosity}});
    const PorosityProfiles& found = *analysis.porosity;
    EXPECT_NEAR(found.whole.objectVolume, 12 * 12 * 6, 1e-6);
    ASSERT_EQ(found.height.size(), 6U);
    EXPECT_EQ(found.height.back().to, 6);
    EXPECT_NEAR(found.height.back().porosity, 1 - pi / 6, 1e-9);
    EXPECT_NEAR(found.bulk->objectVolume, 8 * 8 * 2, 1);
}

} // namespace
} // namespace frostfill
