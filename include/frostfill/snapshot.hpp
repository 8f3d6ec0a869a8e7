// SPDX-License-Identifier: MIT
// Room: the state of a run at one moment, as a picture needs it. The simulation fills it and the
// renderer reads it, so neither knows the other.
#pragma once

#include <frostfill/columns.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#pragma GCC visibility push(default)
namespace frostfill
{

/// The state of a sphere. The files and the state hash use these numbers.
enum class SphereState : std::uint8_t
{
    running = 0,   ///< moves, is tested, responds
    frozen = 1,    ///< at rest; is tested against, never responds
    discarded = 2, ///< at rest, and touched by no sphere any more; preset paper: no longer tested
};

enum class PolygonState : std::uint8_t
{
    active = 0,
    discarded = 1, ///< touched by no sphere any more; preset paper: no longer tested
};

/// A sphere as in the files: mesh coordinates, full precision.
struct SphereRecord
{
    Eigen::Vector3d centre;
    double radius = 0;
    std::uint32_t group = 0;
    SphereState state = SphereState::running;
    bool stray = false; ///< the run was stopped because it is where no sphere can be
};

/// A sphere as tables have it: what columns are read from.
struct SphereRow
{
    std::uint32_t id = 0;
    Eigen::Vector3d centre; ///< [mesh unit]
    double radius = 0;      ///< [mesh unit]
    SphereState state = SphereState::running;
    std::uint32_t group = 0;
    std::uint32_t set = 0;
    float speed = 0;                            ///< [mesh unit/s]
    std::span<const ColumnValues> carried = {}; ///< of all spheres
    double height = 0; ///< [mesh unit] of the centre above the object's foot; known to pictures

    [[nodiscard]] double value(const Column& column) const;
};

/// Position and orientation of the object. A point p of the mesh is at
/// origin + offset + rotation (p - origin), where origin is the middle of the box of the mesh.
struct Pose
{
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    Eigen::Vector3d offset = Eigen::Vector3d::Zero(); ///< [mesh unit]
};

/// Everything that one picture needs, and nothing of how it came about. Indexed by sphere id, in
/// order of appearance. Simulation::capture fills a snapshot and touches only what has changed
/// since it last filled the same one: keep one snapshot and reuse it.
struct Snapshot
{
    std::vector<Eigen::Vector3f> centres; ///< [#S] mesh coordinates relative to `origin`
    std::vector<float> radii;             ///< [#S] mesh unit
    std::vector<SphereState> states;      ///< [#S]
    std::vector<std::uint32_t> groups;    ///< [#S]
    std::vector<float> speeds;            ///< [#S] mesh units per second; 0 at rest
    /// [#S], or shorter where nothing waits: not 0 for a running sphere that has its number and
    /// only waits for its fall to begin. It is neither drawn nor counted.
    std::vector<std::uint8_t> waiting;
    std::vector<PolygonState> polygons; ///< [#T] of the simulated mesh
    /// Of the columns that the snapshot's creator requests, see carriedColumns(): capture fills the
    /// columns that are here.
    std::vector<ColumnValues> columns;
    Eigen::Vector3d origin = Eigen::Vector3d::Zero(); ///< mesh coordinates; the box's centre

    Pose pose; ///< of a moving object and everything in it

    /// Ids that appeared, moved, changed state or a carried value in the last capture, ascending.
    std::vector<std::uint32_t> changed;
    bool polygonsChanged = false;     ///< a polygon changed its state in the last capture
    std::size_t stateChangesSeen = 0; ///< internal: where the next capture continues
    std::uint64_t source = 0; ///< the simulation that filled it; 0 for a snapshot made by hand,
                              ///< whose `changed` is ignored
    /// Grows with whatever a picture shows, in snapshots of one source.
    std::uint64_t revision = 0;
    std::uint64_t changedSince = 0; ///< `changed` covers everything after this revision

    double time = 0;         ///< [s] simulated
    std::uint64_t step = 0;  ///< number of steps since the start
    std::uint32_t set = 0;   ///< index of the running set
    std::size_t running = 0; ///< number of spheres in each state
    std::size_t frozen = 0;
    std::size_t discarded = 0;
    std::size_t discardedPolygons = 0;

    [[nodiscard]] bool waits(std::size_t sphere) const
    {
        return sphere < waiting.size() && waiting[sphere] != 0;
    }
    /// Number of spheres in a state.
    [[nodiscard]] std::size_t& count(SphereState state)
    {
        return state == SphereState::running  ? running
               : state == SphereState::frozen ? frozen
                                              : discarded;
    }
    /// Makes room for so many spheres, or takes the last ones away. Does not count them.
    void resize(std::size_t spheres)
    {
        centres.resize(spheres, Eigen::Vector3f::Zero());
        radii.resize(spheres);
        states.resize(spheres, SphereState::running);
        groups.resize(spheres);
        speeds.resize(spheres);
        waiting.resize(std::min(waiting.size(), spheres));
        for (ColumnValues& each : columns)
        {
            each.bits.resize(spheres);
        }
    }
    [[nodiscard]] const ColumnValues* values(const Column& column) const
    {
        return findValues(columns, column);
    }
    /// Forgets everything but which columns are asked for: from now on `newSource` fills it.
    void beginAnew(std::uint64_t newSource)
    {
        std::vector<ColumnValues> asked;
        for (const ColumnValues& each : columns)
        {
            asked.emplace_back(each.column());
        }
        *this = {};
        columns = std::move(asked);
        source = newSource;
    }
};

} // namespace frostfill
#pragma GCC visibility pop
