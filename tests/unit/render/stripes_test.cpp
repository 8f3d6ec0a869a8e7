// SPDX-License-Identifier: MIT
// A stripe shows how a sphere has turned.
#include "support/drawn_with.hpp"
#include "support/pictures.hpp"
#include "unit/render/draw.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace frostfill
{
namespace
{

using namespace testing_support;

constexpr int kEdge = 200;
constexpr double kRadius = 0.9;

/// What turns with a sphere, as it appears.
const Eigen::Vector3d kAxis(0.8, 0.36, 0.48);

/// One sphere in the middle, seen along the horizontal depth axis without perspective.
struct OneSphere
{
    OneSphere(Look look, bool isCut) : cut(isCut)
    {
        settings.backend = test::drawnWith();
        settings.size = {kEdge, kEdge};
        settings.style.look = look;
        settings.style.palette = paletteOf(look);
        settings.style.legend = settings.style.shell = settings.style.ground = false;
        settings.camera.azimuth = 0;
        settings.camera.elevation = 0;
        settings.camera.orthographic = true;
        if (cut)
        {
            settings.style.cutaway = {Cutaway::Kind::plane, {1, 0, 0}, 0.5, 0, 90};
        }
    }
    [[nodiscard]] Image drawn(const std::optional<Eigen::Quaterniond>& turned,
                              SphereState state) const
    {
        Snapshot snapshot;
        addSphere(snapshot, {0, 0, 0}, kRadius, state);
        if (turned)
        {
            turnSphere(snapshot, 0, *turned);
        }
        return test::draw(boxMesh({1, 1, 1}), settings, snapshot);
    }
    RenderSettings settings;
    bool cut; ///< to the right
};

/// Radius of the sphere in a picture. [pixel]
double radiusIn(const Image& image)
{
    int seen = 0;
    for (int x = 0; x < kEdge; ++x)
    {
        const auto* pixel = image.at(x, kEdge / 2);
        const auto* background = image.at(0, 0);
        seen += pixel[0] != background[0] || pixel[2] != background[2] ? 1 : 0;
    }
    return seen / 2.0;
}

/// Compares a sphere that has turned with one of which nobody knows: where it is darker. Returns in
/// how many pixels it has to be.
int expectStripe(const OneSphere& sphere, const Eigen::Quaterniond& turned, SphereState state)
{
    const Image plain = sphere.drawn({}, state);
    const Image striped = sphere.drawn(turned, state);
    const Eigen::Vector3d axis = turned * kAxis;
    const double radius = radiusIn(OneSphere(Look::clean, false).drawn({}, SphereState::frozen));
    const double edge = 2 / radius + 0.02;
    int inside = 0;
    int outside = 0;
    for (int y = 0; y < kEdge; ++y)
    {
        for (int x = 0; x < (sphere.cut ? kEdge / 2 : kEdge); ++x)
        {
            const double right = (x + 0.5 - kEdge / 2.0) / radius;
            const double up = (kEdge / 2.0 - y - 0.5) / radius;
            const double rhoSquared = right * right + up * up;
            if (rhoSquared > 0.7)
            {
                continue; // there is the ring of running ones
            }
            const Eigen::Vector3d normal(right, up, std::sqrt(1 - rhoSquared));
            const double cosine = std::abs(normal.dot(axis));
            const auto* before = plain.at(x, y);
            const auto* after = striped.at(x, y);
            if (cosine > 0.14 + edge)
            {
                ++outside;
                for (int channel = 0; channel < 3; ++channel)
                {
                    EXPECT_NEAR(after[channel], before[channel], 1) << x << ", " << y;
                }
            }
            else if (cosine < 0.14 - edge)
            {
                ++inside;
                const bool shines = before[1] > 220;
                EXPECT_TRUE(shines || after[1] < before[1] - 15) << x << ", " << y;
            }
        }
    }
    EXPECT_GT(outside, 1000);
    return inside;
}

TEST(Stripes, LieSquareToAnAxisThatTurnsWithTheSphere)
{
    Numbers numbers;
    for (const Look look : {Look::clean, Look::studio, Look::paper, Look::dark})
    {
        for (const bool cut : {false, true})
        {
            SCOPED_TRACE(static_cast<int>(look) * 2 + (cut ? 1 : 0));
            const OneSphere sphere(look, cut);
            int inside = 0;
            for (const SphereState state :
                 {SphereState::frozen, SphereState::frozen, SphereState::running})
            {
                inside += expectStripe(sphere, anyTurn(numbers), state);
            }
            EXPECT_GT(inside, 200);
        }
    }
}

TEST(Stripes, AreThereBeforeASphereHasTurned)
{
    EXPECT_GT(expectStripe(OneSphere(Look::clean, false), Eigen::Quaterniond::Identity(),
                           SphereState::frozen),
              200);
}

// Run files have columns in the order of their names.
TEST(Stripes, LieTheSameWhicheverWayColumnsStand)
{
    const OneSphere sphere(Look::clean, false);
    Numbers numbers;
    Snapshot snapshot;
    addSphere(snapshot, {0, 0, 0}, kRadius, SphereState::frozen);
    turnSphere(snapshot, 0, anyTurn(numbers));
    const TriangleMesh box = boxMesh({1, 1, 1});
    const Image forwards = test::draw(box, sphere.settings, snapshot);
    std::reverse(snapshot.columns.begin(), snapshot.columns.end());
    const Image backwards = test::draw(box, sphere.settings, snapshot);
    EXPECT_EQ(compareImages(forwards, backwards).largest, 0);
}

TEST(Stripes, MoveOnASphereAtRestThatTurns)
{
    const OneSphere sphere(Look::clean, false);
    Numbers numbers;
    Snapshot snapshot;
    addSphere(snapshot, {0, 0, 0}, kRadius, SphereState::frozen);
    Renderer renderer(boxMesh({1, 1, 1}), sphere.settings);
    for (int i = 0; i < 3; ++i)
    {
        const Eigen::Quaterniond turned = anyTurn(numbers);
        turnSphere(snapshot, 0, turned);
        EXPECT_EQ(compareImages(renderer.draw(snapshot), sphere.drawn(turned, SphereState::frozen))
                      .largest,
                  0);
    }
}

} // namespace
} // namespace frostfill
