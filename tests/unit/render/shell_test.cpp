// SPDX-License-Identifier: MIT
// The shell: clean lines however small its triangles are in the picture.
#include "support/drawn_with.hpp"
#include "support/pictures.hpp"
#include "unit/render/draw.hpp"

#include <frostfill/renderer.hpp>
#include <frostfill/shell.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace frostfill
{
namespace
{

using namespace testing_support;
using test::draw;

RenderSettings shellSettings()
{
    RenderSettings settings;
    settings.backend = test::drawnWith();
    settings.size = {320, 180};
    settings.style.legend = false;
    return settings;
}

int brightness(const Image& image, int x, int y)
{
    const std::uint8_t* pixel = image.at(x, y);
    return pixel[0] + pixel[1] + pixel[2];
}

/// Pixels that stand out from both neighbours in a row by much: dots and ends of dashes, and lines
/// that cross the row.
int specks(const Image& image)
{
    int count = 0;
    for (int y = 1; y + 1 < image.height; ++y)
    {
        for (int x = 1; x + 1 < image.width; ++x)
        {
            const int own = brightness(image, x, y);
            const int left = own - brightness(image, x - 1, y);
            const int right = own - brightness(image, x + 1, y);
            count += left * right > 0 && std::min(std::abs(left), std::abs(right)) > 40 ? 1 : 0;
        }
    }
    return count;
}

TEST(Shell, IsCloseToAPictureOfManySamplesAtAnyNumberOfTriangles)
{
    for (const int around : {24, 96, 400, 900})
    {
        const TriangleMesh mesh = torusMesh(1, 0.4, around, around / 3);
        Snapshot snapshot;
        for (const auto& triangle : mesh.triangles)
        {
            snapshot.polygons.push_back(mesh.vertices[triangle[0]].x() < 0 ? PolygonState::discarded
                                                                           : PolygonState::active);
        }
        RenderSettings settings = shellSettings();
        settings.supersample = 8; // with 4 samples each: 256
        const Image reference = draw(mesh, settings, snapshot);
        settings.supersample = 1;
        for (const int samples : {1, 4})
        {
            settings.samples = samples;
            const ImageDifference apart = compareImages(draw(mesh, settings, snapshot), reference);
            RecordProperty("rms_" + std::to_string(around) + "_" + std::to_string(samples),
                           std::to_string(apart.rootMeanSquare));
            const double bar = mesh.triangles.size() > kShellTriangles ? 4 : 2.5; // if simplified
            EXPECT_LT(apart.rootMeanSquare, samples == 4 ? bar : 5.5)
                << around << " quads around, " << samples << " samples";
        }
    }
}

TEST(Shell, HasNoStippleWhereTrianglesAreSmallerThanPixels)
{
    const Image fine = draw(torusMesh(1, 0.4, 900, 300), shellSettings());
    RenderSettings lines = shellSettings();
    lines.style.edges = EdgeLines::on;
    const Image all = draw(torusMesh(1, 0.4, 900, 300), lines);
    // What is left are the outlines, which cross each row a few times.
    EXPECT_LT(specks(fine), 700);
    EXPECT_LT(specks(all), 700) << "edges that have no room are not drawn";
    EXPECT_LT(compareImages(all, fine).rootMeanSquare, 4) << "a simplified shell";
}

TEST(Shell, HasItsEdgesWhereTrianglesAreLarge)
{
    const TriangleMesh mesh = torusMesh(1, 0.4, 24, 8);
    RenderSettings settings = shellSettings();
    const int automatic = specks(draw(mesh, settings));
    settings.style.edges = EdgeLines::off;
    const int off = specks(draw(mesh, settings));
    EXPECT_GT(automatic, off + 200);
}

TEST(Shell, KeepsItsCreasesWithoutEdgesAndWithTrianglesSmallerThanALine)
{
    RenderSettings settings = shellSettings();
    settings.camera.azimuth = 30;
    settings.camera.elevation = 20;
    settings.style.edges = EdgeLines::off;
    const Image coarse = draw(boxMesh({1, 1, 1}), settings);
    const Image fine = draw(shapes::box({-1, -1, -1}, {1, 1, 1}, 60), settings);
    const ImageDifference apart = compareImages(coarse, fine);
    EXPECT_LT(apart.rootMeanSquare, 6);
    EXPECT_GT(specks(fine), specks(coarse) / 2);
}

TEST(Shell, HidesMoreTheMoreOpaqueItIs)
{
    const TriangleMesh mesh = boxMesh({1, 1, 1});
    RenderSettings settings = shellSettings();
    double before = 3 * 256;
    for (const double opacity : {0.0, 0.3, 0.7, 1.0})
    {
        settings.style.shellOpacity = opacity;
        const Image image = draw(mesh, settings);
        double sum = 0;
        for (const std::uint8_t value : image.pixels)
        {
            sum += value;
        }
        const double now = sum / (image.width * image.height);
        EXPECT_LT(now, before - 5) << opacity;
        before = now;
    }
}

// Lines are darker than the surface beside them, in its own colour.
TEST(Shell, HasItsLinesInTheColourOfThePolygons)
{
    const TriangleMesh mesh = boxMesh({1, 1, 1});
    RenderSettings settings = shellSettings();
    settings.style.palette.activePolygon = {0, 200, 0, 100};
    settings.style.palette.discardedPolygon = {200, 0, 0, 100};
    Snapshot snapshot;
    for (const Backend backend : test::backends())
    {
        settings.backend = backend;
        for (const PolygonState state : {PolygonState::active, PolygonState::discarded})
        {
            snapshot.polygons.assign(mesh.triangles.size(), state);
            const Image image = draw(mesh, settings, snapshot);
            const std::size_t own = state == PolygonState::active ? 1 : 0;
            int least = 255;
            for (std::size_t i = 0; i < image.pixels.size(); i += 3)
            {
                ASSERT_GE(image.pixels[i + own] + 1, image.pixels[i + 1 - own]);
                least = std::min(least, int{image.pixels[i + 1 - own]});
            }
            EXPECT_LT(least, 100); // there are lines
        }
    }
}

TEST(Shell, OfDiscardedPolygonsLeavesTheSpheresBehindItAsTheyAre)
{
    const TriangleMesh mesh = boxMesh({1, 1, 1});
    RenderSettings settings = shellSettings();
    settings.camera.azimuth = 0;
    settings.camera.elevation = 0;
    Snapshot snapshot;
    addSphere(snapshot, {0, 0, 0}, 0.6, SphereState::discarded);
    snapshot.polygons.assign(mesh.triangles.size(), PolygonState::discarded);
    const Image seen = draw(mesh, settings, snapshot);
    settings.style.shell = false;
    const Image bare = draw(mesh, settings, snapshot);
    for (int x = 145; x < 175; ++x)
    {
        EXPECT_LT(std::abs(brightness(seen, x, 90) - brightness(bare, x, 90)), 45) << x;
    }
}

} // namespace
} // namespace frostfill
