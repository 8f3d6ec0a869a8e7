// SPDX-License-Identifier: MIT
#include "simulation/motion/drop_and_roll.hpp"

#include "simulation/contact/contact.hpp"
#include "simulation/contact/depenetration.hpp"
#include "simulation/contact/sphere_cast.hpp"
#include "simulation/motion/tolerances.hpp"
#include "simulation/motion/vertical_drop.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{

bool DropAndRoll::settle(Eigen::Vector3d& p, double radius, NeighbourList& around, double farthest,
                         Eigen::AlignedBox3d* seen) const
{
    const Path path{radius, around, seen};
    const Eigen::Vector3d start = p;
    double longest = kLongestSlide * radius;
    const bool sizesDiffer = world_.radii.curve().has_value();
    const double shortestLook = kShortestLook * (sizesDiffer ? std::min(1.0, 2 * radius) : 1);
    thread_local std::vector<Eigen::Vector3d> normals; // keeps its memory
    // A path loses height with every step, so it ends; the bound is for wedges that Newton's method
    // enters ever more slowly.
    const auto bound = static_cast<std::uint64_t>(kStepsPerPath +
                                                  kStepsPerRadiusOfHeight * world_.height / radius);
    for (std::uint64_t step = 0; step < bound; ++step)
    {
        look(path, p, shortestLook);
        p += contactNormals(world_.surface, around, p, radius, kTouch, normals);
        const Eigen::Vector3d down = world_.pull.direction(p);
        const Eigen::Vector3d pull = projectToFree(down, normals);
        if (pull.norm() <= kSettled)
        {
            return true; // carried: see isCarried, which has no use for the pull
        }
        if (!(normals.empty() ? fall(p, path, down) : slide(p, path, down, pull, longest)))
        {
            return false;
        }
        if ((p - start).squaredNorm() > farthest * farthest)
        {
            return false;
        }
    }
    return false;
}

// A list that is up to date was looked for before, and is in the box already.
void DropAndRoll::look(const Path& path, const Eigen::Vector3d& p, double ahead) const
{
    const bool anew = path.around.ensure(world_, p, path.radius, ahead);
    if (anew && path.seen != nullptr)
    {
        addSeen(*path.seen, p, path.radius + NeighbourList::kSkin);
    }
}

bool DropAndRoll::fall(Eigen::Vector3d& p, const Path& path, const Eigen::Vector3d& down) const
{
    if (down.y() == -1)
    {
        return drop(p, path.radius, path.seen);
    }
    p += sphereCast(world_.surface, path.around, p, path.radius, down, path.around.room(p)) * down;
    return true;
}

bool DropAndRoll::drop(Eigen::Vector3d& p, double radius, Eigen::AlignedBox3d* seen) const
{
    const std::optional<double> y = contactBelow(world_, p, radius);
    if (seen != nullptr)
    {
        addSeen(*seen, p, radius);
        const double end = y.value_or(-std::numeric_limits<double>::infinity());
        addSeen(*seen, {p.x(), end, p.z()}, radius);
    }
    p.y() = y.value_or(p.y());
    return y.has_value();
}

// A straight part along the pull, then back to the contact that curves away from it. Both lose
// height: the second leads against the contacts' forces, whose sum points up.
bool DropAndRoll::slide(Eigen::Vector3d& p, const Path& path, const Eigen::Vector3d& down,
                        const Eigen::Vector3d& pull, double& longest) const
{
    const auto& [radius, around, seen] = path;
    const double weight = pull.norm();
    const Eigen::Vector3d along = pull / weight;
    // Near the bottom of a curve the pull fades with the distance to it.
    const double length = std::min({longest, kBeyondTheBottom * weight * radius, around.room(p)});
    const double gone = sphereCast(world_.surface, around, p, radius, along, length);
    p += gone * along;

    const Eigen::Vector3d forces = pull - down;
    const double force = forces.norm();
    if (force > kSettled)
    {
        // A contact that curves away is behind by about the square of the part.
        look(path, p, gone * gone / radius);
        const Eigen::Vector3d back = -forces / force;
        const double limit = std::min(kRegain * radius, around.room(p));
        const double regained = sphereCast(world_.surface, around, p, radius, back, limit);
        if (regained < limit)
        {
            p += regained * back;
        }
    }
    if (gone < kShortestSlide * weight * radius)
    {
        longest /= 2;
        return longest > kShortestSlide * radius;
    }
    longest = kLongestSlide * radius;
    return true;
}

} // namespace frostfill
