// SPDX-License-Identifier: MIT
#include "study/peers/peer_study.hpp"
#include "study/peers/rigid_body_run.hpp"
#include "study/stability/stress_meshes.hpp"

#include <frostfill/error.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

namespace frostfill
{
namespace
{

/// Twelve radii wide, its floor at -6; spheres appear about nine above it.
PeerTask taskInABox(std::size_t count)
{
    PeerTask task;
    task.mesh = boxMesh({-6, -6, -6}, {6, 6, 6}, 2);
    task.count = count;
    task.secondsLimit = 10;
    return task;
}

TEST(Peers, PourSpheresClearOfEachOtherAndOfTheWalls)
{
    PeerTask task;
    task.mesh = boxMesh({-6, -6, -6}, {6, 6, 6}, 1);
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
    explicit QuickBodies(const PeerTask& /*task*/) {}
    void addSphere(const Eigen::Vector3d& place) { places_.push_back(place); }
    void step(double /*dt*/)
    {
        ++steps_;
        for (Eigen::Vector3d& p : places_)
        {
            p.y() = still ? -5 : -5 - steps_;
        }
    }
    [[nodiscard]] std::size_t size() const { return places_.size(); }
    [[nodiscard]] std::vector<Eigen::Vector3d> places() const { return places_; }

private:
    std::vector<Eigen::Vector3d> places_;
    int steps_ = 0;
};

TEST(RigidBodyRun, PoursWhatThereIsRoomForUntilAllAreThereAndThenWaitsForRest)
{
    const PeerTask task = taskInABox(60);
    ASSERT_EQ(Pouring(task).next({}).size(), 25u);
    const PeerResult result = runRigidBodies<QuickBodies<true>>(task, 0.25);
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
    const PeerResult late = runRigidBodies<QuickBodies<false>>(task, 0.25);
    EXPECT_FALSE(late.atRest);
    EXPECT_EQ(late.simulated, task.timeLimit);
    EXPECT_EQ(late.places.size(), task.count);
    task.secondsLimit = 0;
    EXPECT_EQ(runRigidBodies<QuickBodies<false>>(task, 0.25).simulated, 0);
}

struct RigidBodyEngine
{
    const char* name;
    bool (*has)();
    PeerResult (*run)(const PeerTask&, double step);
};

std::ostream& operator<<(std::ostream& out, const RigidBodyEngine& engine)
{
    return out << engine.name;
}

class RigidBodyPeers : public testing::TestWithParam<RigidBodyEngine>
{
protected:
    void SetUp() override
    {
        if (!GetParam().has())
        {
            EXPECT_THROW(static_cast<void>(GetParam().run(taskInABox(1), 0.1)), Error);
            GTEST_SKIP() << GetParam().name
                         << " is not built in: -DFROSTFILL_PEERS=ON builds it in";
        }
    }
};

TEST_P(RigidBodyPeers, BringSpheresToRestAndLoseNoneOnEitherSideOfTheTriangles)
{
    PeerTask task = taskInABox(40);
    task.restitution = 0.2;
    const TriangleMesh meshes[] = {task.mesh, insideOut(task.mesh)};
    for (const TriangleMesh& mesh : meshes)
    {
        task.mesh = mesh;
        const PeerResult result = GetParam().run(task, 0.06);
        EXPECT_TRUE(result.atRest);
        EXPECT_LT(result.simulated, 100);
        EXPECT_EQ(result.places.size(), task.count);
        double lowest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < result.places.size(); ++i)
        {
            EXPECT_LT(result.places[i].cwiseAbs().maxCoeff(), 5.1);
            lowest = std::min(lowest, result.places[i].y());
            for (std::size_t j = i + 1; j < result.places.size(); ++j)
            {
                EXPECT_GT((result.places[i] - result.places[j]).norm(), 1.9);
            }
        }
        EXPECT_NEAR(lowest, -5, 0.1);
    }
}

TEST_P(RigidBodyPeers, BounceAsHighAsTheRestitutionAsks)
{
    for (const double restitution : {0.3, 0.6})
    {
        PeerTask task = taskInABox(1);
        task.restitution = restitution;
        const double height = Pouring(task).next({}).at(0).y() + 5;
        // The fall, and the way up again.
        task.timeLimit = (1 + restitution) * std::sqrt(2 * height);
        const PeerResult result = GetParam().run(task, 0.005);
        ASSERT_EQ(result.places.size(), 1u);
        EXPECT_NEAR(result.places[0].y() + 5, restitution * restitution * height, 0.05 * height);
    }
}

INSTANTIATE_TEST_SUITE_P(Engines, RigidBodyPeers,
                         testing::Values(RigidBodyEngine{"Bullet", hasBullet, runBullet},
                                         RigidBodyEngine{"Ode", hasOde, runOde}),
                         testing::PrintToStringParamName());

TEST(Peers, AreRequiredWhereTheyAreToBeCompared)
{
    if (hasBullet() || hasOde() || hasLiggghts())
    {
        EXPECT_NO_THROW(requirePeers());
    }
    else
    {
        EXPECT_THROW(requirePeers(), Error);
    }
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
