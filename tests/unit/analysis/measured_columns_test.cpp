// SPDX-License-Identifier: MIT
#include "analysis/measured_columns.hpp"

#include "analysis/sphere_values.hpp"
#include "support/expect_error.hpp"
#include "unit/analysis/lattices.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace frostfill
{
namespace
{

using test::expectError;

/// The lattice at rest but for its first sphere.
Snapshot snapshotOf(const Packing& packing)
{
    Snapshot snapshot;
    snapshot.resize(packing.radii.size());
    for (std::size_t k = 0; k < packing.radii.size(); ++k)
    {
        snapshot.centres[k] = (packing.centres[k] - packing.centres[0]).cast<float>();
        snapshot.radii[k] = static_cast<float>(packing.radii[k]);
        snapshot.states[k] = k == 0 ? SphereState::running : SphereState::frozen;
    }
    snapshot.origin = packing.centres[0];
    return snapshot;
}

TEST(MeasuredColumns, AreThoseOfTheTableEachOfThemFoundByAnAnalysis)
{
    const std::vector<std::string> names = measuredNames();
    ASSERT_EQ(names.size(), findings().size());
    for (const Finding& finding : findings())
    {
        const Column* column = findColumn(finding.column);
        ASSERT_NE(column, nullptr) << finding.column;
        EXPECT_TRUE(column->measured);
        EXPECT_FALSE(column->file); // of a run
    }
    for (const ColumnValues& carried : carriedColumns(std::vector<std::string>{"q6"}))
    {
        EXPECT_FALSE(carried.column().measured);
    }
}

TEST(MeasuredColumns, AreWhatAnAnalysisOfTheSpheresAtRestFinds)
{
    const Packing packing = test::packingOf(test::lattices()[2], 4, 0.7);
    const TriangleMesh box = test::boxAround(packing);
    Packing atRest = packing;
    atRest.centres.erase(atRest.centres.begin());
    atRest.radii.pop_back();
    const PackingAnalysis analysis =
        analysePacking(box, atRest, {.only = {AnalysisKind::order, AnalysisKind::contacts}});
    MeasuredColumns columns(box, {"q6", "sphere_contacts", "wall_distance"}, 2);
    Snapshot snapshot = snapshotOf(packing);
    for (int times = 0; times < 2; ++times) // the second time they are replaced
    {
        columns.fill(snapshot, packing.centres, packing.radii);
        ASSERT_EQ(snapshot.columns.size(), 3U);
        for (std::size_t k = 1; k < packing.radii.size(); ++k)
        {
            EXPECT_FLOAT_EQ(static_cast<float>(snapshot.columns[0].at(k)),
                            static_cast<float>(analysis.order->q6[k - 1]));
            EXPECT_EQ(snapshot.columns[1].at(k), analysis.contacts->spheres[k - 1]);
            EXPECT_FLOAT_EQ(static_cast<float>(snapshot.columns[2].at(k)),
                            static_cast<float>(analysis.wallDistances[k - 1]));
        }
        EXPECT_TRUE(std::isnan(snapshot.columns[0].at(0))); // it runs
        EXPECT_EQ(snapshot.columns[1].at(0), 0);
    }
    columns.fill(snapshot); // places in single precision
    EXPECT_EQ(snapshot.columns[1].at(20), analysis.contacts->spheres[19]);
}

TEST(MeasuredColumns, AreEmptyWhereNothingRests)
{
    const Packing packing = test::packingOf(test::lattices()[0], 2, 0.7);
    MeasuredColumns columns(test::boxAround(packing), {"q6"}, 1);
    Snapshot none;
    columns.fill(none);
    EXPECT_TRUE(none.columns.at(0).bits.empty());
    Snapshot falling = snapshotOf(packing);
    falling.states.assign(falling.states.size(), SphereState::running);
    columns.fill(falling);
    EXPECT_TRUE(std::isnan(falling.columns.at(0).at(3)));
}

TEST(MeasuredColumns, RefuseOtherNames)
{
    const TriangleMesh box = shapes::box({0, 0, 0}, {1, 1, 1});
    for (const char* name : {"speed", "porosity", ""})
    {
        expectError(
            ErrorCode::usage, [&] { const MeasuredColumns columns(box, {name}, 1); }, "measured",
            "local_fraction");
    }
}

} // namespace
} // namespace frostfill
