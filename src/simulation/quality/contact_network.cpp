// SPDX-License-Identifier: MIT
#include "simulation/quality/contact_network.hpp"

#include "base/threads.hpp"
#include "mesh/connectivity.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace frostfill
{

namespace
{

double distanceToEdge(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
    const Eigen::Vector3d along = b - a;
    const double share = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (p - a - share * along).norm();
}

/// Edges of near triangles, by the vertices at their ends, the lower one first.
using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// Pieces into which triangles fall that meet at these edges. Each edge has the number of its
/// triangle, below `triangles`.
std::uint32_t piecesOf(std::size_t triangles, std::vector<std::pair<Edge, std::size_t>>& edges)
{
    DisjointSets sets(triangles);
    std::sort(edges.begin(), edges.end());
    auto pieces = static_cast<std::uint32_t>(triangles);
    for (std::size_t k = 1; k < edges.size(); ++k)
    {
        if (edges[k - 1].first == edges[k].first && sets.join(edges[k - 1].second, edges[k].second))
        {
            --pieces;
        }
    }
    return pieces;
}

} // namespace

std::uint32_t wallPieces(const Surface& surface, std::span<const std::uint32_t> triangles,
                         const Eigen::Vector3d& p, double reach, double onWall)
{
    std::size_t count = 0;
    std::vector<std::pair<Edge, std::size_t>> edges;
    for (const std::uint32_t t : triangles)
    {
        const auto& corner = surface[t].corner;
        const double distance =
            (p - closestPointOnTriangle(p, corner[0], corner[1], corner[2]).point).norm();
        if (distance > reach || distance <= onWall)
        {
            continue;
        }
        const auto& vertices = surface.mesh().triangles[t];
        for (std::size_t k = 0; k < 3; ++k)
        {
            const std::size_t next = (k + 1) % 3;
            if (distanceToEdge(p, corner[k], corner[next]) <= reach)
            {
                edges.push_back({std::minmax(vertices[k], vertices[next]), count});
            }
        }
        ++count;
    }
    return piecesOf(count, edges);
}

namespace
{

std::uint32_t spheresBeside(const World& world, std::uint32_t id, const Eigen::Vector3d& p)
{
    std::uint32_t count = 0;
    forEachSphereBeside(world.spheres.resting(), id, p, world.spheres.radius(id),
                        [&](std::uint32_t, const Eigen::Vector3d& apart, double)
                        { count += apart.isZero(0) ? 0 : 1; });
    return count;
}

std::uint32_t wallsBeside(const World& world, std::uint32_t id, const Eigen::Vector3d& p)
{
    const double reach = world.spheres.radius(id) * (1 + kContactGap);
    std::vector<std::uint32_t> nearby;
    return wallPieces(world.surface, world.triangles.near(p, reach, nearby), p, reach, kOnWall);
}

} // namespace

std::uint32_t restingContacts(const World& world, std::uint32_t id)
{
    const Eigen::Vector3d p = world.spheres.position(id);
    if (world.spheres.isRunning(id) || !p.allFinite())
    {
        return 0;
    }
    return spheresBeside(world, id, p) + wallsBeside(world, id, p);
}

namespace
{

constexpr std::size_t kLookedAtTogether = 1024; // spheres that one thread looks at in one go

using Contacts = std::vector<ContactNetwork::Contact>;

/// With spheres of lower rows, so that those of two are added once.
void addSpheresBeside(const SphereGrid& resting, std::uint32_t row, Contacts& contacts)
{
    const double radius = resting[row].radius;
    forEachSphereBeside(resting, resting.id(row), resting[row].position(), radius,
                        [&](std::uint32_t other, const Eigen::Vector3d& apart, double depth)
                        {
                            const double gap =
                                kContactGap * std::min(radius, resting[other].radius);
                            if (other < row && depth > -gap && !apart.isZero(0))
                            {
                                contacts.push_back({apart.normalized(), row, other});
                            }
                        });
}

void addWallsBeside(const World& world, std::uint32_t row, Contacts& contacts)
{
    const Ball& ball = world.spheres.resting()[row];
    std::vector<Eigen::Vector3d> normals;
    std::vector<std::uint32_t> nearby;
    forEachTriangleBeside(world, ball.position(), ball.radius, nearby,
                          [&](std::uint32_t, const Eigen::Vector3d& away, double distance)
                          { addNormal(normals, away, distance); });
    for (const Eigen::Vector3d& normal : normals)
    {
        contacts.push_back({normal, row, ContactNetwork::kWall});
    }
}

} // namespace

ContactNetwork networkAtRest(const World& world, Threads& threads)
{
    const SphereGrid& resting = world.spheres.resting();
    const std::size_t count = resting.size();
    ContactNetwork network;
    network.rollingFriction = rollingFrictionOf(world.scene);
    network.bodies.resize(count);
    std::vector<Contacts> parts(count / kLookedAtTogether + 1);
    forEachPart(threads, count, kLookedAtTogether,
                [&](std::size_t first, std::size_t last, std::size_t part)
                {
                    for (auto row = static_cast<std::uint32_t>(first); row < last; ++row)
                    {
                        const Ball& ball = resting[row];
                        network.bodies[row] = {world.pull.direction(ball.position()), ball.radius};
                        addSpheresBeside(resting, row, parts[part]);
                        addWallsBeside(world, row, parts[part]);
                    }
                });
    for (const Contacts& part : parts)
    {
        network.contacts.insert(network.contacts.end(), part.begin(), part.end());
    }
    return network;
}

} // namespace frostfill
