// SPDX-License-Identifier: MIT
// Room: the columns of spheres that a snapshot carries: where values come from, and how a snapshot
// gets them.
#pragma once

#include "simulation/world/world.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace frostfill
{

/// A carried column that only the world knows.
class WorldColumn
{
public:
    virtual ~WorldColumn() = default;
    /// Of a sphere in the world as it stands.
    [[nodiscard]] virtual double value(std::uint32_t id) const = 0;
    /// Looks at what has happened in the world, before values are asked for one by one.
    virtual void update() {}
    /// Spheres whose values changed although they neither moved nor changed their states, in the
    /// order in which it was found. It only grows.
    [[nodiscard]] virtual std::span<const std::uint32_t> changes() const { return {}; }
};

/// What makes the column of this name for a world, which outlives it.
using MakeWorldColumn = std::function<std::unique_ptr<WorldColumn>(const World& world)>;

/// By the name of the column. Add one before the first simulation, from one thread.
[[nodiscard]] std::map<std::string, MakeWorldColumn>& worldColumns();

/// A component of the quaternion by which a sphere has turned since it appeared, in mesh
/// coordinates. Of the two quaternions of an orientation it is the one whose real part is not
/// negative.
class OrientationColumn final : public WorldColumn
{
public:
    /// `component`: x, y, z or w, from 0.
    OrientationColumn(const World& world, int component) : world_(world), component_(component) {}

    [[nodiscard]] double value(std::uint32_t id) const override
    {
        if (id >= world_.orientations.size())
        {
            return component_ == 3 ? 1 : 0;
        }
        const Eigen::Quaterniond& q = world_.orientations[id];
        const double sign = q.w() < 0 ? -1 : 1;
        return component_ == 3
                   ? sign * q.w()
                   : sign * world_.frame.toMeshOffset(q.vec())[component_] / world_.frame.length;
    }

private:
    const World& world_;
    int component_;
};

/// A value of spheres at rest that follows from others beside them: found for all at once, whenever
/// one is requested after a sphere has come to rest or woken, or the object has moved. Running
/// spheres have 0.
class ColumnAtRest final : public WorldColumn
{
public:
    /// Returns the values by row at rest.
    using Find = std::vector<double> (*)(const World& world);

    ColumnAtRest(const World& world, Find find) : world_(world), find_(find) {}

    [[nodiscard]] double value(std::uint32_t id) const override;
    void update() override;
    [[nodiscard]] std::span<const std::uint32_t> changes() const override { return changes_; }

private:
    /// All that the values depend on.
    struct Moment
    {
        std::size_t changes; ///< of spheres' states
        Eigen::Vector3d pull;
        Eigen::Vector3d spin;

        bool operator==(const Moment&) const = default;
    };
    [[nodiscard]] Moment now() const;

    const World& world_;
    Find find_;
    mutable std::mutex lock_;            ///< of the next two
    mutable std::optional<Moment> seen_; ///< when they were found
    mutable std::vector<double> values_; ///< by row at rest
    std::optional<Moment> toldAt_;       ///< the last update
    std::vector<double> told_;           ///< [#S] the values then
    std::vector<std::uint32_t> changes_;
};

} // namespace frostfill
