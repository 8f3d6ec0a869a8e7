// SPDX-License-Identifier: MIT
// Depth, normals, identities, and what of light neighbours keep off by them, as OpenGL and as tiles
// draw them, against a ray caster.
#include "render/picture/surfaces.hpp"

#include "render/picture/painter_settings.hpp"
#include "render/pipeline.hpp"
#include "render/raster/tile_pipeline.hpp"
#include "support/drawn_with.hpp"
#include "support/expect_error.hpp"
#include "support/pictures.hpp"
#include "unit/render/passes/ray_caster.hpp"

#include <glm/mat3x3.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

using namespace testing_support;

/// What distances may be off by [radius].
constexpr double kDepthOfSurface = 0.002;

/// Spheres of all states in and around a box far from the origin, and one that waits.
Snapshot cloud(const Eigen::Vector3d& middle, int count, double smallest, double largest)
{
    Snapshot snapshot;
    snapshot.origin = middle;
    Numbers numbers;
    for (int i = 0; i < count; ++i)
    {
        const Eigen::Vector3d place(2 * numbers.next() - 1, 1.6 * numbers.next() - 0.8,
                                    1.2 * numbers.next() - 0.6);
        addSphere(snapshot, middle + place, smallest + (largest - smallest) * numbers.next(),
                  static_cast<SphereState>(i % 3));
    }
    return snapshot;
}

struct Apart
{
    std::size_t covered = 0;
    std::size_t wrong = 0; ///< another sphere, or none
    double distance = 0;   ///< [radius]
    double normal = 0;     ///< [1 / 255 of -1..1]
    std::size_t onEdge = 0;
    std::size_t doubtful = 0; ///< where spheres overlap, a cut shows any of them
};

/// What the ray caster has found in a pixel, in place of what was drawn.
void put(const test::Hit& hit, double ahead, const glm::dvec3& normal, std::size_t i,
         Surfaces& surfaces)
{
    surfaces.distance[i] = hit.isThere() ? static_cast<float>(ahead) : Surfaces::kNothing;
    surfaces.identity[i] = hit.isThere() ? static_cast<std::uint32_t>(hit.sphere + 1) : 0;
    for (int c = 0; c < 3; ++c)
    {
        surfaces.normal[i][static_cast<std::size_t>(c)] =
            static_cast<std::uint8_t>(hit.isThere() ? std::lround(127.5 + 127.5 * normal[c]) : 0);
    }
}

Apart apartFromRays(const Surfaces& surfaces, const Framing& framing,
                    const RenderSettings& settings, const Snapshot& snapshot)
{
    const PictureSize size{surfaces.width, surfaces.height};
    const test::RayCaster caster(framing, size, cutPlanesOf(settings, framing));
    const std::vector<SphereInstance> spheres = placeSpheres(snapshot, framing);
    const glm::dmat3 toEye(framing.view);
    Apart apart;
    Surfaces exact = surfaces;
    for (std::size_t i = 0; i < surfaces.distance.size(); ++i)
    {
        const test::Ray ray = caster.throughPixel(i);
        const test::Hit hit = caster.cast(ray, spheres);
        const glm::dvec3 point = ray.origin + (hit.isThere() ? hit.distance : 0) * ray.direction;
        const double ahead = -(framing.view * glm::dvec4(point, 1)).z;
        const glm::dvec3 normal = toEye * hit.normal;
        if (!hit.isDoubtful)
        {
            put(hit, ahead, normal, i, exact);
        }
        if (hit.onEdge || hit.isDoubtful)
        {
            ++(hit.onEdge ? apart.onEdge : apart.doubtful);
            continue;
        }
        const std::size_t identity = hit.isThere() ? hit.sphere + 1 : 0;
        if (identity != surfaces.identity[i])
        {
            ++apart.wrong;
            continue;
        }
        if (!hit.isThere())
        {
            apart.wrong += surfaces.distance[i] != Surfaces::kNothing ? 1 : 0;
            continue;
        }
        ++apart.covered;
        apart.distance =
            std::max(apart.distance, std::abs(double{surfaces.distance[i]} - ahead) / hit.radius);
        for (int c = 0; c < 3; ++c)
        {
            const double own = surfaces.normal[i][static_cast<std::size_t>(c)];
            apart.normal = std::max(apart.normal, std::abs(own - (127.5 + 127.5 * normal[c])));
        }
    }
    return apart;
}

void expectThoseOfTheRayCaster(const RenderSettings& settings, int count = 60,
                               double smallest = 0.02, double largest = 0.22)
{
    const Eigen::Vector3d middle(100, -40, 7);
    const TriangleMesh mesh = boxMesh({1, 0.8, 0.6}, middle);
    const Snapshot snapshot = cloud(middle, count, smallest, largest);
    const PictureSize size{240, 160}; // not that of the picture
    const auto expect = [&](auto&& pipeline, const Framing& framing)
    {
        Surfaces surfaces;
        pipeline.drawSurfaces(snapshot, size, surfaces);
        const Apart apart = apartFromRays(surfaces, framing, settings, snapshot);
        EXPECT_GT(apart.covered, 4000U) << "the scene proves little";
        EXPECT_LT(apart.onEdge, apart.covered / 50) << "the scene proves little";
        EXPECT_LT(apart.doubtful, apart.covered / 7) << "the scene proves little";
        EXPECT_EQ(apart.wrong, 0U);
        EXPECT_LT(apart.distance, kDepthOfSurface);
        EXPECT_LE(apart.normal, 0.52); // half is rounding
    };
    if (const std::optional<Backend> openGl = test::openGl())
    {
        SCOPED_TRACE("OpenGL");
        RenderSettings own = settings;
        own.backend = *openGl;
        Pipeline pipeline(mesh, own);
        expect(pipeline, pipeline.framing());
    }
    {
        SCOPED_TRACE("tiles");
        TilePipeline pipeline(mesh, settings);
        expect(pipeline, pipeline.framing());
    }
}

TEST(SurfacesAgainstRays, AreExactInPerspectiveAndWithout)
{
    for (const int samples : {1, 4})
    {
        for (const bool orthographic : {false, true})
        {
            RenderSettings settings;
            settings.samples = samples;
            settings.camera.orthographic = orthographic;
            expectThoseOfTheRayCaster(settings);
        }
    }
}

TEST(SurfacesAgainstRays, AreExactOnCuts)
{
    for (const Cutaway& cutaway : {Cutaway{Cutaway::Kind::plane, {0.3, 0.2, 1}, 0.05, 0, 90},
                                   Cutaway{Cutaway::Kind::wedge, {0, 0, 1}, 0, -20, 100}})
    {
        for (const bool orthographic : {false, true})
        {
            RenderSettings settings;
            settings.style.cutaway = cutaway;
            settings.camera.orthographic = orthographic;
            expectThoseOfTheRayCaster(settings);
        }
    }
}

TEST(SurfacesAgainstRays, AreExactWhereThousandsHideEachOther)
{
    expectThoseOfTheRayCaster({}, 3000, 0.01, 0.06);
}

TEST(SurfacesAgainstRays, ShowNoSphereThatWaits)
{
    const TriangleMesh mesh = boxMesh({1, 1, 1});
    Snapshot snapshot;
    addSphere(snapshot, {0, 0, 0}, 0.5, SphereState::running);
    snapshot.waiting = {1};
    for (const Backend backend : test::backends())
    {
        RenderSettings settings;
        settings.backend = backend;
        PassPictures pictures;
        Renderer(mesh, settings).renderPasses(snapshot, pictures);
        for (const std::uint8_t value : pictures.identity.pixels)
        {
            ASSERT_EQ(value, 0);
        }
    }
}

TEST(PassPictures, RefuseIdentitiesThatDoNotFitUnlessNoneIsWanted)
{
    Surfaces surfaces;
    surfaces.width = surfaces.height = 1;
    surfaces.distance = {0.5F};
    surfaces.normal = {{128, 128, 255}};
    surfaces.identity = {0xffffff};
    const TilePipeline pipeline(boxMesh({1, 1, 1}), smallPicture(Look::clean));
    const Framing& framing = pipeline.framing();
    PassPictures pictures;
    makePassPictures(surfaces, framing, pictures);
    EXPECT_EQ(pictures.identity.pixels, (std::vector<std::uint8_t>{255, 255, 255}));
    surfaces.identity = {0x1000000};
    test::expectError(
        ErrorCode::usage, [&] { makePassPictures(surfaces, framing, pictures); },
        "omit identity from frames.passes");
    pictures.withIdentity = false;
    makePassPictures(surfaces, framing, pictures);
    EXPECT_EQ(pictures.normal.pixels, (std::vector<std::uint8_t>{128, 128, 255}));
}

} // namespace
} // namespace frostfill
