// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace frostfill
{

/// What a sphere is doing. The numbers are those of the files and of the state hash.
enum class SphereState : std::uint8_t
{
    running = 0,   ///< moves, is tested, responds
    frozen = 1,    ///< at rest for good; is tested against, never responds
    discarded = 2, ///< at rest and not even tested any more
};

enum class PolygonState : std::uint8_t
{
    active = 0,
    discarded = 1, ///< covered by spheres or out of reach, not tested any more
};

/// A sphere as the files have it: mesh coordinates, full precision.
struct SphereRecord
{
    Eigen::Vector3d centre;
    double radius = 0;
    std::uint32_t group = 0;
    SphereState state = SphereState::running;
};

/// All that one picture needs, and nothing of how it came about. Indexed by sphere id, which is the
/// order of appearance. A snapshot is filled by Simulation::capture, which touches only what has
/// changed since it filled the same snapshot last: keep one and reuse it.
struct Snapshot
{
    std::vector<Eigen::Vector3f> centres; ///< [#S] mesh coordinates relative to `origin`
    std::vector<float> radii;             ///< [#S] mesh unit
    std::vector<SphereState> states;      ///< [#S]
    std::vector<std::uint32_t> groups;    ///< [#S]
    std::vector<float> speeds;            ///< [#S] mesh unit a second; 0 at rest
    std::vector<PolygonState> polygons;   ///< [#T] of the mesh that is simulated
    Eigen::Vector3d origin = Eigen::Vector3d::Zero(); ///< mesh coordinates; the box's centre

    /// How the object stands in the room: a point p of the mesh is seen at
    /// origin + offset + rotation (p - origin).
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    Eigen::Vector3d offset = Eigen::Vector3d::Zero(); ///< [mesh unit]

    /// Ids that were added, moved or changed state in the last capture, ascending.
    std::vector<std::uint32_t> changed;
    bool polygonsChanged = false;     ///< some polygon changed its state in the last capture
    std::size_t stateChangesSeen = 0; ///< where the next capture goes on; not for the reader

    double time = 0;         ///< [s] simulated
    std::uint64_t step = 0;  ///< steps made since the start
    std::uint32_t set = 0;   ///< index of the set that is running
    std::size_t running = 0; ///< how many spheres are in each state
    std::size_t frozen = 0;
    std::size_t discarded = 0;
    std::size_t discardedPolygons = 0;
};

} // namespace frostfill
