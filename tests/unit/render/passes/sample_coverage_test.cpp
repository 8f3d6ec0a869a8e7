// SPDX-License-Identifier: MIT
// Which samples of a pixel spheres cover, as OpenGL and as tiles draw them, against a ray caster.
#include "render/picture/painter_settings.hpp"
#include "render/picture/picture_backend.hpp"
#include "render/picture/surfaces.hpp"
#include "render/raster/lanes/sample_tile.hpp"
#include "support/drawn_with.hpp"
#include "support/pictures.hpp"
#include "unit/render/passes/ray_caster.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

namespace frostfill
{
namespace
{

using namespace testing_support;

/// How many samples of each pixel a ray caster finds covered; none where one of them lies on an
/// edge.
std::vector<std::optional<int>> coveredSamples(const RenderSettings& settings,
                                               const Framing& framing, const Snapshot& snapshot)
{
    const test::RayCaster caster(framing, settings.size, cutPlanesOf(settings, framing));
    const std::vector<SphereInstance> spheres = placeSpheres(snapshot, framing);
    std::vector<std::optional<int>> covered;
    for (int y = 0; y < settings.size.height; ++y)
    {
        for (int x = 0; x < settings.size.width; ++x)
        {
            int count = 0;
            bool onEdge = false;
            for (const SampleOffset& sample : kFourSamples)
            {
                const test::Hit hit = caster.cast(
                    caster.through(x + 0.5 + double{sample.x}, y + 0.5 - double{sample.y}),
                    spheres);
                count += hit.isThere() ? 1 : 0;
                onEdge = onEdge || hit.onEdge;
            }
            covered.push_back(onEdge ? std::nullopt : std::optional(count));
        }
    }
    return covered;
}

// Without background: a pixel's alpha tells how many of its samples are covered.
TEST(SampleCoverage, IsThatOfTheRayCaster)
{
    RenderSettings settings;
    settings.size = {200, 150};
    settings.samples = 4;
    settings.style.palette.background = {255, 255, 255, 0};
    settings.style.shell = settings.style.legend = false;
    const TriangleMesh mesh = boxMesh({1, 0.8, 0.6});
    Snapshot snapshot;
    Numbers numbers;
    for (int i = 0; i < 60; ++i)
    {
        const Eigen::Vector3d place(2 * numbers.next() - 1, 1.6 * numbers.next() - 0.8,
                                    1.2 * numbers.next() - 0.6);
        addSphere(snapshot, place, 0.02 + 0.1 * numbers.next(), static_cast<SphereState>(i % 3));
    }
    for (const Backend backend : test::backends())
    {
        for (const auto kind : {Cutaway::Kind::none, Cutaway::Kind::plane, Cutaway::Kind::wedge})
        {
            for (const bool orthographic : {false, true})
            {
                settings.backend = backend;
                settings.camera.orthographic = orthographic;
                settings.style.cutaway = {kind, {0.2, 0.3, 1}, 0.1, -20, 100};
                Viewpoint viewpoint(mesh, settings);
                viewpoint.follow(snapshot);
                const auto covered = coveredSamples(settings, viewpoint.framing(), snapshot);
                Renderer renderer(mesh, settings);
                const Image& image = renderer.draw(snapshot);
                std::size_t between = 0;
                std::size_t wrong = 0;
                for (std::size_t i = 0; i < covered.size(); ++i)
                {
                    if (covered[i])
                    {
                        between += *covered[i] > 0 && *covered[i] < 4 ? 1 : 0;
                        wrong += std::abs(image.pixels[4 * i + 3] - 255 * *covered[i] / 4) > 1;
                    }
                }
                EXPECT_GT(between, 500U) << "the scene proves little";
                EXPECT_EQ(wrong, 0U) << static_cast<int>(backend) << ", cut "
                                     << static_cast<int>(kind) << ", " << orthographic;
            }
        }
    }
}

} // namespace
} // namespace frostfill
