// SPDX-License-Identifier: MIT
// The static layer against drawing everything for every picture, which has to give the same bytes.
#include "support/drawn_with.hpp"
#include "support/made_up_run.hpp"

#include <frostfill/error.hpp>
#include <frostfill/renderer.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

namespace frostfill
{
namespace
{

using namespace testing_support;

struct Case
{
    const char* name;
    int samples;
    bool orthographic;
    bool shell;
    int spheres;
    double radius;
    int around = 48; ///< quads of the torus
    Backend backend = Backend::automatic;
};

std::ostream& operator<<(std::ostream& out, const Case& value)
{
    return out << value.name;
}

class StaticLayerTest : public testing::TestWithParam<Case>
{
protected:
    StaticLayerTest()
    {
        settings.size = {300, 200};
        settings.samples = GetParam().samples;
        settings.camera.orthographic = GetParam().orthographic;
        settings.style.shell = GetParam().shell;
        settings.title = "a title that is a good deal wider than the table below it";
        settings.backend =
            GetParam().backend == Backend::automatic ? test::drawnWith() : GetParam().backend;
    }

    void SetUp() override
    {
        if (settings.backend == Backend::automatic)
        {
            return;
        }
        try
        {
            const Renderer renderer(mesh, settings);
        }
        catch (const Error& error)
        {
            GTEST_SKIP() << "this machine lacks the backend: " << error.what();
        }
    }

    void expectSame(const Snapshot& snapshot, const char* when)
    {
        const Image& fast = on->draw(snapshot);
        const Image& slow = off->draw(snapshot);
        const ImageDifference difference = compareImages(fast, slow);
        EXPECT_EQ(difference.largest, 0)
            << when << ": " << difference.pixelsApart << " pixels, step " << snapshot.step;
    }

    void open()
    {
        on = std::make_unique<Renderer>(mesh, settings);
        settings.staticLayer = false;
        off = std::make_unique<Renderer>(mesh, settings);
    }

    TriangleMesh mesh = torusMesh(1, 0.4, GetParam().around, GetParam().around / 3);
    RenderSettings settings;
    std::unique_ptr<Renderer> on;
    std::unique_ptr<Renderer> off;
};

TEST_P(StaticLayerTest, GivesTheBytesOfDrawingEverything)
{
    MadeUpRun run(mesh, GetParam().radius);
    open();
    expectSame(run.snapshot, "nothing");
    run.release(GetParam().spheres);
    expectSame(run.snapshot, "all run");
    run.advance(1, 0, 0);
    expectSame(run.snapshot, "all froze at once");
    for (int frame = 0; frame < 4; ++frame)
    {
        run.release(8);
        run.advance(0.2, 0, 0);
        expectSame(run.snapshot, "some freeze");
        run.advance(0.1, 0.01, 0.01);
        expectSame(run.snapshot, "some are discarded");
        run.advance(0, 0, 0);
        expectSame(run.snapshot, "some run");
    }
    run.advance(0.5, 0.6, 0.7);
    expectSame(run.snapshot, "many are discarded");
}

TEST_P(StaticLayerTest, IsDrawnAnewForAnotherCamera)
{
    MadeUpRun run(mesh, GetParam().radius);
    open();
    run.release(GetParam().spheres);
    run.advance(0.95, 0.3, 0.2);
    Camera camera = settings.camera;
    for (const double zoom : {1.0, 2.5, 9.0})
    {
        camera.azimuth = camera.azimuth.value_or(30) + 47;
        camera.zoom = zoom;
        on->setCamera(camera);
        off->setCamera(camera);
        expectSame(run.snapshot, "another camera");
        run.advance(0.1, 0.02, 0.02);
        expectSame(run.snapshot, "and a frame from there");
    }
}

TEST_P(StaticLayerTest, StartsAgainWhenWhatIsAtRestMovesOrGoes)
{
    MadeUpRun run(mesh, GetParam().radius);
    open();
    run.release(GetParam().spheres);
    run.advance(0.9, 0.3, 0.2);
    expectSame(run.snapshot, "before");
    run.snapshot.centres[3] += Eigen::Vector3f(0.1F, 0.1F, 0);
    expectSame(run.snapshot, "one moved");
    run.snapshot.radii[2] *= 2;
    expectSame(run.snapshot, "one grew");
    std::fill_n(run.snapshot.states.begin(), 10, SphereState::running);
    expectSame(run.snapshot, "some run again");
    MadeUpRun other(mesh, GetParam().radius);
    other.release(5);
    expectSame(other.snapshot, "another run");
}

TEST_P(StaticLayerTest, OutlastsItsMarks)
{
    MadeUpRun run(mesh, GetParam().radius);
    open();
    run.release(30);
    run.advance(0.5, 0, 0);
    for (int frame = 0; frame < 300; ++frame)
    {
        run.snapshot.centres[static_cast<std::size_t>(frame % 30)].y() += 0.001F;
        std::ignore = on->draw(run.snapshot);
    }
    expectSame(run.snapshot, "after 300 frames");
}

TEST_P(StaticLayerTest, WritesOnlyTextThatReadsDifferently)
{
    MadeUpRun run(mesh, GetParam().radius);
    open();
    run.release(5);
    run.advance(1, 0, 0);
    expectSame(run.snapshot, "at first");
    run.snapshot.time += 1;
    expectSame(run.snapshot, "the clock has moved");
    const auto changed = on->changedRows();
    const auto rows =
        std::count_if(changed.begin(), changed.end(), [](auto row) { return row != 0; });
    EXPECT_GT(rows, 0);
    EXPECT_LT(rows, 20) << "of one line";
    run.snapshot.frozen += 1;
    run.snapshot.set += 100000;
    expectSame(run.snapshot, "and numbers have, one of them a good deal wider");
    run.snapshot.set = 1;
    expectSame(run.snapshot, "and narrower again");
}

TEST(LargePictures, AreTheSameWhereNotAllTilesAreKept)
{
    const TriangleMesh mesh = boxMesh({1, 1, 1});
    for (const bool occlusion : {false, true})
    {
        RenderSettings settings;
        settings.size = {2600, 1800}; // more tiles than are kept, and spheres in all
        settings.camera.azimuth = 0;
        settings.camera.elevation = 0;
        settings.camera.zoom = 8;
        settings.style.ambientOcclusion = occlusion;
        Renderer on(mesh, settings);
        settings.staticLayer = false;
        Renderer off(mesh, settings);
        Snapshot snapshot;
        addSphere(snapshot, {0, 0, 0}, 0.9, SphereState::frozen);
        addSphere(snapshot, {0.02, 0, 0.92}, 0.03, SphereState::running);
        const auto expectSame = [&](const char* when)
        { EXPECT_TRUE(on.draw(snapshot).pixels == off.draw(snapshot).pixels) << when; };
        expectSame("at first");
        snapshot.centres[1].x() = -0.02F;
        expectSame("one has moved");
        snapshot.states[1] = SphereState::frozen;
        expectSame("it has come to rest");
        snapshot.states[0] = SphereState::discarded;
        expectSame("the other is discarded");
    }
}

INSTANTIATE_TEST_SUITE_P(Renderer, StaticLayerTest,
                         testing::Values(Case{"OneSample", 1, false, true, 60, 0.1},
                                         Case{"FourSamples", 4, false, true, 60, 0.1},
                                         Case{"Parallel", 1, true, true, 60, 0.1},
                                         Case{"ParallelFourSamples", 4, true, true, 60, 0.1},
                                         Case{"WithoutShell", 1, false, false, 60, 0.1},
                                         Case{"ManySmall", 1, false, true, 4000, 0.02},
                                         Case{"CoarseShell", 4, false, true, 60, 0.05, 12},
                                         Case{"FineShell", 4, false, true, 60, 0.1, 300},
                                         Case{"Egl", 1, false, true, 60, 0.1, 48, Backend::egl},
                                         Case{"EglFourSamples", 4, false, true, 60, 0.1, 48,
                                              Backend::egl},
                                         Case{"ManySmallFourSamples", 4, false, true, 4000, 0.02}),
                         [](const auto& testCase) { return std::string(testCase.param.name); });

} // namespace
} // namespace frostfill
