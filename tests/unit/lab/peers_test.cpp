// SPDX-License-Identifier: MIT
#include "lab/meshes.hpp"
#include "lab/rigid_body_run.hpp"
#include "lab/study.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

/// Twelve radii wide, its floor at -6; spheres appear about nine above it.
PeerTask taskInABox(std::size_t count)
{
    PeerTask task;
    task.mesh = cutBoxMesh({-6, -6, -6}, {6, 6, 6}, 2);
    task.count = count;
    task.secondsLimit = 10;
    return task;
}

TEST(Peers, PourSpheresClearOfEachOtherAndOfTheWalls)
{
    PeerTask task;
    task.mesh = cutBoxMesh({-6, -6, -6}, {6, 6, 6}, 1);
    task.count = 60;
    Pouring pouring(task);
    std::vector<Eigen::Vector3d> all = pouring.next({});
    const std::size_t atOnce = all.size();
    EXPECT_GT(atOnce, 10u);
    EXPECT_TRUE(pouring.next(all).empty()); // nothing has made room
    for (Eigen::Vector3d& p : all)
    {
        p.y() -= 8;
    }
    for (const Eigen::Vector3d& p : pouring.next(all))
    {
        all.push_back(p);
    }
    EXPECT_GT(all.size(), atOnce);
    EXPECT_LE(all.size(), task.count);
    for (std::size_t i = 0; i < all.size(); ++i)
    {
        EXPECT_LE(std::max(std::abs(all[i].x()), std::abs(all[i].z())), 5);
        for (std::size_t j = i + 1; j < all.size(); ++j)
        {
            EXPECT_GE((all[i] - all[j]).norm(), 2);
        }
    }
}

TEST(Peers, ComeToRestByTheCommonRule)
{
    RestDetector watch;
    std::vector<Eigen::Vector3d> places(10, Eigen::Vector3d::Zero());
    EXPECT_FALSE(watch.look(places)); // there was nothing to compare with
    EXPECT_TRUE(watch.look(places));
    places[3].x() += 2 * kPeerStill;
    EXPECT_FALSE(watch.look(places));
}

/// They are on the floor after their first step. There they stand still, or they fall on for ever.
template <bool still>
class QuickBodies
{
public:
    void addSphere(const Eigen::Vector3d& place) { places_.push_back(place); }
    void step()
    {
        ++steps_;
        for (Eigen::Vector3d& p : places_)
        {
            p.y() = still ? -5 : -5 - steps_;
        }
    }
    [[nodiscard]] std::size_t size() const { return places_.size(); }
    [[nodiscard]] std::vector<Eigen::Vector3d> places() const { return places_; }
    [[nodiscard]] double seconds() const { return 0.001 * steps_; }
    void end() {}

private:
    std::vector<Eigen::Vector3d> places_;
    int steps_ = 0;
};

TEST(RigidBodyRun, PoursWhatThereIsRoomForUntilAllAreThereAndThenWaitsForRest)
{
    const PeerTask task = taskInABox(60);
    ASSERT_EQ(Pouring(task).next({}).size(), 25u);
    const PeerResult result = runRigidBodies(task, 0.25, QuickBodies<true>());
    EXPECT_TRUE(result.atRest);
    EXPECT_EQ(result.places.size(), task.count);
    // 25 at 0, 25 at 1.5, 10 at 3. One step more and there is a first look. The next one is after
    // a window of 0.33.
    EXPECT_EQ(result.simulated, 3.75);
    EXPECT_GT(result.seconds, 0);
}

TEST(RigidBodyRun, EndsAtItsLimitsWhenNothingComesToRest)
{
    PeerTask task = taskInABox(30);
    task.timeLimit = 7;
    task.secondsLimit = 2;
    const PeerResult late = runRigidBodies(task, 0.25, QuickBodies<false>());
    EXPECT_FALSE(late.atRest);
    EXPECT_EQ(late.simulated, task.timeLimit);
    EXPECT_EQ(late.places.size(), task.count);
    task.secondsLimit = 0;
    EXPECT_EQ(runRigidBodies(task, 0.25, QuickBodies<false>()).simulated, 0);
}

TEST(Peers, AreTimedByTheFastestOfThem)
{
    std::vector<PeerPoint> points(4);
    points[0].ours = true;
    points[0].setting = "fall";
    points[0].seconds = 2;
    points[1].ours = true;
    points[1].setting = "skip";
    points[1].seconds = 1;
    points[2].seconds = 10;
    points[3].seconds = 20;
    EXPECT_EQ(peerRatio(points, "fall"), 5);
    EXPECT_EQ(peerRatio(points, "skip"), 10);
}

} // namespace
} // namespace frostfill
