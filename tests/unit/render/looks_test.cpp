// SPDX-License-Identifier: MIT
// What the options of the picture do, and that the static layer does not show through any of them.
#include "support/pictures.hpp"
#include "unit/render/looks_samples.hpp"

#include <frostfill/renderer.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <numeric>

namespace frostfill
{
namespace
{

using namespace test;

struct Look_
{
    const char* name;
    std::function<void(RenderSettings&)> choose;
};

class EveryLook : public testing::TestWithParam<Look_>
{
};

TEST_P(EveryLook, IsTheSameToTheByteWithAndWithoutTheStaticLayer)
{
    const TriangleMesh mesh = boxMesh({1, 1, 1});
    for (const int samples : {1, 4})
    {
        RenderSettings settings = smallSettings();
        settings.samples = samples;
        settings.range = {0, 12};
        GetParam().choose(settings);
        Renderer on(mesh, settings);
        settings.staticLayer = false;
        Renderer off(mesh, settings);
        Snapshot snapshot = pack(mesh, 60, 0.15);
        for (int frame = 0; frame < 8; ++frame)
        {
            if (settings.camera.turntable && frame >= 4)
            {
                on.turn(25.0 * frame);
                off.turn(25.0 * frame);
            }
            const ImageDifference difference = compareImages(on.draw(snapshot), off.draw(snapshot));
            ASSERT_TRUE(difference.sameShape);
            EXPECT_EQ(difference.largest, 0) << "samples " << samples << ", frame " << frame;
            advance(snapshot, frame);
        }
    }
}

const Cutaway kWedge{Cutaway::Kind::wedge, {0, 0, 1}, 0, -20, 80};

INSTANTIATE_TEST_SUITE_P(
    Renderer, EveryLook,
    testing::Values(Look_{"Paper",
                          [](RenderSettings& s)
                          {
                              s.style.look = Look::paper;
                              s.style.palette = paletteOf(Look::paper);
                          }},
                    Look_{"Dark",
                          [](RenderSettings& s)
                          {
                              s.style.look = Look::dark;
                              s.style.palette = paletteOf(Look::dark);
                          }},
                    Look_{"Studio",
                          [](RenderSettings& s)
                          {
                              s.style.look = Look::studio;
                              s.style.palette = paletteOf(Look::studio);
                          }},
                    Look_{"StudioCutOpen",
                          [](RenderSettings& s)
                          {
                              s.style.look = Look::studio;
                              s.style.palette = paletteOf(Look::studio);
                              s.style.cutaway = kWedge;
                          }},
                    Look_{"AllEdges", [](RenderSettings& s) { s.style.edges = EdgeLines::on; }},
                    Look_{"NoEdges", [](RenderSettings& s) { s.style.edges = EdgeLines::off; }},
                    Look_{"DenseShell", [](RenderSettings& s) { s.style.shellOpacity = 0.6; }},
                    Look_{"Transparent",
                          [](RenderSettings& s) { s.style.palette.background[3] = 0; }},
                    Look_{"Plane",
                          [](RenderSettings& s) {
                              s.style.cutaway = {Cutaway::Kind::plane, {0.3, 0.1, 1}, 0.1, 0, 90};
                          }},
                    Look_{"Wedge", [](RenderSettings& s) { s.style.cutaway = kWedge; }},
                    Look_{"WedgeParallel",
                          [](RenderSettings& s)
                          {
                              s.style.cutaway = kWedge;
                              s.camera.orthographic = true;
                          }},
                    Look_{"Speed", [](RenderSettings& s) { s.style.colourBy = "speed"; }},
                    Look_{"Group", [](RenderSettings& s) { s.style.colourBy = "group"; }},
                    Look_{"Occlusion", [](RenderSettings& s) { s.style.ambientOcclusion = true; }},
                    Look_{"Supersampled", [](RenderSettings& s) { s.supersample = 2; }},
                    Look_{"Turntable", [](RenderSettings& s) { s.camera.turntable = 4; }}),
    [](const auto& look) { return std::string(look.param.name); });

TEST(Looks, PassesShowTheNearestSphereItsDistanceAndItsNormal)
{
    const TriangleMesh mesh = boxMesh({1, 1, 1});
    const Snapshot snapshot = pack(mesh, 30, 0.3);
    for (const bool orthographic : {true, false})
    {
        RenderSettings settings = squareOn();
        settings.camera.orthographic = orthographic;
        settings.camera.distance = 5;
        Renderer renderer(mesh, settings);
        PassPictures passes;
        renderer.renderPasses(snapshot, passes);
        // At azimuth 0 and elevation 0 the eye looks along -z, from z = 5 at x = y = 0 in
        // perspective; in parallel the box from -1 to 1 fills the picture but for the margin.
        const double half = orthographic ? 1 / 0.96 : std::tan(35 * M_PI / 360);
        int checked = 0;
        for (int y = 5; y < 200; y += 7)
        {
            for (int x = 5; x < 200; x += 7)
            {
                const double u = (2 * (x + 0.5) / 200 - 1) * half;
                const double v = (1 - 2 * (y + 0.5) / 200) * half;
                const Eigen::Vector3d origin =
                    orthographic ? Eigen::Vector3d(u, v, 5) : Eigen::Vector3d(0, 0, 5);
                const Eigen::Vector3d way = orthographic ? Eigen::Vector3d(0, 0, -1)
                                                         : Eigen::Vector3d(u, v, -1).normalized();
                double nearest = 1e9;
                std::size_t id = 0;
                bool edge = false;
                for (std::size_t i = 0; i < snapshot.centres.size(); ++i)
                {
                    const Eigen::Vector3d centre = snapshot.centres[i].cast<double>();
                    const double along = (centre - origin).dot(way);
                    const double miss = (centre - origin - along * way).norm();
                    edge = edge || std::abs(miss - 0.3) < 0.004;
                    const double t = along - std::sqrt(std::max(0.0, 0.09 - miss * miss));
                    if (miss < 0.3 && t < nearest)
                    {
                        nearest = t;
                        id = i + 1;
                    }
                }
                if (edge)
                {
                    continue;
                }
                const auto* identity = passes.identity.at(x, y);
                ASSERT_EQ(identity[0] + 256U * identity[1] + 65536U * identity[2], id);
                const auto* depth = passes.depth.at(x, y);
                const int value = depth[0] * 256 + depth[1];
                if (id == 0)
                {
                    ASSERT_EQ(value, 65535);
                    continue;
                }
                ++checked;
                const Eigen::Vector3d hit = origin + nearest * way;
                const Eigen::Vector3d normal =
                    (hit - snapshot.centres[id - 1].cast<double>()) / 0.3;
                for (int c = 0; c < 3; ++c)
                {
                    EXPECT_NEAR(passes.normal.at(x, y)[c], 127.5 + 127.5 * normal[c], 1.5);
                }
                if (!orthographic) // without perspective distances are from a plane of our choice
                {
                    EXPECT_NEAR(passes.nearest +
                                    value / 65534.0 * (passes.furthest - passes.nearest),
                                5 - hit.z(), 0.001);
                }
            }
        }
        EXPECT_GT(checked, 100) << "the scene proves little";
    }
}

TEST(Looks, ACutSphereShowsTheDiscOfTheCut)
{
    const TriangleMesh mesh = boxMesh({1, 1, 1});
    Snapshot snapshot;
    addSphere(snapshot, {0, 0, 0}, 0.9, SphereState::frozen);
    RenderSettings settings = squareOn();
    settings.style.cutaway = {Cutaway::Kind::plane, {0, 0, 1}, 0.3, 0, 90};
    PassPictures passes;
    Renderer(mesh, settings).renderPasses(snapshot, passes);
    int disc = 0;
    for (std::size_t i = 0; i < passes.normal.pixels.size(); i += 3)
    {
        disc += passes.identity.pixels[i] == 1 && passes.normal.pixels[i] == 128 &&
                        passes.normal.pixels[i + 1] == 128 && passes.normal.pixels[i + 2] == 255
                    ? 1
                    : 0;
    }
    // Its radius is sqrt(0.9^2 - 0.3^2), and a length of 1 is 96 pixels.
    EXPECT_NEAR(disc, M_PI * (0.81 - 0.09) * 96 * 96, 300);

    // All of it is beyond the plane.
    settings.style.cutaway.offset = -0.95;
    Renderer(mesh, settings).renderPasses(snapshot, passes);
    EXPECT_EQ(*std::max_element(passes.identity.pixels.begin(), passes.identity.pixels.end()), 0);

    // A wedge from straight ahead to the right takes away what is there and leaves the left alone:
    // of the hole one sees the face that looks to the right at grazing angles only.
    settings.style.cutaway = {Cutaway::Kind::wedge, {0, 0, 1}, 0, 0, 90};
    Renderer(mesh, settings).renderPasses(snapshot, passes);
    EXPECT_EQ(passes.normal.at(160, 100)[2], 255); // the cut along z = 0
    EXPECT_LT(passes.normal.at(40, 100)[0], 80);   // the sphere as it was
}

TEST(Looks, OcclusionDarkensWhereSpheresTouchAndNothingElse)
{
    const TriangleMesh mesh = boxMesh({1, 1, 1});
    RenderSettings settings = squareOn();
    Snapshot alone;
    addSphere(alone, {-0.4, 0, 0}, 0.4, SphereState::frozen);
    const auto difference = [&](const Snapshot& snapshot)
    {
        settings.style.ambientOcclusion = false;
        const Image without = draw(mesh, settings, snapshot);
        settings.style.ambientOcclusion = true;
        return std::pair(without, draw(mesh, settings, snapshot));
    };
    const auto [loneBefore, loneAfter] = difference(alone);
    EXPECT_LE(compareImages(loneBefore, loneAfter).largest, 6);

    Snapshot touching = alone;
    addSphere(touching, {0.4, 0, 0}, 0.4, SphereState::frozen);
    const auto [before, after] = difference(touching);
    const auto share = [&, &before = before, &after = after](int x)
    { return static_cast<double>(after.at(x, 100)[2]) / before.at(x, 100)[2]; };
    EXPECT_LT(share(97), 0.8);
    EXPECT_GT(share(40), 0.95);
}

/// The sum of the squares of the steps between neighbours in a row or a column.
double roughness(const Image& image)
{
    const auto row = static_cast<std::ptrdiff_t>(image.width) * image.channels;
    double sum = 0;
    for (auto own = image.pixels.begin() + row; own != image.pixels.end(); ++own)
    {
        sum += std::pow(*own - *(own - image.channels), 2) + std::pow(*own - *(own - row), 2);
    }
    return sum;
}

// An edge is a step of s at one pixel. Averaged over pixels that it crosses anywhere it becomes two
// steps of sums s: their squares have a mean of s^2 (a^2 + (1 - a)^2) = 2/3 s^2, with a uniform.
TEST(Looks, SupersamplingKeepsTheSizeAndTheMeanAndSoftensEdges)
{
    const TriangleMesh mesh = boxMesh({1, 1, 1});
    const Snapshot snapshot = pack(mesh, 30, 0.2);
    RenderSettings settings = smallSettings();
    settings.samples = 1;
    const Image plain = draw(mesh, settings, snapshot);
    settings.supersample = 3;
    const Image smooth = draw(mesh, settings, snapshot);
    ASSERT_EQ(smooth.width, plain.width);
    ASSERT_EQ(smooth.height, plain.height);
    EXPECT_LT(compareImages(plain, smooth).rootMeanSquare, 25);
    const auto mean = [](const Image& image)
    {
        return std::accumulate(image.pixels.begin(), image.pixels.end(), 0.0) /
               static_cast<double>(image.pixels.size());
    };
    EXPECT_NEAR(mean(smooth), mean(plain), 0.5);
    const double left = roughness(smooth) / roughness(plain);
    EXPECT_GT(left, 0.5);
    EXPECT_LT(left, 0.8);
}

TEST(Looks, HeightsRunOverTheWholeScale)
{
    const TriangleMesh mesh = boxMesh({1, 1, 1});
    Snapshot snapshot;
    addSphere(snapshot, {0, -0.8, 0}, 0.15, SphereState::frozen);
    addSphere(snapshot, {0, 0.8, 0}, 0.15, SphereState::frozen);
    RenderSettings settings = squareOn();
    settings.style.colourBy = "height";
    const Image image = draw(mesh, settings, snapshot);
    const auto* low = image.at(100, 177);
    const auto* high = image.at(100, 23);
    EXPECT_GT(low[2], low[1]);           // violet
    EXPECT_GT(high[0], 3 * high[2] / 2); // yellow-green
    EXPECT_GT(high[1], 3 * high[2] / 2);
}

} // namespace
} // namespace frostfill
