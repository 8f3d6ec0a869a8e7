// SPDX-License-Identifier: MIT
#include "render/framing/framing.hpp"

#include "support/pictures.hpp"

#include <frostfill/error.hpp>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

using namespace testing_support;

/// Where a vertex lands [pixel, from the upper left corner; z is window depth].
glm::dvec3 project(const Framing& framing, const PictureSize& size, const Eigen::Vector3d& vertex)
{
    const glm::dvec4 clip =
        framing.projection * framing.view * glm::dvec4(framing.toUnit(vertex), 1);
    return {(clip.x / clip.w + 1) / 2 * size.width, (1 - clip.y / clip.w) / 2 * size.height,
            (clip.z / clip.w + 1) / 2};
}

struct Bounds
{
    glm::dvec3 low{1e9};
    glm::dvec3 high{-1e9};
};

Bounds boundsOf(const Framing& framing, const PictureSize& size, const TriangleMesh& mesh)
{
    Bounds bounds;
    for (const Eigen::Vector3d& vertex : mesh.vertices)
    {
        const glm::dvec3 place = project(framing, size, vertex);
        bounds.low = glm::min(bounds.low, place);
        bounds.high = glm::max(bounds.high, place);
    }
    return bounds;
}

TEST(Framing, EveryObjectFillsItsRegionFromEverySideAndWithEveryUp)
{
    const PictureRegion region{200, 40, 640, 360};
    for (const Eigen::Vector3d& half :
         {Eigen::Vector3d(1, 9, 1), Eigen::Vector3d(9, 1, 1), Eigen::Vector3d(1e-6, 2e-6, 1e-6)})
    {
        const TriangleMesh mesh = boxMesh(half, {5, -3, 2});
        for (const Eigen::Vector3d& up :
             {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, 0, 1),
              Eigen::Vector3d(0, -1, 0), Eigen::Vector3d(1, 1, 1).normalized().eval()})
        {
            for (const double azimuth : {0.0, 30.0, 200.0})
            {
                for (const double elevation : {-90.0, 0.0, 20.0, 90.0})
                {
                    for (const bool orthographic : {false, true})
                    {
                        RenderSettings settings;
                        settings.size = {640, 360};
                        settings.up = up;
                        settings.camera.azimuth = azimuth;
                        settings.camera.elevation = elevation;
                        settings.camera.orthographic = orthographic;
                        const Framing framing = frame(mesh.vertices, settings, region);
                        const Bounds bounds = boundsOf(framing, settings.size, mesh);
                        ASSERT_GE(bounds.low.x, region.left);
                        ASSERT_GE(bounds.low.y, region.top);
                        ASSERT_LE(bounds.high.x, region.right);
                        ASSERT_LE(bounds.high.y, region.bottom);
                        ASSERT_GT(bounds.low.z, 0);
                        ASSERT_LT(bounds.high.z, 1);
                        const double wide = (bounds.high.x - bounds.low.x) / 440;
                        const double tall = (bounds.high.y - bounds.low.y) / 320;
                        ASSERT_GT(std::max(wide, tall), 0.9);
                    }
                }
            }
        }
    }
}

TEST(Framing, UpIsUpAndAzimuthTurnsAboutIt)
{
    const TriangleMesh mesh = boxMesh({1, 1, 1});
    RenderSettings settings;
    settings.camera.azimuth = 0;
    settings.camera.elevation = 0;
    const auto at = [&](const Eigen::Vector3d& point)
    {
        const Framing framing = frame(mesh.vertices, settings, {0, 0, 1280, 720});
        return project(framing, settings.size, point);
    };
    const Eigen::Vector3d middle(0, 0, 0);
    EXPECT_LT(at({0, 0.5, 0}).y, at(middle).y - 50);
    EXPECT_GT(at({0.5, 0, 0}).x, at(middle).x + 50);
    EXPECT_LT(at({0, 0, 0.5}).z, at(middle).z);

    settings.up = {0, 0, 1}; // as in CAD: x to the right, y away from the viewer
    EXPECT_LT(at({0, 0, 0.5}).y, at(middle).y - 50);
    EXPECT_GT(at({0.5, 0, 0}).x, at(middle).x + 50);
    EXPECT_GT(at({0, 0.5, 0}).z, at(middle).z);

    settings.up = {0, 1, 0};
    settings.camera.azimuth = 90; // the viewer has gone round to the right
    EXPECT_LT(at({0.5, 0, 0}).z, at(middle).z);
    settings.camera.elevation = 90;
    EXPECT_LT(at({0, 0.5, 0}).z, at(middle).z);
}

TEST(Framing, ZoomEnlargesAboutTheMiddle)
{
    const TriangleMesh mesh = boxMesh({1, 2, 3});
    RenderSettings settings;
    settings.size = {600, 400};
    const auto extentAt = [&](double zoom)
    {
        settings.camera.zoom = zoom;
        const Bounds bounds =
            boundsOf(frame(mesh.vertices, settings, {0, 0, 600, 400}), settings.size, mesh);
        return bounds.high - bounds.low;
    };
    for (const bool orthographic : {false, true})
    {
        settings.camera.orthographic = orthographic;
        for (const double zoom : {2.0, 0.5})
        {
            EXPECT_NEAR(extentAt(zoom).x / extentAt(1).x, zoom, 1e-9);
            EXPECT_NEAR(extentAt(zoom).y / extentAt(1).y, zoom, 1e-9);
        }
    }
}

TEST(Framing, TargetIsInTheMiddleAndEverythingStillFits)
{
    const TriangleMesh mesh = boxMesh({1, 1, 1}, {10, 0, 0});
    RenderSettings settings;
    settings.camera.target = Eigen::Vector3d(10.7, 0.4, 0);
    for (const bool orthographic : {false, true})
    {
        settings.camera.orthographic = orthographic;
        const Framing framing = frame(mesh.vertices, settings, {0, 0, 1280, 720});
        const glm::dvec3 place = project(framing, settings.size, *settings.camera.target);
        EXPECT_NEAR(place.x, 640, 1e-6);
        EXPECT_NEAR(place.y, 360, 1e-6);
        const Bounds bounds = boundsOf(framing, settings.size, mesh);
        EXPECT_GE(bounds.low.y, 0);
        EXPECT_LE(bounds.high.y, 720);
    }
}

TEST(Framing, HeightAndDistanceRunFromZeroToOne)
{
    const TriangleMesh mesh = boxMesh({1, 2, 3}, {4, 5, 6});
    for (const bool orthographic : {false, true})
    {
        RenderSettings settings;
        settings.camera.orthographic = orthographic;
        settings.camera.target = Eigen::Vector3d(4.5, 5, 6);
        const Framing framing = frame(mesh.vertices, settings, {0, 0, 1280, 720});
        double nearest = 1e9;
        double furthest = -1e9;
        for (const Eigen::Vector3d& vertex : mesh.vertices)
        {
            const glm::dvec4 eye = framing.view * glm::dvec4(framing.toUnit(vertex), 1);
            EXPECT_NEAR(glm::dot(framing.heightPlane, eye), (vertex.y() - 3) / 4, 1e-9);
            nearest = std::min(nearest, glm::dot(framing.distancePlane, eye));
            furthest = std::max(furthest, glm::dot(framing.distancePlane, eye));
        }
        EXPECT_NEAR(nearest, 0, 1e-9);
        EXPECT_NEAR(furthest, 1, 1e-9);
    }
}

TEST(Framing, CamerasThatMakeNoSenseAreRefused)
{
    const TriangleMesh mesh = boxMesh({1, 1, 1});
    const auto refused = [&](auto change)
    {
        RenderSettings settings;
        change(settings);
        try
        {
            (void)frame(mesh.vertices, settings, {0, 0, 1280, 720});
        }
        catch (const Error& error)
        {
            return error.code() == ErrorCode::usage;
        }
        return false;
    };
    EXPECT_TRUE(refused([](RenderSettings& s) { s.camera.elevation = 91; }));
    EXPECT_TRUE(refused([](RenderSettings& s) { s.camera.fieldOfView = 0; }));
    EXPECT_TRUE(refused([](RenderSettings& s) { s.camera.zoom = 0; }));
    EXPECT_TRUE(refused([](RenderSettings& s) { s.camera.azimuth = std::nan(""); }));
    EXPECT_TRUE(refused([](RenderSettings& s) { s.up.setZero(); }));
}

TEST(Framing, OnATurntableEverythingFitsAtEveryAngleFromTheSameDistance)
{
    const TriangleMesh mesh = boxMesh({1, 2, 0.3}, {4, 5, 6});
    for (const bool orthographic : {false, true})
    {
        RenderSettings settings;
        settings.size = {640, 360};
        settings.camera.turntable = 5;
        settings.camera.orthographic = orthographic;
        const Framing still = frame(mesh.vertices, settings, {0, 0, 640, 360});
        double widest = 0;
        for (int degrees = 0; degrees < 360; degrees += 10)
        {
            const Framing framing = revolved(still, settings.up, degrees);
            const Bounds bounds = boundsOf(framing, settings.size, mesh);
            ASSERT_GE(bounds.low.x, 0) << degrees;
            ASSERT_GE(bounds.low.y, 0) << degrees;
            ASSERT_LE(bounds.high.x, 640) << degrees;
            ASSERT_LE(bounds.high.y, 360) << degrees;
            ASSERT_GT(bounds.low.z, 0) << degrees;
            ASSERT_LT(bounds.high.z, 1) << degrees;
            widest = std::max(widest, (bounds.high.y - bounds.low.y) / 360);
        }
        EXPECT_GT(widest, 0.85);
    }
}

TEST(Framing, TurningIsLookingFromAnotherAzimuth)
{
    const TriangleMesh mesh = boxMesh({1, 2, 0.3}, {4, 5, 6});
    RenderSettings settings;
    settings.size = {640, 360};
    settings.camera.target = Eigen::Vector3d(4.4, 5.1, 6);
    settings.camera.turntable = 5;
    const Framing turned =
        revolved(frame(mesh.vertices, settings, {0, 0, 640, 360}), settings.up, 70);
    settings.camera.azimuth = settings.camera.azimuth.value_or(30) + 70;
    const Framing there = frame(mesh.vertices, settings, {0, 0, 640, 360});
    for (const Eigen::Vector3d& vertex : mesh.vertices)
    {
        const glm::dvec3 a = project(turned, settings.size, vertex);
        const glm::dvec3 b = project(there, settings.size, vertex);
        EXPECT_NEAR(a.x, b.x, 1e-6);
        EXPECT_NEAR(a.y, b.y, 1e-6);
    }
    EXPECT_NEAR(turned.eye.x, there.eye.x, 1e-9);
    EXPECT_NEAR(turned.eye.z, there.eye.z, 1e-9);
}

TEST(Framing, DistanceIsThatOfTheEyeFromTheTarget)
{
    const TriangleMesh mesh = boxMesh({1, 1, 1}, {10, 0, 0});
    RenderSettings settings;
    settings.camera.target = Eigen::Vector3d(10, 0.5, 0);
    settings.camera.distance = 7;
    const Framing framing = frame(mesh.vertices, settings, {0, 0, 1280, 720});
    EXPECT_NEAR(glm::length(framing.eye - framing.toUnit(*settings.camera.target)) / framing.scale,
                7, 1e-9);
    settings.camera.distance = 0;
    EXPECT_THROW((void)frame(mesh.vertices, settings, {0, 0, 1280, 720}), Error);
}

} // namespace
} // namespace frostfill
