// SPDX-License-Identifier: MIT
// Can everyone tell the states apart? Measured on spheres as they are drawn.
#include "support/colour_vision.hpp"
#include "support/drawn_with.hpp"
#include "support/pictures.hpp"

#include <frostfill/renderer.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace frostfill
{
namespace
{

using namespace testing_support;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr std::array kStates = {SphereState::running, SphereState::frozen, SphereState::discarded};

/// Mean of linear RGB over the drawn sphere, rings, highlights, hatches and all.
Vector3d meanColour(SphereState state, Look look)
{
    RenderSettings settings;
    settings.backend = test::drawnWith();
    settings.style.look = look;
    settings.style.palette = paletteOf(look);
    settings.style.ground = false;
    const Colour& ground = settings.style.palette.background;
    settings.size = {100, 100};
    settings.style.legend = false;
    settings.style.shell = false;
    Snapshot snapshot;
    addSphere(snapshot, {0, 0, 0}, 0.9, state);
    Image image;
    Renderer(boxMesh({1, 1, 1}), settings).render(snapshot, image);

    Vector3d sum = Vector3d::Zero();
    int count = 0;
    for (int y = 0; y < 100; ++y)
    {
        for (int x = 0; x < 100; ++x)
        {
            const auto* pixel = image.at(x, y);
            if (pixel[0] != ground[0] || pixel[1] != ground[1] || pixel[2] != ground[2])
            {
                sum += Vector3d(linear(pixel[0] / 255.0), linear(pixel[1] / 255.0),
                                linear(pixel[2] / 255.0));
                ++count;
            }
        }
    }
    EXPECT_GT(count, 1000);
    return sum / count;
}

TEST(StateCues, ColoursDifferForEveryKindOfColourVision)
{
    for (const Look look : {Look::clean, Look::paper, Look::dark, Look::studio})
    {
        std::array<Vector3d, 3> colours;
        for (std::size_t i = 0; i < kStates.size(); ++i)
        {
            colours[i] = meanColour(kStates[i], look);
        }
        for (const Matrix3d& vision : visions())
        {
            for (std::size_t i = 0; i < 3; ++i)
            {
                const Vector3d difference =
                    lab(vision * colours[i]) - lab(vision * colours[(i + 1) % 3]);
                EXPECT_GT(difference.norm(), 20)
                    << "look " << static_cast<int>(look) << " vision\n"
                    << vision << "\nstates " << i << ' ' << (i + 1) % 3;
            }
        }
    }
}

/// Brightness along the sphere's middle, where a hatch goes up and down and a ring is dark.
std::vector<int> profile(SphereState state)
{
    RenderSettings settings;
    settings.backend = test::drawnWith();
    settings.size = {200, 200};
    settings.camera.elevation = 0;
    settings.camera.azimuth = 0;
    settings.style.legend = false;
    settings.style.shell = false;
    settings.style.palette.running = settings.style.palette.frozen = {128, 128, 128, 255};
    settings.style.palette.discarded = {128, 128, 129, 255}; // spheres of one colour have no marks
    Snapshot snapshot;
    addSphere(snapshot, {0, 0, 0}, 0.9, state);
    Image image;
    Renderer(boxMesh({1, 1, 1}), settings).render(snapshot, image);
    std::vector<int> values;
    for (int x = 0; x < 200; ++x)
    {
        if (image.at(x, 100)[0] < 250)
        {
            values.push_back(image.at(x, 100)[0]);
        }
    }
    return values;
}

TEST(StateCues, MarksTellTheStatesApartWithoutColour)
{
    const std::vector<int> running = profile(SphereState::running);
    const std::vector<int> frozen = profile(SphereState::frozen);
    const std::vector<int> discarded = profile(SphereState::discarded);
    ASSERT_GT(frozen.size(), 60U);

    // The ring: inside the antialiased outline.
    EXPECT_LT(running[4], frozen[4] / 2);
    // The hatch: brightness falls by a quarter and recovers, more than once.
    const auto drops = [](const std::vector<int>& values)
    {
        int count = 0;
        for (std::size_t i = 3; i + 3 < values.size(); ++i)
        {
            count += values[i] < 0.8 * values[i - 3] ? 1 : 0;
        }
        return count;
    };
    EXPECT_GE(drops(discarded), 2);
    EXPECT_EQ(drops(frozen), 0);
}

} // namespace
} // namespace frostfill
