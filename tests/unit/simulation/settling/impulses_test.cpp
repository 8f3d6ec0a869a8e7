// SPDX-License-Identifier: MIT
#include "oracle/rest.hpp"
#include "oracle/rolling.hpp"
#include "simulation/contact/contact.hpp"
#include "unit/simulation/settling/bench.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <vector>

/// Spheres that settle by impulses, against closed forms.
namespace frostfill
{
namespace
{

using Eigen::Vector3d;

/// A sphere that has moved down a plane for a time of 4, from -8.
struct OnSlope
{
    OnSlope(double slope, double friction, double rollingFriction = 0) : bench(slope)
    {
        ball = bench.add({-8, -9 + kGapAtRest / 2, 0});
        bench.start(friction, rollingFriction);
        bench.motion().advanceByImpulses(4, {}, false);
    }
    [[nodiscard]] double speed() { return bench.velocity(ball).x(); }
    [[nodiscard]] double spin() { return bench.spin(ball).z(); }

    Bench bench;
    std::uint32_t ball = 0;
};

TEST(Impulses, LetASphereRollDownAPlaneByFiveSevenths)
{
    const double slope = 20 * kDegree;
    OnSlope ball(slope, 0.5);
    const double speed = 4 * oracle::rollingDown(slope);
    EXPECT_NEAR(ball.speed(), speed, 1e-6 * speed);
    EXPECT_NEAR(ball.spin(), -speed, 1e-6 * speed);
    EXPECT_NEAR(ball.bench.place(ball.ball).y(), -9 + kGapAtRest / 2, 1e-9);
}

TEST(Impulses, LetASphereSlipWhereFrictionIsTooLittleToRoll)
{
    const double slope = 60 * kDegree;
    OnSlope ball(slope, 0.3);
    const double speed = 4 * oracle::slidingDown(slope, 0.3);
    EXPECT_NEAR(ball.speed(), speed, 1e-6 * speed);
    EXPECT_NEAR(ball.spin(), -4 * oracle::spinOfSliding(slope, 0.3), 1e-6 * speed);
}

TEST(Impulses, ResistRollingByTheMomentAskedFor)
{
    const double slope = 20 * kDegree;
    OnSlope rolls(slope, 0.5, 0.1);
    const double speed = 4 * oracle::rollingDown(slope, 0.1);
    EXPECT_NEAR(rolls.speed(), speed, 1e-6 * speed);
    for (const double factor : {0.99, 1.01})
    {
        OnSlope ball(slope, 0.5, factor * std::tan(slope));
        EXPECT_EQ(ball.speed() > 1e-3, factor < 1) << ball.speed();
    }
}

TEST(Impulses, TurnTwoSpheresThatRollOnEachOtherAboutTheirOwnRadii)
{
    Bench bench;
    bench.world().pull.uniform.setZero();
    const auto a = bench.add({0, 0, 0}, 1.3);
    const auto b = bench.add({0, 2 - 1e-3, 0}, 0.7);
    GranularMotion& motion = bench.start(0.4, 0.1);
    motion.setSpin(b, {0.3, -1, 2});
    const double ma = massOf(1.3);
    const double mb = massOf(0.7);
    motion.advanceByImpulses(1, {}, false);
    const Vector3d momentum = ma * bench.velocity(a) + mb * bench.velocity(b);
    const Vector3d angular = ma * bench.place(a).cross(bench.velocity(a)) +
                             mb * bench.place(b).cross(bench.velocity(b)) +
                             0.4 * ma * 1.69 * bench.spin(a) + 0.4 * mb * 0.49 * bench.spin(b);
    const Vector3d before = 0.4 * mb * 0.49 * Vector3d(0.3, -1, 2);
    EXPECT_GT(ma * bench.spin(a).norm(), 1e-3) << "they did touch";
    EXPECT_LT(momentum.norm(), 1e-12);
    EXPECT_LT((angular - before).norm(), 1e-4) << "the lever is the radius, overlap or not";
}

TEST(Impulses, StandAsAPyramidOrFallAtTheFrictionOfStatics)
{
    for (const double factor : {0.99, 1.01})
    {
        Bench bench;
        for (const Vector3d& place : oracle::threeTouching(-9))
        {
            bench.add(place);
        }
        const auto top = bench.add({0, -9 + oracle::aboveThree(), 0});
        GranularMotion& motion = bench.start(factor * oracle::frictionOfPyramid());
        motion.advanceByImpulses(30, {}, false);
        const double sunk = -9 + oracle::aboveThree() - bench.place(top).y();
        EXPECT_EQ(sunk<0.01, factor> 1) << sunk;
    }
}

/// A column of spheres that touch, on the floor. It falls to the side after a while.
std::uint32_t addColumn(Bench& bench, int high, double apart = 2)
{
    std::uint32_t top = 0;
    for (int k = 0; k < high; ++k)
    {
        top = bench.add({0, -9 + apart * k, 0});
    }
    return top;
}

TEST(Impulses, PressAColumnTogetherAsItsStiffnessSays)
{
    constexpr int kHigh = 5;
    Bench bench;
    const auto top = addColumn(bench, kHigh);
    GranularMotion& motion = bench.start(0.5);
    motion.advanceByImpulses(10, {0, kDrag}, true);
    const double stiff = kStiffnessOfImpulses * Bench::kStiff;
    const double sunk = kHigh * (kHigh + 1) / (2 * stiff) - kHigh * kGapAtRest / 2;
    EXPECT_NEAR(bench.place(top).y(), -9 + 2.0 * (kHigh - 1) - sunk, 1e-3 * kHigh / stiff);
    EXPECT_LT(motion.unrest().missing, 1e-3);
}

TEST(Impulses, LeaveAColumnUprightWithoutAnOverlap)
{
    Bench bench;
    const auto top = addColumn(bench, 5);
    GranularMotion& motion = bench.start(0.5);
    motion.advanceByImpulses(10, {0, kDrag}, false);
    EXPECT_LE(motion.unrest().overlap, 0);
    EXPECT_LT(motion.unrest().missing, 1e-6);
    EXPECT_NEAR(bench.place(top).y(), -1, 5 * kGapAtRest);
}

TEST(Impulses, TakeOverWhatSpringsCarryAndGiveItBack)
{
    const double slope = 0.2;
    Bench bench(slope);
    bench.addOnFloor(-8);
    GranularMotion& motion = bench.start(1, 1);
    motion.advance(10, {0, kDrag});
    ASSERT_LT(motion.unrest().missing, 1e-3);
    motion.listAnew();
    motion.advanceByImpulses(kStepOfImpulses, {}, true);
    EXPECT_LT(std::abs(bench.velocity(0).x()), 1e-6) << "friction is what it was";
    motion.advanceByImpulses(10, {0, kDrag}, false);
    motion.listAnew();
    motion.advance(1e-3, {});
    EXPECT_LT(bench.velocity(0).norm(), 1e-5);
    EXPECT_LT(motion.unrest().missing, 1e-3);
}

TEST(Impulses, KnowTheForcesOfSpringsAndGiveThemBack)
{
    ContactMemory memory{{1e-3, 0, 2e-3}, {0, 1e-3, 0}, 4};
    memory.takeForces(1000, 5e-3);
    EXPECT_DOUBLE_EQ(memory.held, 9);
    EXPECT_LT((memory.slide + kTangentialStiffness * Vector3d(1, 0, 2)).norm(), 1e-12);
    EXPECT_LT((memory.roll + kTangentialStiffness * Vector3d(0, 1, 0)).norm(), 1e-12);
    memory.takeSprings(1000, 5e-3);
    EXPECT_DOUBLE_EQ(memory.held, 4);
    EXPECT_LT((memory.slide - Vector3d(1e-3, 0, 2e-3)).norm(), 1e-15);
    EXPECT_LT((memory.roll - Vector3d(0, 1e-3, 0)).norm(), 1e-15);
}

TEST(Impulses, LeaveAWallAloneThatIsNear)
{
    Bench bench;
    const auto ball = bench.add({9 - 0.03, -9, 0});
    GranularMotion& motion = bench.start(0.5);
    motion.advanceByImpulses(1, {0, kDrag}, false);
    motion.relieve();
    EXPECT_LT(motion.unrest().missing, 1e-6) << "springs would pull";
    EXPECT_NEAR(bench.place(ball).x(), 9 - 0.03, 1e-9);
}

TEST(Impulses, HoldWhatTheyHeldWhenOverlapsAreTakenAway)
{
    Bench bench;
    addColumn(bench, 5, 2 - 1e-4);
    GranularMotion& motion = bench.start(0.5);
    motion.advanceByImpulses(kStepOfImpulses, {0, kDrag}, false);
    ASSERT_GT(motion.unrest().overlap, 1e-6);
    motion.relieve();
    EXPECT_LE(motion.unrest().overlap, 0);
    motion.advanceByImpulses(5, {0, kDrag}, false);
    EXPECT_LT(motion.unrest().missing, 1e-3);
}

TEST(Impulses, GainNextToNoEnergy)
{
    Bench bench;
    addCrowd(bench, 5);
    GranularMotion& motion = bench.start(0.5, 0.1);
    const auto energy = [&]
    {
        double sum = motion.unrest().kinetic;
        for (std::uint32_t row = 0; row < 125; ++row)
        {
            sum += massOf(bench.world().spheres.running().radius[row]) * bench.place(row).y();
        }
        return sum;
    };
    double before = energy();
    const double start = before;
    double fall = 0;
    for (int k = 0; k < 60; ++k)
    {
        motion.advanceByImpulses(0.1, {}, true);
        EXPECT_LT(energy() - before, 2e-3 * std::abs(start)) << "after " << k << " looks";
        before = energy();
        fall = std::max(fall, motion.unrest().kinetic);
    }
    EXPECT_GT(fall, 10) << "they did fall";
}

TEST(Impulses, AreTheSameOnAnyNumberOfThreads)
{
    std::vector<Vector3d> places;
    for (const int threads : {1, 2, 3, 8})
    {
        Bench bench(0.2, room(), threads);
        addCrowd(bench, 8);
        GranularMotion& motion = bench.start(0.3, 0.1);
        ASSERT_GE(bench.world().spheres.size(), kSpheresWorthSharing);
        motion.advanceByImpulses(3, {0, kDrag}, true);
        const auto now = bench.world().spheres.running().position.all();
        if (places.empty())
        {
            places.assign(now.begin(), now.end());
        }
        EXPECT_TRUE(std::equal(now.begin(), now.end(), places.begin())) << threads;
    }
}

/// Columns of three spheres along z in a high room, listed where they lay closer than they do now:
/// the first and the second have moved apart by more than a slab since, so that they are two slabs
/// apart by the longest contact there was. The third touches the second.
class DriftedApart
{
public:
    static constexpr double kReach = 1.3;

    explicit DriftedApart(int threads = 1) : threads_(threads)
    {
        for (int k = 0; k < kColumns; ++k)
        {
            const double x = 3.0 * (k % 5) - 6;
            const int level = k / 5;
            const double y = 3.0 * level - 96;
            for (const double z : {-9.0, kFirst, kFirst + 2.5, kFirst + 2.65 + 2 + kGapAtRest})
            {
                world_->spheres.add({x, y, z}, 1, 0);
            }
        }
        const std::vector<double> reaches(running_.size(), kReach);
        pairs_.list(reaches);
        for (std::uint32_t row = 0; row < running_.size(); row += 4)
        {
            running_.position[row + 2].z() = kFirst + 2.65;
        }
        sweeps_.plan(2 * kReach);
        for (std::uint32_t row = 0; row < running_.size(); row += 4)
        {
            running_.position[row + 1].z() = kFirst + 0.65; // it meets the second
            running_.velocity[row + 1] = {0, 0, 1};
        }
        sweeps_.solve({.dt = 0.01, .sweeps = 1, .stiffness = 0, .most = 1e9});
    }
    [[nodiscard]] double speed(std::uint32_t column, std::uint32_t sphere) const
    {
        return running_.velocity[4 * column + sphere].z();
    }
    static constexpr int kColumns = 320;

private:
    static constexpr double kFirst = -9 + 4 * kReach - 0.02; // at the end of the second slab

    std::unique_ptr<World> world_ = smallWorld(shapes::box({-10, -100, -12}, {10, 100, 12}));
    RunningSpheres& running_ = world_->spheres.running();
    RunningColumn<Vector3d> spin_{running_, [](std::uint32_t, Vector3d& spin) { spin.setZero(); }};
    ContactLaw law_{.stiffness = 1e5};
    Threads threads_;
    PairContacts pairs_{running_, spin_, law_, threads_};
    WallContacts walls_{*world_, spin_, law_, threads_};
    ImpulseSweeps sweeps_{running_, spin_, law_, pairs_, walls_, threads_};
};

// Contacts of one sphere would else be swept by two threads at once. In its own turn the contact
// with the third comes first, and nothing moves it yet.
TEST(ImpulseSweeps, TakeContactsOfOneSphereInDifferentTurnsHoweverFarItHasMoved)
{
    for (const int threads : {1, 3})
    {
        const DriftedApart spheres(threads);
        for (std::uint32_t column = 0; column < DriftedApart::kColumns; ++column)
        {
            EXPECT_GT(spheres.speed(column, 2), 0.4);
            EXPECT_EQ(spheres.speed(column, 3), 0);
        }
    }
}

// The guard looks at them after the step, not in its middle.
TEST(Impulses, EndAStepInWhichASphereIsLost)
{
    for (const double lost :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e300})
    {
        Bench bench;
        for (int k = 0; k < 60; ++k)
        {
            const Eigen::Vector3i site(k % 7, k / 49, k / 7 % 7);
            bench.add(Vector3d(-7, -9, -7) + 2.2 * site.cast<double>());
        }
        bench.start(0.3);
        bench.motion().advanceByImpulses(0.1, {}, false);
        bench.place(30) = Vector3d::Constant(lost);
        bench.motion().listAnew();
        bench.motion().advanceByImpulses(0.1, {}, false);
        EXPECT_TRUE(bench.place(31).allFinite());
    }
}

} // namespace
} // namespace frostfill
