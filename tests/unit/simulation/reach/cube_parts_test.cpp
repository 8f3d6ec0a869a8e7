// SPDX-License-Identifier: MIT
#include "simulation/reach/cube_parts.hpp"

#include "unit/simulation/reach/reach_scene.hpp"

#include <gtest/gtest.h>

namespace frostfill::reach
{
namespace
{

constexpr double kEdgeOfCube = 0.7;
constexpr double kOfPart = kEdgeOfCube / 4;

/// Looks at each of the 64 parts by itself: the oracle.
class PartByPart
{
public:
    explicit PartByPart(const Eigen::Vector3d& middle)
    {
        for (int k = 0; k < 64; ++k)
        {
            const Eigen::Array3i place(k % 4, k / 4 % 4, k / 16);
            left_.emplace_back(middle.array() + kOfPart * (place.cast<double>() - 1.5));
        }
    }
    template <class IsTaken>
    void take(IsTaken&& isTaken)
    {
        std::erase_if(left_, isTaken);
    }
    /// Its eight corners lie in a ball.
    static bool isInBall(const Eigen::Vector3d& part, const Ball& ball)
    {
        bool inside = true;
        for (int k = 0; k < 8; ++k)
        {
            const Eigen::Array3d corner((k & 1) - 0.5, (k >> 1 & 1) - 0.5, (k >> 2 & 1) - 0.5);
            const Eigen::Vector3d p = part.array() + kOfPart * corner;
            inside = inside && (p - ball.centre).norm() < ball.radius;
        }
        return inside;
    }
    [[nodiscard]] bool any() const { return !left_.empty(); }
    template <class IsClear>
    [[nodiscard]] bool any(IsClear&& isClear) const
    {
        return std::any_of(left_.begin(), left_.end(), isClear);
    }

private:
    std::vector<Eigen::Vector3d> left_;
};

/// Takes parts of many cubes by balls, `take(parts, ball)`, and by the oracle, which asks
/// `isTaken(part, ball)` of each of them, until none is left.
template <class Take, class IsTaken>
void expectTakenAsOneByOne(Random random, double smallest, double largest, Take&& take,
                           IsTaken&& isTaken)
{
    int ends = 0;
    for (int trial = 0; trial < 300; ++trial)
    {
        const Eigen::Vector3d middle = random.point(-3, 3);
        CubeParts parts(middle, kEdgeOfCube);
        PartByPart oracle(middle);
        for (int k = 0; k < 40 && oracle.any(); ++k)
        {
            const double radius = random.uniform(smallest, largest);
            const Ball ball = {middle + random.direction(random.uniform(0, radius + 0.3)), radius};
            take(parts, ball);
            oracle.take([&](const Eigen::Vector3d& p) { return isTaken(p, ball); });
            ASSERT_EQ(parts.any(), oracle.any()) << "trial " << trial << " ball " << k;
        }
        ends += oracle.any() ? 0 : 1;
    }
    EXPECT_GT(ends, 100);
}

TEST(CubeParts, AreTakenByBallsAsOneByOne)
{
    expectTakenAsOneByOne(
        Random(1), 0.4, 2,
        [](CubeParts& parts, const Ball& ball)
        { parts.takeInBall(ball.centre, ball.radius * ball.radius); },
        PartByPart::isInBall);
}

// A ball beyond takes no part: who looks for balls looks no farther.
TEST(CubeParts, AreTakenByNothingFartherThanTheirReach)
{
    Random random(2);
    const double farthest = 2 + CubeParts::kReach * kEdgeOfCube;
    const auto anyTaken = [](const Eigen::Vector3d& centre)
    {
        CubeParts parts(Eigen::Vector3d::Zero(), kEdgeOfCube);
        parts.takeInBall(centre, 4);
        int left = 0;
        const auto count = [&](const Eigen::Vector3d&)
        {
            ++left;
            return false;
        };
        EXPECT_FALSE(parts.anyClear(centre, count));
        return left < 64;
    };
    for (int trial = 0; trial < 2000; ++trial)
    {
        EXPECT_FALSE(anyTaken(random.direction(farthest + 1e-9)));
    }
    // Along a diagonal it is as near as can be told.
    EXPECT_TRUE(anyTaken(Eigen::Vector3d(1, -1, 1).normalized() * (farthest - 1e-9)));
}

TEST(CubeParts, AreTakenByBallsThatTakeTheirMiddleAsOneByOne)
{
    expectTakenAsOneByOne(
        Random(4), 0.2, 1,
        [](CubeParts& parts, const Ball& ball)
        { parts.takeMiddleInBall(ball.centre, ball.radius * ball.radius); },
        [](const Eigen::Vector3d& p, const Ball& ball)
        { return (p - ball.centre).norm() < ball.radius; });
}

// Each part that is left is asked for once, with its middle.
TEST(CubeParts, AreAskedForUntilOneIsClear)
{
    Random random(3);
    int clear = 0;
    for (int trial = 0; trial < 500; ++trial)
    {
        const Eigen::Vector3d middle = random.point(-3, 3);
        CubeParts parts(middle, kEdgeOfCube);
        PartByPart oracle(middle);
        for (int k = 0; k < 2; ++k)
        {
            const Ball ball = {middle + random.direction(1.99), 2};
            parts.takeInBall(ball.centre, 4);
            oracle.take([&](const Eigen::Vector3d& p) { return PartByPart::isInBall(p, ball); });
        }
        const Eigen::Vector3d wanted = middle + random.point(-0.35, 0.35);
        const double within = random.uniform(0.02, 0.2);
        const auto isClear = [&](const Eigen::Vector3d& p)
        { return (p - wanted).lpNorm<Eigen::Infinity>() < within; };
        const bool found = parts.anyClear(random.direction(1), isClear);
        EXPECT_EQ(found, oracle.any(isClear)) << "trial " << trial;
        clear += found ? 1 : 0;
    }
    EXPECT_GT(clear, 50);
    EXPECT_LT(clear, 450);
}

// The way out leads to the part in that corner.
TEST(CubeParts, AreAskedForOnTheWayOutFirst)
{
    const CubeParts parts(Eigen::Vector3d::Zero(), kEdgeOfCube);
    for (const double x : {-1, 1})
    {
        for (const double y : {-1, 1})
        {
            for (const double z : {-1, 1})
            {
                Eigen::Vector3d first;
                EXPECT_TRUE(parts.anyClear({x, y, z},
                                           [&](const Eigen::Vector3d& p)
                                           {
                                               first = p;
                                               return true;
                                           }));
                EXPECT_LT((first - 1.5 * kOfPart * Eigen::Vector3d(x, y, z)).norm(), 1e-12);
            }
        }
    }
}

} // namespace
} // namespace frostfill::reach
