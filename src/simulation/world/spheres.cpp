// SPDX-License-Identifier: MIT
#include "simulation/world/spheres.hpp"

namespace frostfill
{

void Spheres::moveTo(std::size_t from, std::size_t to)
{
    for (auto* values : {&x, &y, &z, &radius})
    {
        (*values)[to] = (*values)[from];
    }
    setVelocity(to, velocity(from));
    setState(to, state[from]);
}

void Spheres::setState(std::size_t i, SphereState newState)
{
    const bool ran = state[i] == SphereState::running;
    const bool runs = newState == SphereState::running;
    if (ran && !runs)
    {
        velocities.stop(i);
    }
    if (!ran && runs)
    {
        velocities.start(i);
    }
    state[i] = newState;
}

void Spheres::removeLast()
{
    if (state.back() == SphereState::running)
    {
        velocities.stop(size() - 1);
    }
    for (auto* values : {&x, &y, &z, &radius})
    {
        values->pop_back();
    }
    group.pop_back();
    state.pop_back();
}

void Spheres::reserve(std::size_t count)
{
    for (auto* values : {&x, &y, &z, &radius})
    {
        values->reserve(count);
    }
    group.reserve(count);
    state.reserve(count);
}

std::uint32_t Spheres::add(const Eigen::Vector3d& p, double r, std::uint32_t groupOfSphere)
{
    x.push_back(p.x());
    y.push_back(p.y());
    z.push_back(p.z());
    radius.push_back(r);
    group.push_back(groupOfSphere);
    state.push_back(SphereState::running);
    velocities.start(size() - 1);
    return static_cast<std::uint32_t>(size() - 1);
}

} // namespace frostfill
