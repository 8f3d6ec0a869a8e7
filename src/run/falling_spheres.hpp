// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>
#include <frostfill/scene.hpp>
#include <frostfill/snapshot.hpp>

#include <cstdint>
#include <vector>

namespace frostfill
{

/// A sphere of a run without falls, where it appears: at its first contact, or at rest.
struct Landing
{
    double time = 0;                                 ///< [s] simulated
    Eigen::Vector3d place = Eigen::Vector3d::Zero(); ///< [mesh unit]
    double radius = 0;                               ///< [mesh unit]
    std::uint32_t group = 0;
};

/// Draws the falls that Motion::skip and Motion::descend leave out: each sphere comes straight down
/// from the ceiling above its place, and arrives when it appears. Pictures show the run this much
/// later, so that spheres which are still to appear can fall; nothing is simulated.
class FallingSpheres
{
public:
    /// `landings` in the order of their times, ids in the same order; `lag` [s] simulated, for a
    /// fall through the whole object.
    FallingSpheres(std::vector<Landing> landings, const TriangleMesh& mesh, const Scene& scene,
                   double lag);

    /// Takes out of a snapshot what addTo has put in, before the next capture into it.
    static void takeFrom(Snapshot& snapshot, std::size_t real);
    /// Adds what falls at a simulated time, at or before that of the snapshot. What has not landed
    /// by then falls too. Returns how many spheres of the snapshot are the run's own.
    [[nodiscard]] std::size_t addTo(Snapshot& snapshot, double now) const;

    [[nodiscard]] double lag() const { return lag_; }
    /// A sphere that the run does not have yet, where it will appear.
    [[nodiscard]] SphereRecord sphere(std::size_t id) const;

private:
    [[nodiscard]] std::size_t landedUntil(double time) const;
    void put(Snapshot& snapshot, std::size_t id, double now) const;

    std::vector<Landing> landings_;
    std::vector<float> heights_; ///< of the falls [mesh unit]
    Eigen::Vector3d up_;
    double lag_;
    double pull_; ///< with which they fall [mesh unit / s^2]
};

} // namespace frostfill
