// SPDX-License-Identifier: MIT
#pragma once

#include "support/pictures.hpp"

#include <frostfill/snapshot.hpp>

#include <algorithm>
#include <cmath>

namespace frostfill::testing_support
{

/// A made-up run in a torus: spheres drop along its ring, freeze, are discarded, and cover
/// polygons.
class MadeUpRun
{
public:
    explicit MadeUpRun(const TriangleMesh& mesh, double radius) : mesh_(mesh), radius_(radius)
    {
        snapshot.polygons.assign(mesh.triangles.size(), PolygonState::active);
    }

    void release(int count)
    {
        for (int i = 0; i < count; ++i)
        {
            const double angle = 6.283 * numbers_.next();
            const double ring = 0.8 + 0.4 * numbers_.next();
            addSphere(snapshot,
                      {ring * std::cos(angle), ring * std::sin(angle), 0.4 * numbers_.next() - 0.2},
                      radius_, SphereState::running);
        }
    }

    /// Moves what runs, freezes some of it and discards some of what is frozen.
    void advance(double freeze, double discard, double cover)
    {
        for (std::size_t i = 0; i < snapshot.centres.size(); ++i)
        {
            SphereState& state = snapshot.states[i];
            if (state == SphereState::running)
            {
                snapshot.centres[i] += Eigen::Vector3f(0.01F, -0.03F, 0.005F);
                state = numbers_.next() < freeze ? SphereState::frozen : state;
            }
            else if (state == SphereState::frozen && numbers_.next() < discard)
            {
                state = SphereState::discarded;
            }
        }
        for (PolygonState& state : snapshot.polygons)
        {
            state = numbers_.next() < cover ? PolygonState::discarded : state;
        }
        count();
        ++snapshot.step;
        snapshot.time += 1.0 / 30;
    }

    Snapshot snapshot;

private:
    void count()
    {
        const auto in = [&](SphereState state)
        {
            return static_cast<std::size_t>(
                std::count(snapshot.states.begin(), snapshot.states.end(), state));
        };
        snapshot.running = in(SphereState::running);
        snapshot.frozen = in(SphereState::frozen);
        snapshot.discarded = in(SphereState::discarded);
        snapshot.discardedPolygons = static_cast<std::size_t>(std::count(
            snapshot.polygons.begin(), snapshot.polygons.end(), PolygonState::discarded));
    }

    const TriangleMesh& mesh_;
    double radius_;
    Numbers numbers_;
};

} // namespace frostfill::testing_support
