// SPDX-License-Identifier: MIT
#include <simulation/spheres.hpp>

namespace frostfill
{

void Spheres::moveTo(std::size_t from, std::size_t to)
{
    for (auto* values : {&x, &y, &z, &vx, &vy, &vz, &radius})
    {
        (*values)[to] = (*values)[from];
    }
    state[to] = state[from];
}

void Spheres::removeLast()
{
    for (auto* values : {&x, &y, &z, &vx, &vy, &vz, &radius})
    {
        values->pop_back();
    }
    group.pop_back();
    state.pop_back();
}

void Spheres::reserve(std::size_t count)
{
    for (auto* values : {&x, &y, &z, &vx, &vy, &vz, &radius})
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
    vx.push_back(0);
    vy.push_back(0);
    vz.push_back(0);
    radius.push_back(r);
    group.push_back(groupOfSphere);
    state.push_back(SphereState::running);
    return static_cast<std::uint32_t>(size() - 1);
}

} // namespace frostfill
