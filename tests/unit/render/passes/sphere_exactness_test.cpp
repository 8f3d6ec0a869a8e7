// SPDX-License-Identifier: MIT
// Spheres as OpenGL and as tiles draw them, against a ray caster in double precision.
#include "render/picture/painter_settings.hpp"
#include "render/picture/projected_sphere.hpp"
#include "render/pipeline.hpp"
#include "render/raster/lanes/sample_tile.hpp"
#include "render/raster/spheres/sphere_raster.hpp"
#include "support/drawn_with.hpp"
#include "support/pictures.hpp"
#include "unit/render/passes/ray_caster.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <span>

namespace frostfill
{
namespace
{

using namespace testing_support;
using test::Hit;
using test::Ray;
using test::RayCaster;

/// Spheres about the object's centre [object's half width].
struct Cloud
{
    int count = 60;
    double spread = 1;
    double smallest = 0.02;
    double largest = 0.22;
};

/// What the depths of a picture may be off by [radius].
constexpr double kDepthTolerance = 0.002;

/// What was drawn where: the points that are seen in the middles of pixels, in unit space.
struct Drawn
{
    Framing framing;
    std::vector<SphereInstance> spheres;
    std::vector<std::optional<glm::dvec3>> points; ///< by rows from the top
};

std::vector<SphereInstance> allOf(const SphereDrawList& list)
{
    std::vector<SphereInstance> spheres(list.resting().begin(), list.resting().end());
    spheres.insert(spheres.end(), list.running().begin(), list.running().end());
    return spheres;
}

Drawn drawWithOpenGl(const TriangleMesh& mesh, const RenderSettings& settings,
                     const Snapshot& snapshot)
{
    Pipeline pipeline(mesh, settings);
    Image image;
    pipeline.draw(snapshot, image);
    Drawn drawn{pipeline.framing(), allOf(pipeline.spheres()), {}};
    const RayCaster caster(drawn.framing, settings.size);
    const std::vector<double> depth = pipeline.readDepth();
    for (std::size_t i = 0; i < depth.size(); ++i)
    {
        const auto width = static_cast<std::size_t>(settings.size.width);
        const std::size_t row = i / width;
        drawn.points.push_back(
            depth[i] < 1 ? std::optional(caster.unproject(static_cast<double>(i % width) + 0.5,
                                                          static_cast<double>(row) + 0.5, depth[i]))
                         : std::nullopt);
    }
    return drawn;
}

Drawn drawInTiles(const TriangleMesh& mesh, const RenderSettings& settings,
                  const Snapshot& snapshot)
{
    Viewpoint viewpoint(mesh, settings);
    viewpoint.follow(snapshot);
    const Framing& framing = viewpoint.framing();
    SphereDrawList ledger;
    ledger.update(snapshot, framing, viewpoint.colours());
    Drawn drawn{framing, allOf(ledger), {}};
    const SphereRaster raster(uniformsOf(framing, settings), variantOf(settings, mesh),
                              settings.size, settings.style, 1, 1);
    const SphereProjector projector(framing, settings.size);
    const TileGrid grid(settings.size);
    const RayCaster caster(framing, settings.size);
    const auto width = static_cast<std::size_t>(settings.size.width);
    drawn.points.resize(width * static_cast<std::size_t>(settings.size.height));
    SampleTile tile;
    for (std::size_t t = 0; t < grid.count(); ++t)
    {
        const TilePart part = grid.part(t);
        tile.inverseDepth[0].fill(kNothing);
        for (const SphereInstance& sphere : drawn.spheres)
        {
            raster.draw(sphere, projector.project(sphere).pixels, part, tile);
        }
        const PixelRectangle inside = grid.inPicture(part);
        for (int y = inside.bottom; y < inside.top; ++y)
        {
            for (int x = inside.left; x < inside.right; ++x)
            {
                const double near = tile.inverseDepth[0][static_cast<std::size_t>(
                    (y - part.bottom) * kTileEdge + x - part.left)];
                if (near > kNothing)
                {
                    const int row = settings.size.height - 1 - y;
                    const Ray ray = caster.through(x + 0.5, row + 0.5);
                    // How far ahead of the eye the ray starts, and how much farther it goes.
                    const double from = -(framing.view * glm::dvec4(ray.origin, 1)).z;
                    const double along = -(framing.view * glm::dvec4(ray.direction, 0)).z;
                    const double ahead = framing.orthographic ? -near : 1 / near;
                    drawn.points[static_cast<std::size_t>(row) * width +
                                 static_cast<std::size_t>(x)] =
                        ray.origin + (ahead - from) / along * ray.direction;
                }
            }
        }
    }
    return drawn;
}

void compare(const Drawn& drawn, const RenderSettings& settings)
{
    const RayCaster caster(drawn.framing, settings.size, cutPlanesOf(settings, drawn.framing));
    std::size_t covered = 0;
    std::size_t onEdge = 0;
    std::size_t wrong = 0;
    double worst = 0;
    for (std::size_t i = 0; i < drawn.points.size(); ++i)
    {
        const Ray ray = caster.throughPixel(i);
        const Hit hit = caster.cast(ray, drawn.spheres);
        const bool isHit = hit.isThere();
        if (hit.onEdge)
        {
            ++onEdge;
            continue;
        }
        covered += isHit ? 1 : 0;
        wrong += isHit != drawn.points[i].has_value() ? 1 : 0;
        if (isHit && drawn.points[i])
        {
            const glm::dvec3 exact = ray.origin + hit.distance * ray.direction;
            worst = std::max(worst, glm::length(*drawn.points[i] - exact) / hit.radius);
        }
    }
    EXPECT_GT(covered, 10000U) << "the scene proves little";
    EXPECT_LT(onEdge, covered / 100) << "the scene proves little";
    EXPECT_EQ(wrong, 0U);
    EXPECT_LT(worst, kDepthTolerance) << "depth error over radius";
}

void compare(RenderSettings settings, const Cloud& cloud = {})
{
    settings.style.shell = false;
    settings.style.legend = false;
    settings.samples = 1;
    const TriangleMesh mesh = boxMesh({1, 0.8, 0.6}, {100, -40, 7});
    Snapshot snapshot;
    snapshot.origin = {100, -40, 7};
    Numbers numbers;
    for (int i = 0; i < cloud.count; ++i)
    {
        const Eigen::Vector3d place(2 * numbers.next() - 1, 1.6 * numbers.next() - 0.8,
                                    1.2 * numbers.next() - 0.6);
        const double share = numbers.next() * numbers.next();
        addSphere(snapshot, snapshot.origin + cloud.spread * place,
                  cloud.smallest + share * (cloud.largest - cloud.smallest),
                  static_cast<SphereState>(i % 3));
    }
    if (const std::optional<Backend> openGl = test::openGl())
    {
        SCOPED_TRACE("OpenGL");
        settings.backend = *openGl;
        compare(drawWithOpenGl(mesh, settings, snapshot), settings);
    }
    {
        SCOPED_TRACE("tiles");
        compare(drawInTiles(mesh, settings, snapshot), settings);
    }
}

TEST(SphereExactness, PerspectiveOutlinesAndDepthsAreThoseOfTheRayCaster)
{
    RenderSettings settings;
    settings.size = {320, 240};
    compare(settings);
}

TEST(SphereExactness, OutlinesForPrintChangeNoShape)
{
    RenderSettings settings;
    settings.size = {400, 300};
    settings.style.look = Look::paper;
    compare(settings);
    settings.style.cutaway = {Cutaway::Kind::plane, {0.2, 0.3, 1}, 0.1, 0, 90};
    compare(settings);
}

TEST(SphereExactness, WideAnglesStretchSpheresAsTheyShould)
{
    RenderSettings settings;
    settings.size = {640, 400};
    settings.camera.fieldOfView = 100;
    settings.camera.azimuth = -70;
    compare(settings);
}

TEST(SphereExactness, SpheresOfAMillionAreAsExact)
{
    RenderSettings settings;
    settings.size = {640, 400};
    settings.camera.zoom = 4;
    compare(settings, {700, 0.15, 0.004, 0.012});
}

TEST(SphereExactness, OrthographicOutlinesAndDepthsAreThoseOfTheRayCaster)
{
    RenderSettings settings;
    settings.size = {400, 300};
    settings.camera.orthographic = true;
    settings.camera.elevation = 65;
    compare(settings);
}

TEST(SphereExactness, WhatAPlaneLeavesIsThatOfTheRayCaster)
{
    RenderSettings settings;
    settings.size = {400, 300};
    settings.style.cutaway = {Cutaway::Kind::plane, {0.2, 0.3, 1}, 0.1, 0, 90};
    compare(settings);
    settings.camera.orthographic = true;
    compare(settings);
}

TEST(SphereExactness, WhatAWedgeLeavesIsThatOfTheRayCaster)
{
    RenderSettings settings;
    settings.size = {400, 300};
    settings.style.cutaway = {Cutaway::Kind::wedge, {0, 0, 1}, 0, -20, 100};
    compare(settings);
    settings.camera.orthographic = true;
    settings.camera.elevation = 65;
    compare(settings);
}

TEST(SphereOutline, FourSamplesSmoothTheOutline)
{
    RenderSettings settings;
    settings.backend = test::drawnWith();
    settings.size = {200, 200};
    settings.style.legend = false;
    settings.style.shell = false;
    settings.style.palette.frozen = {0, 0, 0, 255};
    const TriangleMesh mesh = boxMesh({1, 1, 1});
    Snapshot snapshot;
    addSphere(snapshot, {0, 0, 0}, 1, SphereState::frozen);

    // A black disc on white: its area in pixels is the sum of its coverage.
    const auto greys = [&](int samples)
    {
        settings.samples = samples;
        Image image;
        Renderer(mesh, settings).render(snapshot, image);
        std::size_t between = 0;
        for (std::size_t i = 0; i < image.pixels.size(); i += 3)
        {
            between += image.pixels[i] > 110 && image.pixels[i] < 250 ? 1 : 0;
        }
        return between;
    };
    EXPECT_EQ(greys(1), 0U);
    EXPECT_GT(greys(4), 150U);
}

} // namespace
} // namespace frostfill
