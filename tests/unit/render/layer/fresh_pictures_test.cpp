// SPDX-License-Identifier: MIT
// Pictures of a renderer that has drawn others before, against one that draws its first: what is
// kept from picture to picture changes no byte.
#include "support/drawn_with.hpp"
#include "support/pictures.hpp"
#include "unit/render/draw.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace frostfill
{
namespace
{

using namespace testing_support;

/// Spheres side by side that do not touch: which of two is drawn first does not matter.
Snapshot grid(int along, SphereState state)
{
    Snapshot snapshot;
    for (int i = 0; i < along * along * along; ++i)
    {
        const Eigen::Array3d place(i % along, i / along % along, i / along / along);
        addSphere(snapshot, 1.8 * (place + 0.5) / along - 0.9, 0.6 / along, state);
    }
    return snapshot;
}

void setAll(Snapshot& snapshot, SphereState state)
{
    std::fill(snapshot.states.begin(), snapshot.states.end(), state);
    const std::size_t all = snapshot.states.size();
    snapshot.running = state == SphereState::running ? all : 0;
    snapshot.frozen = state == SphereState::frozen ? all : 0;
    snapshot.discarded = state == SphereState::discarded ? all : 0;
}

class FreshPictures : public ::testing::TestWithParam<Look>
{
protected:
    FreshPictures()
    {
        settings_.backend = test::drawnWith();
        settings_.style.shell = true;
    }
    void expectFresh(Renderer& renderer, const Snapshot& snapshot, const char* when) const
    {
        const ImageDifference difference =
            compareImages(renderer.draw(snapshot), test::draw(mesh_, settings_, snapshot));
        EXPECT_EQ(difference.largest, 0) << when << ": " << difference.pixelsApart << " pixels";
    }
    TriangleMesh mesh_ = boxMesh({1, 1, 1});
    RenderSettings settings_ = smallPicture(GetParam());
};

// As --rest joint does when all has come to rest.
TEST_P(FreshPictures, AreDrawnWhenAllThatRestedRunsAgain)
{
    Renderer renderer(mesh_, settings_);
    Snapshot snapshot = grid(4, SphereState::frozen);
    const Snapshot rested = snapshot;
    expectFresh(renderer, snapshot, "all rest");
    setAll(snapshot, SphereState::running);
    expectFresh(renderer, snapshot, "all run where they rested");
    for (Eigen::Vector3f& centre : snapshot.centres)
    {
        centre += Eigen::Vector3f(0.13F, -0.07F, 0.04F);
    }
    expectFresh(renderer, snapshot, "all run elsewhere");
    for (std::size_t i = 0; i < 12; ++i) // so few are in no cell of any grid
    {
        snapshot.states[5 * i] = SphereState::frozen;
        expectFresh(renderer, snapshot, "one more rests");
    }
    snapshot = rested;
    expectFresh(renderer, snapshot, "all rest where they did");
    snapshot.resize(0);
    expectFresh(renderer, snapshot, "none is left");
    expectFresh(renderer, rested, "all are there again");
}

TEST_P(FreshPictures, AreDrawnOfOlderSnapshotsAfterNewerOnes)
{
    Snapshot before = grid(4, SphereState::running);
    before.source = 7;
    before.revision = 3;
    Snapshot after = before;
    after.revision = 5;
    after.changedSince = 3;
    for (std::size_t i = 0; i < after.states.size(); i += 2)
    {
        after.states[i] = i % 3 == 0 ? SphereState::discarded : SphereState::frozen;
        after.centres[i].y() -= 0.05F;
    }
    before.changed = {1, 3}; // since a state before that
    before.changedSince = 2;
    Renderer renderer(mesh_, settings_);
    expectFresh(renderer, before, "the older one");
    expectFresh(renderer, after, "the newer one");
    expectFresh(renderer, before, "the older one again");
    expectFresh(renderer, after, "the newer one again");
}

INSTANTIATE_TEST_SUITE_P(InEveryLook, FreshPictures,
                         ::testing::Values(Look::clean, Look::paper, Look::studio));

} // namespace
} // namespace frostfill
