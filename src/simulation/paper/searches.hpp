// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/surface.hpp"
#include "mesh/interior/triangle_grid.hpp"
#include "simulation/paper/tolerances.hpp"
#include "simulation/world/spheres.hpp"

#include <frostfill/scene.hpp>
#include <frostfill/snapshot.hpp>

#include <memory>
#include <span>
#include <vector>

namespace frostfill
{

/// Spheres with ids from `begin` to before `end`. In the preset paper all come to rest in the order
/// of their ids, so that the id of one at rest is also its row.
struct IdRange
{
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// Which spheres at rest a running one is tested with in cycle 2 of Algorithm 1: those in the cells
/// near it, in the order of all pairs, so that the bits are the same.
class SpheresByGrid
{
public:
    /// `resting`: a grid of all spheres at rest, kept up to date, which outlives this.
    explicit SpheresByGrid(const SphereGrid& resting) : resting_(resting) {}

    /// Those of `frozen` that the sphere in running row `i` is tested with, as ranges in ascending
    /// order: at least all that it may touch, also after the others have pushed it by up to the
    /// largest radius. Valid until the next call.
    [[nodiscard]] std::span<const IdRange> near(const Spheres& spheres, std::uint32_t i,
                                                IdRange frozen);

private:
    const SphereGrid& resting_;
    std::vector<std::uint32_t> ids_;
    std::vector<IdRange> ranges_;
};

/// Tests a sphere with the polygons that a search calls it for.
class PolygonVisitor
{
public:
    /// Lists in `nearby` those that may be within kNearby radii of p, and calls
    /// `respond(polygon)`, which may move p, for those that may touch the sphere.
    template <class Respond>
    PolygonVisitor(const Surface& surface, const Eigen::Vector3d& p, double radius,
                   std::vector<std::uint32_t>& nearby, Respond& respond)
        : surface_(surface), p_(p), reach_(kNearby * radius), radius_(radius), nearby_(nearby),
          respond_(&respond), call_([](void* function, std::uint32_t polygon)
                                    { (*static_cast<Respond*>(function))(polygon); })
    {
    }

    void operator()(std::uint32_t polygon)
    {
        ++tests_;
        test(polygon, p_);
    }

    /// The same for each of some polygons, in less time.
    void operator()(std::span<const std::uint32_t> polygons)
    {
        tests_ += polygons.size();
        Eigen::Vector3d p = p_;
        for (const std::uint32_t polygon : polygons)
        {
            if (test(polygon, p))
            {
                p = p_;
            }
        }
    }

    [[nodiscard]] std::uint64_t tests() const { return tests_; }

private:
    // Whether it is listed.
    bool test(std::uint32_t polygon, const Eigen::Vector3d& p)
    {
        const TriangleBound& bound = surface_.bound(polygon);
        const double plane = bound.toPlane(p);
        if (plane > reach_)
        {
            return false;
        }
        const double centreSquared = bound.toCentreSquared(p);
        if (!bound.ballIsWithin(reach_, centreSquared))
        {
            return false;
        }
        meet(polygon, plane <= radius_ && bound.ballIsWithin(radius_, centreSquared));
        return true;
    }
    // Apart from the loops, which are tight without it.
    void meet(std::uint32_t polygon, bool mayTouch);

    const Surface& surface_;
    const Eigen::Vector3d& p_;
    double reach_;
    double radius_;
    std::vector<std::uint32_t>& nearby_;
    void* respond_;
    void (*call_)(void*, std::uint32_t);
    std::uint64_t tests_ = 0;
};

/// A polygon search: which polygons a running sphere is tested with in cycle 3 of Algorithm 1. It
/// is asked once a sphere and step. Preset paper.
class PolygonSearchPart
{
public:
    virtual ~PolygonSearchPart() = default;

    /// Calls visit(polygon) for each active polygon that a sphere centred at p is to be tested
    /// with, in ascending order.
    virtual void search(const Eigen::Vector3d& p, PolygonVisitor& visit) const = 0;

    /// To be called after polygons have been discarded.
    virtual void update() {}
};

/// What is searched; all of it outlives the part.
struct SearchedPolygons
{
    const Surface& surface;
    const std::vector<PolygonState>& states;
    const TriangleGrid* grid = nullptr; ///< may be missing where the search does not need it
    /// How near to the edge of its part of space a centre may be to a polygon of the next and still
    /// has to be tested with it [r].
    double reach = 0;
};

[[nodiscard]] std::unique_ptr<PolygonSearchPart>
makePolygonSearch(PolygonSearch search, const SearchedPolygons& polygons);

} // namespace frostfill
