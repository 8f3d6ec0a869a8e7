// SPDX-License-Identifier: MIT
#include "support/drawn_with.hpp"
#include "support/expect_error.hpp"
#include "support/pictures.hpp"
#include "unit/render/draw.hpp"

#include <frostfill/error.hpp>
#include <frostfill/renderer.hpp>

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace frostfill
{
namespace
{

using namespace testing_support;
using test::draw;

Snapshot packOf(const TriangleMesh& mesh, int count)
{
    Snapshot snapshot;
    Numbers numbers;
    for (int i = 0; i < count; ++i)
    {
        const double angle = 6.28 * numbers.next();
        addSphere(snapshot, {std::cos(angle), std::sin(angle), 0.4 * numbers.next() - 0.2}, 0.1,
                  static_cast<SphereState>(i % 3));
    }
    snapshot.polygons.assign(mesh.triangles.size(), PolygonState::active);
    return snapshot;
}

RenderSettings smallSettings()
{
    RenderSettings settings;
    settings.backend = test::drawnWith();
    settings.size = {480, 270};
    settings.title = "torus";
    return settings;
}

bool isColour(const Image& image, int x, int y, const Colour& colour)
{
    const auto* pixel = image.at(x, y);
    return pixel[0] == colour[0] && pixel[1] == colour[1] && pixel[2] == colour[2];
}

class RendererTest : public testing::Test
{
protected:
    TriangleMesh mesh = torusMesh(1, 0.4, 24, 8);
    Snapshot snapshot = packOf(mesh, 60);
};

TEST_F(RendererTest, BackgroundHasItsColourExactly)
{
    RenderSettings settings = smallSettings();
    settings.style.palette.background = {11, 77, 200, 255};
    for (const int samples : {1, 4})
    {
        settings.samples = samples;
        const Image image = draw(mesh, settings, snapshot);
        EXPECT_TRUE(isColour(image, 479, 0, settings.style.palette.background));
        EXPECT_TRUE(isColour(image, 479, 269, settings.style.palette.background));
    }
}

TEST_F(RendererTest, RefusesASizeThatSupersamplingMakesTooLargeForANumber)
{
    RenderSettings settings = smallSettings();
    for (const int times : {60, 1 << 20, 1 << 28, std::numeric_limits<int>::max()})
    {
        settings.supersample = times;
        test::expectError(
            ErrorCode::usage, [&] { const Renderer renderer(mesh, settings); }, "cannot be drawn");
    }
}

TEST_F(RendererTest, SameSnapshotGivesTheSameBytes)
{
    const RenderSettings settings = smallSettings();
    const Image first = draw(mesh, settings, snapshot);
    EXPECT_EQ(draw(mesh, settings, snapshot).pixels, first.pixels);
    Renderer renderer(mesh, settings);
    Image again;
    renderer.render(snapshot, again);
    renderer.render(snapshot, again);
    EXPECT_EQ(again.pixels, first.pixels);
}

TEST_F(RendererTest, RendererThatSawTheChangesDrawsLikeAFreshOne)
{
    const RenderSettings settings = smallSettings();
    Renderer renderer(mesh, settings);
    Image image;
    renderer.render(snapshot, image);

    // Captures may be made without being drawn, so what `changed` lists is not all.
    snapshot.centres[7].x() += 0.05F;
    snapshot.states[30] = SphereState::discarded;
    snapshot.changed = {30};
    addSphere(snapshot, {0, 1, 0}, 0.2, SphereState::running);
    snapshot.polygons[5] = snapshot.polygons[200] = PolygonState::discarded;
    snapshot.discardedPolygons = 2;
    renderer.render(snapshot, image);
    EXPECT_EQ(image.pixels, draw(mesh, settings, snapshot).pixels);

    // Fewer spheres than before, as when another run is drawn.
    const Snapshot other = packOf(mesh, 10);
    renderer.render(other, image);
    EXPECT_EQ(image.pixels, draw(mesh, settings, other).pixels);
}

TEST_F(RendererTest, TwoRenderersTakeTurnsInOneThread)
{
    const RenderSettings settings = smallSettings();
    const Image alone = draw(mesh, settings, snapshot);
    Renderer first(mesh, settings);
    Renderer second(boxMesh({1, 1, 1}), settings);
    Image image;
    second.render(Snapshot{}, image);
    first.render(snapshot, image);
    EXPECT_EQ(image.pixels, alone.pixels);
}

TEST_F(RendererTest, PositionsAreRelativeToTheSnapshotsOrigin)
{
    const RenderSettings settings = smallSettings();
    const Image expected = draw(mesh, settings, snapshot);
    TriangleMesh moved = mesh;
    for (Eigen::Vector3d& vertex : moved.vertices)
    {
        vertex += Eigen::Vector3d(4096, -8192, 1024);
    }
    snapshot.origin = {4096, -8192, 1024};
    const ImageDifference difference = compareImages(draw(moved, settings, snapshot), expected);
    EXPECT_LT(difference.rootMeanSquare, 0.2);
}

TEST_F(RendererTest, DiscardedPolygonsShow)
{
    const RenderSettings settings = smallSettings();
    const Image before = draw(mesh, settings, snapshot);
    snapshot.polygons.assign(mesh.triangles.size(), PolygonState::discarded);
    EXPECT_GT(compareImages(before, draw(mesh, settings, snapshot)).pixelsApart, 5000U);
}

TEST_F(RendererTest, LegendIsOnlyThereWhenAskedFor)
{
    RenderSettings settings = smallSettings();
    const auto inkOnTheLeft = [&](const Image& image)
    {
        int ink = 0;
        for (int y = 0; y < image.height; ++y)
        {
            for (int x = 0; x < 60; ++x)
            {
                ink += isColour(image, x, y, settings.style.palette.background) ? 0 : 1;
            }
        }
        return ink;
    };
    EXPECT_GT(inkOnTheLeft(draw(mesh, settings, snapshot)), 300);
    settings.style.legend = false;
    EXPECT_EQ(inkOnTheLeft(draw(mesh, settings, snapshot)), 0);
}

TEST_F(RendererTest, LegendDoesNotMeetTheObject)
{
    for (const PictureSize& size : {PictureSize{1280, 720}, PictureSize{600, 900}, {480, 270}})
    {
        RenderSettings settings = smallSettings();
        settings.size = size;
        settings.title = "a title that is rather longer than all the rest of the legend is wide";
        Snapshot nothing;
        const Image with = draw(mesh, settings, nothing);
        settings.style.shell = false;
        const Image legendOnly = draw(mesh, settings, nothing);
        settings.style.shell = true;
        settings.style.palette.text = settings.style.palette.background;
        const Image withoutText = draw(mesh, settings, nothing);
        // Text in the colour of the background would cut into an object behind it.
        for (int y = 0; y < size.height; ++y)
        {
            for (int x = 0; x < size.width; ++x)
            {
                const bool text = !isColour(legendOnly, x, y, settings.style.palette.background);
                const bool object = !isColour(withoutText, x, y, settings.style.palette.background);
                const bool swatch = text && object;
                ASSERT_TRUE(!swatch || x < size.width / 8) << x << ' ' << y;
            }
        }
    }
}

TEST_F(RendererTest, EverySizeWorks)
{
    for (const PictureSize& size : {PictureSize{1, 1}, {160, 90}, {3, 500}, {500, 3}, {1280, 720}})
    {
        RenderSettings settings = smallSettings();
        settings.size = size;
        const Image image = draw(mesh, settings, snapshot);
        EXPECT_EQ(image.width, size.width);
        EXPECT_EQ(image.height, size.height);
        EXPECT_EQ(image.channels, 3);
        EXPECT_EQ(image.pixels.size(), static_cast<std::size_t>(3 * size.width * size.height));
    }
}

TEST_F(RendererTest, ImpossibleSettingsAreUsageErrors)
{
    const auto refused = [&](auto change)
    {
        RenderSettings settings = smallSettings();
        change(settings);
        try
        {
            const Renderer renderer(mesh, settings);
        }
        catch (const Error& error)
        {
            return error.code() == ErrorCode::usage;
        }
        return false;
    };
    EXPECT_TRUE(refused([](RenderSettings& s) { s.size = {0, 10}; }));
    EXPECT_TRUE(refused([](RenderSettings& s) { s.size = {10, -1}; }));
    EXPECT_TRUE(refused([](RenderSettings& s) { s.size = {20000, 16}; }));
    EXPECT_TRUE(refused([](RenderSettings& s) { s.samples = 0; }));
    EXPECT_TRUE(refused([](RenderSettings& s) { s.samples = 8; }));
    // A failure leaves nothing behind that keeps the next from working.
    EXPECT_EQ(draw(mesh, smallSettings(), snapshot).width, 480);
}

TEST_F(RendererTest, EmptySnapshotAndEmptyMeshAreDrawn)
{
    EXPECT_EQ(draw(mesh, smallSettings(), Snapshot{}).width, 480);
    EXPECT_EQ(draw(TriangleMesh{}, smallSettings(), Snapshot{}).width, 480);
}

TEST_F(RendererTest, TimeIsCountedByStage)
{
    Renderer renderer(mesh, smallSettings());
    EXPECT_EQ(renderer.times()[Stage::rendering], 0);
    Image image;
    renderer.render(snapshot, image);
    const StageTimes once = renderer.times();
    EXPECT_GT(once[Stage::rendering], 0);
    EXPECT_GT(once[Stage::readback], 0);
    renderer.render(snapshot, image);
    EXPECT_GT(renderer.times()[Stage::rendering], once[Stage::rendering]);
}

} // namespace
} // namespace frostfill
