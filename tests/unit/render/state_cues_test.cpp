// SPDX-License-Identifier: MIT
// Can everyone tell the states apart? Measured on spheres as they are drawn.
#include <frostfill/renderer.hpp>
#include <support/shapes.hpp>

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

double linear(double value)
{
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

/// Mean of linear RGB over the drawn sphere, rings, highlights, hatches and all.
Vector3d meanColour(SphereState state)
{
    RenderSettings settings;
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
            if (pixel[0] < 255 || pixel[1] < 255 || pixel[2] < 255)
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

/// CIELAB, D65.
Vector3d lab(const Vector3d& rgb)
{
    Matrix3d toXyz;
    toXyz << 0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505;
    const Vector3d xyz = (toXyz * rgb.cwiseMax(0)).cwiseQuotient(Vector3d(0.95047, 1, 1.08883));
    const Vector3d f = xyz.unaryExpr(
        [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; });
    return {116 * f.y() - 16, 500 * (f.x() - f.y()), 200 * (f.y() - f.z())};
}

/// Complete colour blindness of each kind [Machado, Oliveira & Fernandes 2009, severity 1].
std::array<Matrix3d, 4> visions()
{
    std::array<Matrix3d, 4> result;
    result[0].setIdentity();
    result[1] << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116,
        1.051998;
    result[2] << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940,
        0.968881;
    result[3] << 1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367,
        0.303900;
    return result;
}

TEST(StateCues, ColoursDifferForEveryKindOfColourVision)
{
    std::array<Vector3d, 3> colours;
    for (std::size_t i = 0; i < kStates.size(); ++i)
    {
        colours[i] = meanColour(kStates[i]);
    }
    for (const Matrix3d& vision : visions())
    {
        for (std::size_t i = 0; i < 3; ++i)
        {
            const Vector3d difference =
                lab(vision * colours[i]) - lab(vision * colours[(i + 1) % 3]);
            EXPECT_GT(difference.norm(), 20) << "vision\n"
                                             << vision << "\nstates " << i << ' ' << (i + 1) % 3;
        }
    }
}

/// Brightness along the sphere's middle, where a hatch goes up and down and a ring is dark.
std::vector<int> profile(SphereState state)
{
    RenderSettings settings;
    settings.size = {200, 200};
    settings.camera.elevation = 0;
    settings.camera.azimuth = 0;
    settings.style.legend = false;
    settings.style.shell = false;
    settings.style.palette.running = settings.style.palette.frozen =
        settings.style.palette.discarded = {128, 128, 128, 255};
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
