// SPDX-License-Identifier: MIT
// Any camera, size, zoom and number of samples: the static layer gives the bytes of drawing
// everything, and nothing is read or written beyond the picture (the asan preset would tell).
#include "support/drawn_with.hpp"
#include "support/made_up_run.hpp"

#include <frostfill/renderer.hpp>

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

using namespace testing_support;

/// A camera near, within, far from or beside the torus, and a picture of any shape.
RenderSettings randomSettings(Numbers& numbers)
{
    const auto between = [&](double low, double high)
    { return low + (high - low) * numbers.next(); };
    RenderSettings settings;
    settings.backend = test::drawnWith();
    settings.size = {static_cast<int>(between(1, 250)), static_cast<int>(between(1, 160))};
    settings.samples = numbers.next() < 0.5 ? 1 : 4;
    settings.style.shell = numbers.next() < 0.9;
    settings.style.legend = numbers.next() < 0.5;
    Camera& camera = settings.camera;
    camera.azimuth = between(-180, 180);
    camera.elevation = between(-90, 90);
    camera.fieldOfView = between(5, 110);
    camera.zoom = std::exp2(between(-3, 5));
    camera.orthographic = numbers.next() < 0.3;
    if (numbers.next() < 0.5)
    {
        camera.target = Eigen::Vector3d(between(-2, 2), between(-2, 2), between(-1, 1));
    }
    if (!camera.orthographic && numbers.next() < 0.5)
    {
        camera.distance = between(0.05, 6);
    }
    return settings;
}

void expectLayerEqualsFullDrawing(RenderSettings settings, int seed)
{
    const TriangleMesh mesh = torusMesh(1, 0.4, 24, 8);
    MadeUpRun run(mesh, 0.1);
    run.release(40);
    Renderer on(mesh, settings);
    settings.staticLayer = false;
    Renderer off(mesh, settings);
    for (int frame = 0; frame < 4; ++frame)
    {
        EXPECT_EQ(compareImages(on.draw(run.snapshot), off.draw(run.snapshot)).largest, 0)
            << "camera " << seed << ", frame " << frame;
        run.advance(0.4, 0.1, 0.05);
    }
}

/// Of the cameras drawn from one sequence, those from `first` on and before `end`.
void expectEqualForCameras(int first, int end, Look look = Look::clean)
{
    Numbers numbers;
    for (int camera = 0; camera < end; ++camera)
    {
        RenderSettings settings = randomSettings(numbers);
        settings.style.look = look;
        settings.style.palette = paletteOf(look);
        if (camera >= first)
        {
            expectLayerEqualsFullDrawing(settings, camera);
        }
    }
}

TEST(RandomCameras, EqualsFullDrawingForAnyCameraSizeAndZoom)
{
    expectEqualForCameras(0, 15);
}

TEST(RandomCameras, EqualsFullDrawingInTheStudioToo)
{
    expectEqualForCameras(0, 40, Look::studio);
}

// Nothing else has parts of the picture drawn anew than the shadows of what comes to rest.
TEST(RandomCameras, EqualsFullDrawingWhereSpheresOnlyComeToRestInTheStudio)
{
    const TriangleMesh mesh = torusMesh(1, 0.4, 24, 8);
    MadeUpRun run(mesh, 0.19);
    run.release(12);
    RenderSettings settings;
    settings.backend = test::drawnWith();
    settings.size = {320, 180};
    settings.style.look = Look::studio;
    settings.style.palette = paletteOf(Look::studio);
    settings.camera.elevation = 60;
    Renderer on(mesh, settings);
    settings.staticLayer = false;
    Renderer off(mesh, settings);
    for (int frame = 0; frame < 6; ++frame)
    {
        EXPECT_EQ(compareImages(on.draw(run.snapshot), off.draw(run.snapshot)).largest, 0) << frame;
        run.advance(0.3, 0, 0);
    }
}

// With the label `long`.
TEST(RandomCameras, EqualsFullDrawingForManyMoreCameras)
{
    expectEqualForCameras(15, 60);
}

// The camera of the first crash: parts of the shell that change reach beyond the picture.
TEST(RandomCameras, RepaintsPolygonsAtThePicturesEdge)
{
    RenderSettings settings;
    settings.backend = test::drawnWith();
    settings.size = {320, 180};
    settings.camera.zoom = 2;
    expectLayerEqualsFullDrawing(settings, 0);
}

} // namespace
} // namespace frostfill
