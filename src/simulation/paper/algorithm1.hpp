// SPDX-License-Identifier: MIT
// Room: the method of the paper: Algorithm 1, its searches and its schedule. The names are those
// of the paper.
#pragma once

#include "simulation/contact/contact.hpp"
#include "simulation/paper/searches.hpp"
#include "simulation/world/spheres.hpp"

#include <frostfill/measure.hpp>

#include <vector>

namespace frostfill
{

/// The paper's Algorithm 1: one time step's collision tests and responses. Spheres come to rest in
/// order of appearance, so the groups FFG..LFG are the rows at rest from frozenBegin on, and the
/// groups start..end all rows that run. Times in sqrt(r/g), lengths in r.
class Algorithm1
{
public:
    /// `byGrid`: cycle 2 looks only at the spheres at rest in the cells near a running one, in the
    /// order of all pairs, so that the bits are the same; else at all of them, as the paper does.
    /// Everything but the restitution outlives this.
    Algorithm1(Spheres& spheres, const Surface& surface, PolygonSearchPart& polygons,
               const Restitution& restitution, bool byGrid = false);

    /// Cycle 1, running with running: both respond.
    void runningRunning(OperationCounts& counts);
    /// Cycle 2, running with frozen: the running one responds.
    void runningFrozen(std::size_t frozenBegin, OperationCounts& counts);
    /// Cycle 3, running with polygons that are not discarded. `before` has the centres of the
    /// running spheres before the step; they tell on which side of a wall a centre belongs.
    void runningPolygons(const std::vector<Eigen::Vector3d>& before, OperationCounts& counts);

    /// Whether a running sphere, by row, has responded since clearTouched.
    [[nodiscard]] const std::vector<bool>& touched() const { return touched_; }
    void clearTouched() { touched_.assign(running_.size(), false); }

    /// Centres and radii of spheres at rest, coordinate by coordinate: what a test of four at once
    /// loads. Gathered from the rows of the table, each load would be four.
    struct FourAtOnce
    {
        std::vector<double> x, y, z, radius;
    };

private:
    /// Spheres at rest from `begin` to before `end`. In the preset paper all come to rest in the
    /// order of their ids, so that the id of one at rest is also its row.
    struct IdRange
    {
        std::size_t begin = 0;
        std::size_t end = 0;
    };
    /// Finds the spheres at rest from `begin` on near the running row `i`, as ranges in ascending
    /// order: at least all that it may touch, also after the others have pushed it by up to the
    /// largest radius.
    void findNear(std::uint32_t i, std::size_t begin);
    void followRest();
    std::uint64_t respondToFrozen(std::uint32_t i, std::size_t begin, std::size_t end);
    void respond(std::uint32_t i, const Contact& contact);
    std::uint64_t respondToAllFrozen(std::uint32_t i, std::size_t begin, std::size_t end);
    void reflect(std::uint32_t i, const Eigen::Vector3d& normal);
    std::uint64_t collideWithPolygons(std::uint32_t i, const Eigen::Vector3d& before,
                                      OperationCounts& counts);
    /// No function of the source's own: it would be made part of the loop over all polygons, which
    /// then takes half as long again.
    [[nodiscard]] std::optional<Contact> oneSidedContact(std::uint32_t polygon,
                                                         const Eigen::Vector3d& p,
                                                         const Eigen::Vector3d& before,
                                                         double radius) const;
    void keepInside(std::uint32_t i, const Eigen::Vector3d& before);

    Spheres& spheres_;
    RunningSpheres& running_;
    FourAtOnce frozen_; ///< by row
    const Surface& surface_;
    PolygonSearchPart& polygons_;
    Restitution restitution_;
    bool byGrid_;
    std::vector<std::uint32_t> ids_; ///< scratch
    std::vector<IdRange> ranges_;    ///< of spheres at rest that the sphere in hand is tested with
    std::vector<bool> touched_;
    std::vector<std::uint32_t> nearby_; ///< polygons near the sphere in hand
    double deepest_ = 0;                ///< deepest push off a polygon of the sphere in hand
};

} // namespace frostfill
