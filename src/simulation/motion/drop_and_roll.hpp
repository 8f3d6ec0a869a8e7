// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/contact/neighbour_list.hpp"
#include "simulation/world/world.hpp"

#include <limits>
#include <vector>

namespace frostfill
{

/// Takes one sphere at a time down to a place where it stays, without dynamics: it falls, then
/// slides in the direction in which gravity moves it among its contacts, until they carry its
/// weight. Drop and roll [Visscher & Bolsterli 1972] for spheres at rest and triangles alike. The
/// sphere always stays clear of everything, so its final overlap is rounding.
class DropAndRoll
{
public:
    explicit DropAndRoll(const World& world) : world_(world) {}

    /// `p` is a place that is clear of everything. Returns true when a place was found that carries
    /// the sphere: what gravity has left of its weight is below the tolerance. False when the
    /// sphere got stuck in a wedge on the way.
    [[nodiscard]] bool settle(Eigen::Vector3d& p, double radius) const
    {
        NeighbourList around;
        return settle(p, radius, around);
    }
    /// The same with a neighbourhood of the caller's, which is up to date or invalid. False also
    /// when the place would be farther than `farthest` from p. Several threads may settle spheres
    /// at once, each with a neighbourhood of its own. `seen`, if given, grows by where this looks
    /// for spheres at rest (see addSeen).
    [[nodiscard]] bool settle(Eigen::Vector3d& p, double radius, NeighbourList& around,
                              double farthest = std::numeric_limits<double>::infinity(),
                              Eigen::AlignedBox3d* seen = nullptr) const;

    /// Takes p, which is clear of everything, straight down to its first contact. False, and p
    /// stays, where there is none: p is then outside the object.
    bool drop(Eigen::Vector3d& p, double radius, Eigen::AlignedBox3d* seen = nullptr) const;

private:
    /// Who moves, and what is known of where.
    struct Path
    {
        double radius;
        NeighbourList& around;
        Eigen::AlignedBox3d* seen;
    };
    void look(const Path& path, const Eigen::Vector3d& p, double ahead) const;
    bool fall(Eigen::Vector3d& p, const Path& path, const Eigen::Vector3d& down) const;
    /// `pull`: what contacts leave of a pull along `down`.
    bool slide(Eigen::Vector3d& p, const Path& path, const Eigen::Vector3d& down,
               const Eigen::Vector3d& pull, double& longest) const;

    const World& world_;
};

} // namespace frostfill
