// SPDX-License-Identifier: MIT
#include "run/falling_spheres.hpp"

#include "mesh/interior/triangle_bvh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frostfill
{
namespace
{

/// Of a sphere at its ceiling, from its middle to the wall; more than 1, as ceilings slope [r].
constexpr double kBelowCeiling = 1.5;

/// How far it is straight up to the next wall.
class Ceilings
{
public:
    /// `up` is an axis of the mesh, which lives as long as this.
    Ceilings(const TriangleMesh& mesh, const Eigen::Vector3d& up)
        : mesh_(mesh), tree_(mesh), top_(up.dot(boundingBox(mesh).max()))
    {
        up.maxCoeff(&up_);
    }

    /// [mesh unit] From p, in mesh coordinates, straight up to the mesh; 0 where nothing is above.
    [[nodiscard]] double above(const Eigen::Vector3d& p) const
    {
        Eigen::Vector3d end = p;
        end[up_] = std::max(top_, p[up_]);
        double nearest = std::numeric_limits<double>::infinity();
        tree_.forEachTriangleOnWay(p, end, 0,
                                   [&](std::uint32_t triangle)
                                   {
                                       const double height = heightOver(triangle, p) - p[up_];
                                       nearest = height > 0 ? std::min(nearest, height) : nearest;
                                   });
        return std::isfinite(nearest) ? nearest : 0;
    }

private:
    /// Returns the height of the triangle over p; none if it is not over p.
    [[nodiscard]] double heightOver(std::uint32_t triangle, const Eigen::Vector3d& p) const
    {
        const auto& [a, b, c] = mesh_.triangles[triangle];
        const int x = (up_ + 1) % 3;
        const int y = (up_ + 2) % 3;
        const auto side = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to)
        { return (to[x] - from[x]) * (p[y] - from[y]) - (to[y] - from[y]) * (p[x] - from[x]); };
        const Eigen::Vector3d& u = mesh_.vertices[a];
        const Eigen::Vector3d& v = mesh_.vertices[b];
        const Eigen::Vector3d& w = mesh_.vertices[c];
        const Eigen::Vector3d shares(side(v, w), side(w, u), side(u, v));
        const bool over = (shares.array() >= 0).all() || (shares.array() <= 0).all();
        const double sum = shares.x() + shares.y() + shares.z();
        return over && sum != 0
                   ? (shares.x() * u[up_] + shares.y() * v[up_] + shares.z() * w[up_]) / sum
                   : -std::numeric_limits<double>::infinity();
    }

    const TriangleMesh& mesh_;
    TriangleBvh tree_;
    double top_; ///< of the mesh, along the axis
    int up_ = 1; ///< axis
};

} // namespace

FallingSpheres::FallingSpheres(std::vector<Landing> landings, const TriangleMesh& mesh,
                               const Scene& scene, double lag)
    : landings_(std::move(landings)), up_(upVector(scene.object.up)), lag_(lag)
{
    const Ceilings ceilings(mesh, up_);
    double highest = 0;
    heights_.reserve(landings_.size());
    for (const Landing& landing : landings_)
    {
        const double height =
            std::max(0.0, ceilings.above(landing.place) - kBelowCeiling * landing.radius);
        heights_.push_back(static_cast<float>(height));
        highest = std::max(highest, height);
    }
    pull_ = std::max(2 * highest / (lag * lag), std::numeric_limits<double>::min());
}

std::size_t FallingSpheres::landedUntil(double time) const
{
    const auto later = [](double t, const Landing& landing) { return t < landing.time; };
    return static_cast<std::size_t>(
        std::upper_bound(landings_.begin(), landings_.end(), time, later) - landings_.begin());
}

void FallingSpheres::takeFrom(Snapshot& snapshot, std::size_t real)
{
    snapshot.resize(std::min(real, snapshot.centres.size()));
}

std::size_t FallingSpheres::addTo(Snapshot& snapshot, double now) const
{
    const std::size_t landed = std::min(landedUntil(now), snapshot.centres.size());
    const std::size_t end = std::max(landed, landedUntil(now + lag_));
    for (std::size_t id = landed; id < snapshot.centres.size(); ++id)
    {
        --snapshot.count(snapshot.states[id]);
    }
    snapshot.resize(end);
    snapshot.waiting.resize(end);
    auto& changed = snapshot.changed;
    changed.erase(std::lower_bound(changed.begin(), changed.end(), landed), changed.end());
    for (std::size_t id = landed; id < end; ++id)
    {
        put(snapshot, id, now);
        changed.push_back(static_cast<std::uint32_t>(id));
    }
    snapshot.time = now + lag_;
    return landed;
}

SphereRecord FallingSpheres::sphere(std::size_t id) const
{
    const Landing& landing = landings_[id];
    SphereRecord sphere;
    sphere.centre = landing.place;
    sphere.radius = landing.radius;
    sphere.group = landing.group;
    return sphere;
}

void FallingSpheres::put(Snapshot& snapshot, std::size_t id, double now) const
{
    const Landing& landing = landings_[id];
    const double height = heights_[id];
    const double fall = std::sqrt(2 * height / pull_);
    const double fallen = fall - (landing.time - now); // [s] since it began to fall
    const double down = std::min(height, fallen > 0 ? pull_ * fallen * fallen / 2 : 0);
    const Eigen::Vector3d place = landing.place + (height - down) * up_;
    snapshot.centres[id] = (place - snapshot.origin).cast<float>();
    snapshot.radii[id] = static_cast<float>(landing.radius);
    snapshot.waiting[id] = fallen > 0 ? 0 : 1;
    snapshot.states[id] = SphereState::running;
    snapshot.groups[id] = landing.group;
    for (ColumnValues& values : snapshot.columns)
    {
        values.bits[id] = 0;
    }
    snapshot.speeds[id] = static_cast<float>(fallen > 0 ? pull_ * fallen : 0);
    snapshot.running += fallen > 0 ? 1 : 0;
}

} // namespace frostfill
