// SPDX-License-Identifier: MIT
#pragma once

#include "support/drawn_with.hpp"
#include "support/pictures.hpp"
#include "unit/render/draw.hpp"

#include <frostfill/renderer.hpp>

#include <cmath>

namespace frostfill::test
{

using namespace testing_support;

/// Spheres of all states in a box, with groups, speeds and some polygons discarded.
inline Snapshot pack(const TriangleMesh& mesh, int count, double radius)
{
    Snapshot snapshot;
    Numbers numbers;
    for (int i = 0; i < count; ++i)
    {
        const Eigen::Vector3d place(numbers.next(), numbers.next(), numbers.next());
        addSphere(snapshot, 1.6 * place - Eigen::Vector3d::Constant(0.8), radius,
                  static_cast<SphereState>(i % 3));
        snapshot.groups.back() = static_cast<std::uint32_t>(i / 5);
        snapshot.speeds.push_back(i % 3 == 0 ? static_cast<float>(numbers.next()) : 0.0F);
    }
    snapshot.polygons.assign(mesh.triangles.size(), PolygonState::active);
    snapshot.polygons[1] = snapshot.polygons[4] = PolygonState::discarded;
    snapshot.discardedPolygons = 2;
    return snapshot;
}

/// Moves what runs; some of it freezes and some of what is frozen is discarded.
inline void advance(Snapshot& snapshot, int frame)
{
    for (std::size_t i = 0; i < snapshot.centres.size(); ++i)
    {
        const auto turn = (i * 7 + static_cast<std::size_t>(frame)) % 11;
        if (snapshot.states[i] == SphereState::running)
        {
            snapshot.centres[i].y() -= 0.02F;
            snapshot.speeds[i] += 0.05F;
            if (turn == 0)
            {
                snapshot.states[i] = SphereState::frozen;
                snapshot.speeds[i] = 0;
            }
        }
        else if (snapshot.states[i] == SphereState::frozen && turn == 5)
        {
            snapshot.states[i] = SphereState::discarded;
        }
    }
    snapshot.polygons[static_cast<std::size_t>(frame) % snapshot.polygons.size()] =
        PolygonState::discarded;
    ++snapshot.step;
}

inline Image over(const Image& image, int ground)
{
    Image result = image;
    result.channels = 3;
    result.pixels.clear();
    for (std::size_t i = 0; i < image.pixels.size(); i += 4)
    {
        for (std::size_t c = 0; c < 3; ++c)
        {
            const double alpha = image.pixels[i + 3] / 255.0;
            result.pixels.push_back(static_cast<std::uint8_t>(
                std::lround(alpha * image.pixels[i + c] + (1 - alpha) * ground)));
        }
    }
    return result;
}

inline RenderSettings smallSettings()
{
    RenderSettings settings;
    settings.backend = test::drawnWith();
    settings.size = {300, 200};
    return settings;
}

inline RenderSettings squareOn()
{
    RenderSettings settings;
    settings.backend = test::drawnWith();
    settings.size = {200, 200};
    settings.camera.azimuth = 0;
    settings.camera.elevation = 0;
    settings.camera.orthographic = true;
    settings.style.legend = false;
    settings.style.shell = false;
    return settings;
}

} // namespace frostfill::test
