// SPDX-License-Identifier: MIT
#include "simulation/settling/overlap_relief.hpp"

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

constexpr double kStiffness = 400;
constexpr double kLeft = kLeftByRelief * kGapAtRest;
const Eigen::Vector3d kUp = Eigen::Vector3d::UnitY();

LoadedContact onWall(std::uint32_t row, double depth, ContactMemory& memory)
{
    return {row, LoadedContact::kWall, kUp, depth, kStiffness, &memory};
}

LoadedContact onSphere(std::uint32_t row, std::uint32_t other, double depth, ContactMemory& memory)
{
    return {row, other, kUp, depth, kStiffness, &memory};
}

TEST(OverlapRelief, LiftsAColumnSoThatNoneOverlapsOrHangs)
{
    constexpr std::uint32_t kHigh = 50;
    std::vector<ContactMemory> memory(kHigh);
    OverlapRelief relief;
    std::vector<double> depths;
    for (std::uint32_t row = 0; row < kHigh; ++row)
    {
        const double depth = 1e-6 * (kHigh - row);
        relief.add(row == 0 ? onWall(row, depth, memory[row])
                            : onSphere(row, row - 1, depth, memory[row]));
        depths.push_back(depth);
    }
    ASSERT_TRUE(relief.solve(std::vector<double>(kHigh, 1.0)));
    for (std::uint32_t row = 0; row < kHigh; ++row)
    {
        const double below = row == 0 ? 0 : relief.displacement(row - 1).y();
        const double gap = relief.displacement(row).y() - below - depths[row];
        EXPECT_NEAR(gap, kGapAtRest / 2, 2 * kLeft) << row;
        EXPECT_EQ(relief.displacement(row).x(), 0) << row;
    }
}

TEST(OverlapRelief, PartsTwoFreeSpheresAsTheirMassesDo)
{
    ContactMemory memory;
    OverlapRelief relief;
    relief.add(onSphere(1, 0, 1e-3, memory));
    ASSERT_TRUE(relief.solve({1.0 / 8, 1}));
    const double opened = 1e-3 + kGapAtRest / 2;
    EXPECT_NEAR(relief.displacement(0).y(), -opened / 9, kLeft / 9);
    EXPECT_NEAR(relief.displacement(1).y(), opened * 8 / 9, kLeft);
}

TEST(OverlapRelief, LetsEachContactKeepItsForce)
{
    ContactMemory wall;
    ContactMemory pair;
    wall.held = 1.5;
    OverlapRelief relief;
    const LoadedContact below = onWall(0, 2e-4, wall);
    const LoadedContact above = onSphere(1, 0, 1e-4, pair);
    const double onBelow = below.push();
    const double onAbove = above.push();
    relief.add(below);
    relief.add(above);
    ASSERT_TRUE(relief.solve({1, 1}));
    const auto pushNow = [&](const LoadedContact& contact, double opened)
    { return contact.memory->held + kStiffness * (contact.depth - opened); };
    EXPECT_NEAR(pushNow(below, relief.displacement(0).y()), onBelow, 1e-12);
    EXPECT_NEAR(pushNow(above, relief.displacement(1).y() - relief.displacement(0).y()), onAbove,
                1e-12);
    EXPECT_NEAR(wall.held, onBelow, kStiffness * kGapAtRest);
}

TEST(OverlapRelief, ClosesAContactThatPushesAcrossAGap)
{
    ContactMemory memory;
    memory.held = 1;
    OverlapRelief relief;
    relief.add(onWall(0, -1e-3, memory));
    ASSERT_TRUE(relief.solve({1}));
    EXPECT_NEAR(relief.displacement(0).y(), -1e-3 + kGapAtRest / 2, kLeft);
    EXPECT_NEAR(memory.held, 1 - kStiffness * 1e-3 + kStiffness * kGapAtRest / 2,
                kStiffness * kLeft);
}

TEST(OverlapRelief, PushesWhatIsInTheWayAndPullsNothingAlong)
{
    // A floor presses the first sphere up. A second lies beyond a small gap, a third below a wide
    // one, on its own.
    ContactMemory floor;
    ContactMemory near;
    ContactMemory far;
    OverlapRelief relief;
    relief.add(onWall(0, 1e-3, floor));
    relief.add(onSphere(1, 0, -4e-4, near));
    relief.add(onSphere(0, 2, -1e-2, far));
    ASSERT_TRUE(relief.solve({1, 1, 1}));
    EXPECT_NEAR(relief.displacement(0).y(), 1e-3 + kGapAtRest / 2, kLeft);
    EXPECT_NEAR(relief.displacement(1).y(), 6e-4 + kGapAtRest, 2 * kLeft);
    EXPECT_EQ(relief.displacement(2).y(), 0);
    EXPECT_EQ(near.held, 0);
    EXPECT_EQ(far.held, 0);
}

} // namespace
} // namespace frostfill
