// SPDX-License-Identifier: MIT
#include "simulation/quality/contact_network.hpp"

#include "simulation/quality/resting_contacts.hpp"

#include <algorithm>

namespace frostfill
{
namespace
{

constexpr std::size_t kLookedAtTogether = 1024; // spheres that one thread looks at in one go

/// The contacts of some spheres, those of two once.
class NetworkPart
{
public:
    void look(const World& world, std::uint32_t begin, std::uint32_t end)
    {
        for (std::uint32_t row = begin; row < end; ++row)
        {
            meetSpheres(world.spheres.resting(), row);
            meetWalls(world, row);
        }
    }
    [[nodiscard]] const std::vector<ContactNetwork::Contact>& contacts() const { return contacts_; }

private:
    void meetSpheres(const SphereGrid& resting, std::uint32_t row)
    {
        const double radius = resting[row].radius;
        forEachSphereBeside(resting, resting.id(row), resting[row].position(), radius,
                            [&](std::uint32_t other, const Eigen::Vector3d& apart, double depth)
                            {
                                const double gap =
                                    kContactGap * std::min(radius, resting[other].radius);
                                if (other < row && depth > -gap && !apart.isZero(0))
                                {
                                    contacts_.push_back({apart.normalized(), row, other});
                                }
                            });
    }
    void meetWalls(const World& world, std::uint32_t row)
    {
        const Ball& ball = world.spheres.resting()[row];
        normals_.clear();
        forEachTriangleBeside(world, ball.position(), ball.radius, nearby_,
                              [&](std::uint32_t, const Eigen::Vector3d& away, double distance)
                              { addNormal(normals_, away, distance); });
        for (const Eigen::Vector3d& normal : normals_)
        {
            contacts_.push_back({normal, row, ContactNetwork::kWall});
        }
    }

    std::vector<ContactNetwork::Contact> contacts_;
    std::vector<Eigen::Vector3d> normals_;
    std::vector<std::uint32_t> nearby_;
};

} // namespace

ContactNetwork networkAtRest(const World& world, Threads& threads)
{
    const SphereGrid& resting = world.spheres.resting();
    const std::size_t count = resting.size();
    ContactNetwork network;
    network.rollingFriction = rollingFrictionOf(world.scene);
    network.bodies.resize(count);
    std::vector<NetworkPart> parts(count / kLookedAtTogether + 1);
    forEachPart(threads, count, kLookedAtTogether,
                [&](std::size_t first, std::size_t last, std::size_t part)
                {
                    for (std::size_t row = first; row < last; ++row)
                    {
                        const Ball& ball = resting[static_cast<std::uint32_t>(row)];
                        network.bodies[row] = {world.pull.direction(ball.position()), ball.radius};
                    }
                    parts[part].look(world, static_cast<std::uint32_t>(first),
                                     static_cast<std::uint32_t>(last));
                });
    for (const NetworkPart& part : parts)
    {
        network.contacts.insert(network.contacts.end(), part.contacts().begin(),
                                part.contacts().end());
    }
    return network;
}

} // namespace frostfill
