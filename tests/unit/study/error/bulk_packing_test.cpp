// SPDX-License-Identifier: MIT
#include "study/error/bulk_packing.hpp"

#include "oracle/packings.hpp"
#include "support/shapes.hpp"
#include "support/small_world.hpp"

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

constexpr int kHalfEdge = 12;

BulkPacking measured(const oracle::Packing& packing)
{
    const auto world = smallWorld(shapes::box(Eigen::Vector3d::Constant(-kHalfEdge),
                                              Eigen::Vector3d::Constant(kHalfEdge), 2));
    for (const Eigen::Vector3d& place : packing.places)
    {
        addResting(*world, place);
    }
    return bulkPacking(*world, 4);
}

// The box that is looked at ends between spheres.
TEST(BulkPacking, OfASimpleCubicLatticeIsExact)
{
    const oracle::Packing packing = oracle::simpleCubic(kHalfEdge);
    const BulkPacking bulk = measured(packing);
    EXPECT_EQ(bulk.spheres, 8U * 8 * 8);
    EXPECT_NEAR(bulk.fraction, packing.fraction, 1e-12);
    EXPECT_EQ(bulk.contacts, packing.contacts);
}

// Spheres are cut by the box, and the share that is inside is found with points.
TEST(BulkPacking, OfTheDensestLatticeHasItsFractionAndTwelveContacts)
{
    const oracle::Packing packing = oracle::faceCentredCubic(kHalfEdge);
    const BulkPacking bulk = measured(packing);
    EXPECT_GT(bulk.spheres, 400U);
    EXPECT_NEAR(bulk.fraction, packing.fraction, 0.03);
    EXPECT_EQ(bulk.contacts, packing.contacts);
}

} // namespace
} // namespace frostfill
