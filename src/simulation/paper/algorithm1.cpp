// SPDX-License-Identifier: MIT
#include "simulation/paper/algorithm1.hpp"

#include "simulation/paper/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

// Compiles a function for several instruction sets and picks one at run time. None of them fuses
// multiplications with additions, so all give the same bits. Sanitizers are not ready when the
// choice is made, so they get the portable code alone.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) &&                             \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define FROSTFILL_INSTRUCTION_SETS [[gnu::target_clones("avx2", "default")]]
#else
#define FROSTFILL_INSTRUCTION_SETS
#endif

namespace frostfill
{
namespace
{

/// Mass of a sphere as the paper's preset has always rounded it. Where radii differ, massOf rounds
/// differently in the last bit, and every result of such a run would change with it.
double massInPaper(double radius)
{
    return std::pow(radius, 3);
}

using Four = double __attribute__((vector_size(32)));
using FourFlags = std::int64_t __attribute__((vector_size(32)));

// Written to an argument: what a vector is returned in would depend on the instruction set.
inline void loadFour(Four& four, const double* values)
{
    std::memcpy(&four, values, sizeof four);
}

// Where the first whole block begins that has a sphere in contact with one at p; past the last
// whole block when none has. The sign of a difference is exact, so this finds the contacts that a
// test one by one does.
FROSTFILL_INSTRUCTION_SETS
std::size_t firstBlockInContact(const Algorithm1::FourAtOnce& s, const Eigen::Vector3d& p, double r,
                                std::size_t begin, std::size_t end)
{
    const double x = p.x();
    const double y = p.y();
    const double z = p.z();
    for (; begin + kBlock <= end; begin += kBlock)
    {
        FourFlags any = {};
        for (const std::size_t at : {begin, begin + 4})
        {
            Four dx, dy, dz, contact;
            loadFour(dx, s.x.data() + at);
            loadFour(dy, s.y.data() + at);
            loadFour(dz, s.z.data() + at);
            loadFour(contact, s.radius.data() + at);
            dx -= x;
            dy -= y;
            dz -= z;
            contact += r;
            any |= dx * dx + dy * dy + dz * dz - contact * contact < 0;
        }
        if ((any[0] | any[1] | any[2] | any[3]) != 0)
        {
            return begin;
        }
    }
    return begin;
}

// The contact with a two-sided wall, whichever side the sphere was on before this step.
Contact contactFrom(const Eigen::Vector3d& before, const SignedDistance& here,
                    const Eigen::Vector3d& p, double radius)
{
    SignedDistance wall = here;
    if ((before - wall.closest).dot(p - wall.closest) < 0)
    {
        wall.value = -wall.value;
    }
    return wallContact(wall, p, radius);
}

} // namespace

Algorithm1::Algorithm1(Spheres& spheres, const Surface& surface, PolygonSearchPart& polygons,
                       const Restitution& restitution, bool byGrid)
    : spheres_(spheres), running_(spheres.running()), surface_(surface), polygons_(polygons),
      restitution_(restitution), byGrid_(byGrid)
{
}

void Algorithm1::runningRunning(OperationCounts& counts)
{
    const std::span<Eigen::Vector3d> p = running_.position.all();
    const std::span<Eigen::Vector3d> v = running_.velocity.all();
    const std::span<const double> radius = running_.radius.all();
    const std::uint64_t running = p.size();
    std::uint64_t responses = 0;
    for (std::size_t i = 0; i < running; ++i)
    {
        for (std::size_t j = i + 1; j < running; ++j)
        {
            const double dx = p[i].x() - p[j].x();
            const double dy = p[i].y() - p[j].y();
            const double dz = p[i].z() - p[j].z();
            const double reach = radius[i] + radius[j];
            // Summed up from the left, which Eigen does not do: the bits are those of this loop.
            const double squared = dx * dx + dy * dy + dz * dz;
            if (squared >= reach * reach)
            {
                continue;
            }
            const Contact contact = contactOfSpheres({dx, dy, dz}, squared, reach);
            const Eigen::Vector3d normal = separationDirection(contact);
            const double mj = massInPaper(radius[j]);
            const double shareOfI = mj / (massInPaper(radius[i]) + mj);
            p[i] += normal * (contact.depth * shareOfI);
            p[j] -= normal * (contact.depth * (1 - shareOfI));
            const double approach = (v[i] - v[j]).dot(normal);
            if (approach < 0)
            {
                const double change = restitution_.change(approach);
                v[i] += normal * (change * shareOfI);
                v[j] -= normal * (change * (1 - shareOfI));
            }
            touched_[i] = true;
            touched_[j] = true;
            responses += 2;
        }
    }
    counts.runningRunningTests += running * (running - std::min<std::uint64_t>(running, 1)) / 2;
    counts.runningRunningResponses += responses;
}

inline std::uint64_t Algorithm1::respondToFrozen(std::uint32_t i, std::size_t begin,
                                                 std::size_t end)
{
    std::uint64_t responses = 0;
    for (std::size_t j = begin; j < end; ++j)
    {
        const Ball& frozen = spheres_.resting()[static_cast<std::uint32_t>(j)];
        const auto contact = sphereContact(running_.position[i] - frozen.position(),
                                           running_.radius[i] + frozen.radius);
        if (contact)
        {
            respond(i, *contact);
            ++responses;
        }
    }
    return responses;
}

// In the preset paper spheres at rest stay where they are.
void Algorithm1::followRest()
{
    const SphereGrid& resting = spheres_.resting();
    for (auto row = static_cast<std::uint32_t>(frozen_.x.size()); row < resting.size(); ++row)
    {
        frozen_.x.push_back(resting[row].x);
        frozen_.y.push_back(resting[row].y);
        frozen_.z.push_back(resting[row].z);
        frozen_.radius.push_back(resting[row].radius);
    }
}

void Algorithm1::findNear(std::uint32_t i, std::size_t begin)
{
    ids_.clear();
    spheres_.resting().forEachNear(running_.position[i], running_.radius[i] + kGridReach,
                                   [&](std::uint32_t id)
                                   {
                                       if (id >= begin)
                                       {
                                           ids_.push_back(id);
                                       }
                                   });
    std::sort(ids_.begin(), ids_.end());
    ranges_.clear();
    for (const std::size_t id : ids_)
    {
        if (ranges_.empty() || ranges_.back().end != id)
        {
            ranges_.push_back({id, id});
        }
        ++ranges_.back().end;
    }
}

void Algorithm1::runningFrozen(std::size_t frozenBegin, OperationCounts& counts)
{
    followRest();
    ranges_ = {{frozenBegin, spheres_.resting().size()}};
    for (std::uint32_t i = 0; i < running_.size(); ++i)
    {
        std::uint64_t responses = 0;
        if (byGrid_)
        {
            findNear(i, frozenBegin);
        }
        for (const IdRange& near : ranges_)
        {
            counts.runningFrozenTests += near.end - near.begin;
            responses += near.end - near.begin < kBlock
                             ? respondToFrozen(i, near.begin, near.end)
                             : respondToAllFrozen(i, near.begin, near.end);
        }
        counts.runningFrozenResponses += responses;
        touched_[i] = touched_[i] || responses > 0;
    }
}

std::uint64_t Algorithm1::respondToAllFrozen(std::uint32_t i, std::size_t begin, std::size_t end)
{
    std::uint64_t responses = 0;
    std::size_t j = begin;
    while ((j = firstBlockInContact(frozen_, running_.position[i], running_.radius[i], j, end)) +
               kBlock <=
           end)
    {
        responses += respondToFrozen(i, j, j + kBlock);
        j += kBlock;
    }
    return responses + respondToFrozen(i, j, end);
}

void Algorithm1::respond(std::uint32_t i, const Contact& contact)
{
    const Eigen::Vector3d normal = separationDirection(contact);
    running_.position[i] += normal * contact.depth;
    reflect(i, normal);
}

void Algorithm1::runningPolygons(const std::vector<Eigen::Vector3d>& before,
                                 OperationCounts& counts)
{
    for (std::uint32_t i = 0; i < running_.size(); ++i)
    {
        const std::uint64_t responses = collideWithPolygons(i, before[i], counts);
        counts.spherePolygonResponses += responses;
        touched_[i] = touched_[i] || responses > 0;
        // One shallow push off one wall cannot lead through another.
        if (responses > 1 || deepest_ > kShallow * running_.radius[i])
        {
            keepInside(i, before[i]);
        }
    }
}

std::uint64_t Algorithm1::collideWithPolygons(std::uint32_t i, const Eigen::Vector3d& before,
                                              OperationCounts& counts)
{
    Eigen::Vector3d p = running_.position[i];
    const double radius = running_.radius[i];
    const double reach = kNearby * radius;
    std::uint64_t responses = 0;
    nearby_.clear();
    deepest_ = 0;
    const std::span<const std::uint32_t> polygons = polygons_.near(p);
    counts.spherePolygonTests += polygons.size();
    for (const std::uint32_t polygon : polygons)
    {
        const TriangleBound& bound = surface_.bound(polygon);
        const double plane = bound.toPlane(p);
        const double centreSquared = bound.toCentreSquared(p);
        if (plane > reach || !bound.ballIsWithin(reach, centreSquared))
        {
            continue;
        }
        nearby_.push_back(polygon);
        const bool mayTouch = plane <= radius && bound.ballIsWithin(radius, centreSquared);
        if (const auto contact =
                mayTouch ? oneSidedContact(polygon, p, before, radius) : std::nullopt)
        {
            p += contact->normal * contact->depth;
            reflect(i, contact->normal);
            deepest_ = std::max(deepest_, contact->depth);
            ++responses;
        }
    }
    running_.position[i] = p;
    return responses;
}

// One-sided contact. In front of the wall the sphere is pushed away from the closest point. Behind
// it, it is pulled back through the closest point, provided that it was in front before this step:
// otherwise it belongs to another sheet of a thin wall.
std::optional<Contact> Algorithm1::oneSidedContact(std::uint32_t polygon, const Eigen::Vector3d& p,
                                                   const Eigen::Vector3d& before,
                                                   double radius) const
{
    const SignedDistance here = signedDistance(surface_, polygon, p);
    if (std::abs(here.value) >= radius)
    {
        return std::nullopt;
    }
    if (surface_[polygon].twoSided && here.value > 0)
    {
        return contactFrom(before, here, p, radius);
    }
    const Eigen::Vector3d inward = surface_.pseudonormal(polygon, here.feature);
    if (here.value == 0)
    {
        return Contact{inward.normalized(), radius};
    }
    if (here.value < 0 && (before - here.closest).dot(inward) < 0)
    {
        return std::nullopt;
    }
    return wallContact(here, p, radius);
}

void Algorithm1::reflect(std::uint32_t i, const Eigen::Vector3d& normal)
{
    Eigen::Vector3d& velocity = running_.velocity[i];
    const double approach = velocity.dot(normal);
    if (approach < 0)
    {
        velocity += normal * restitution_.change(approach);
    }
}

// Several walls, or walls and spheres, can push a centre through a wall that it had already been
// tested with: in a wedge narrower than the sphere every polygon undoes the other's work. Walls
// always win: such a step is taken back, and the sphere starts again from rest.
void Algorithm1::keepInside(std::uint32_t i, const Eigen::Vector3d& before)
{
    if (nearby_.empty())
    {
        return;
    }
    const double depth = nearestDistance(surface_, nearby_, running_.position[i]).value;
    const double smallest = kSmallestDepth * running_.radius[i];
    if (depth < smallest && nearestDistance(surface_, nearby_, before).value >= smallest)
    {
        running_.position[i] = before;
        running_.velocity[i].setZero();
    }
}

} // namespace frostfill
