// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>
#include <frostfill/snapshot.hpp>

#include <cmath>
#include <cstdint>

namespace frostfill::benchmark
{

/// A loose pack of frozen spheres in a unit cube, and spheres that fall through it, as a simulation
/// would capture them.
class RenderScene
{
public:
    RenderScene(std::size_t frozen, std::size_t running)
    {
        const auto edge = static_cast<std::size_t>(std::ceil(std::cbrt(frozen) - 1e-9));
        const double cell = 1.0 / static_cast<double>(edge);
        snapshot.source = 1;
        for (std::size_t i = 0; i < frozen; ++i)
        {
            // Layers from the bottom upwards, with some disorder.
            const Eigen::Vector3d index(static_cast<double>(i % edge),
                                        static_cast<double>(i / (edge * edge)),
                                        static_cast<double>(i / edge % edge));
            const Eigen::Vector3d disorder(next(), next(), next());
            const Eigen::Vector3d centre =
                cell * (index + Eigen::Vector3d::Constant(0.4) + 0.2 * disorder) -
                Eigen::Vector3d::Constant(0.5);
            add(centre, 0.48 * cell, SphereState::frozen);
        }
        firstRunning_ = frozen;
        for (std::size_t i = 0; i < running; ++i)
        {
            // Just in front of the faces that are seen, so that none of them is hidden.
            const double radius = 0.48 / std::cbrt(10000.0);
            const double along = next() - 0.5;
            const double front = 0.5 + radius;
            add({i % 2 == 0 ? along : front, next() - 0.5, i % 2 == 0 ? front : along}, radius,
                SphereState::running);
        }
        snapshot.frozen = frozen;
        snapshot.running = running;
    }

    /// The next frame: what runs falls by half its radius, and starts again at the top.
    void advance()
    {
        snapshot.changed.clear();
        for (std::size_t i = firstRunning_; i < snapshot.centres.size(); ++i)
        {
            float& height = snapshot.centres[i].y();
            height -= 0.5F * snapshot.radii[i];
            height += height < -0.5F ? 1.0F : 0.0F;
            snapshot.changed.push_back(static_cast<std::uint32_t>(i));
        }
        snapshot.changedSince = snapshot.revision++;
        ++snapshot.step;
    }

    Snapshot snapshot;

private:
    void add(const Eigen::Vector3d& centre, double radius, SphereState state)
    {
        snapshot.changed.push_back(static_cast<std::uint32_t>(snapshot.centres.size()));
        snapshot.centres.push_back(centre.cast<float>());
        snapshot.radii.push_back(static_cast<float>(radius));
        snapshot.states.push_back(state);
        snapshot.groups.push_back(0);
    }

    double next()
    {
        state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<double>(state_ >> 11) * 0x1p-53;
    }

    std::size_t firstRunning_ = 0;
    std::uint64_t state_ = 1;
};

/// The cube that the scene fills, with so many quads along an edge of each face.
inline TriangleMesh unitCube(int quads)
{
    TriangleMesh mesh;
    for (int axis = 0; axis < 3; ++axis)
    {
        for (const int side : {-1, 1})
        {
            const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
            const auto row = static_cast<std::uint32_t>(quads + 1);
            for (int j = 0; j <= quads; ++j)
            {
                for (int i = 0; i <= quads; ++i)
                {
                    Eigen::Vector3d corner;
                    corner[axis] = 0.5 * side;
                    corner[(axis + 1) % 3] = static_cast<double>(i) / quads - 0.5;
                    corner[(axis + 2) % 3] = side * (static_cast<double>(j) / quads - 0.5);
                    mesh.vertices.push_back(corner);
                }
            }
            for (std::uint32_t j = 0; j < row - 1; ++j)
            {
                for (std::uint32_t i = 0; i < row - 1; ++i)
                {
                    const std::uint32_t a = first + j * row + i;
                    mesh.triangles.push_back({a, a + 1, a + row});
                    mesh.triangles.push_back({a + 1, a + row + 1, a + row});
                }
            }
        }
    }
    return mesh;
}

} // namespace frostfill::benchmark
