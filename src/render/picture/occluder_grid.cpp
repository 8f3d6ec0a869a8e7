// SPDX-License-Identifier: MIT
#include "render/picture/occluder_grid.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <bit>

namespace frostfill
{

void OccluderGrid::add(const SphereInstance& sphere)
{
    spheres_.push_back(sphere);
    if (sphere.radius > largest_ || spheres_.size() > heads_.size())
    {
        largest_ = std::max(largest_, 1.2F * sphere.radius);
        rebuild();
        return;
    }
    enter(static_cast<std::uint32_t>(spheres_.size() - 1));
}

void OccluderGrid::enter(std::uint32_t sphere)
{
    const SphereInstance& own = spheres_[sphere];
    cells_.push_back(placeOf({own.x, own.y, own.z}));
    std::uint32_t& head = heads_[cellOf(cells_.back())];
    nexts_.push_back(head);
    head = sphere + 1;
}

glm::ivec3 OccluderGrid::placeOf(const glm::vec3& point) const
{
    return glm::ivec3(glm::floor(glm::clamp(point / cell_, glm::vec3(-1e6F), glm::vec3(1e6F))));
}

std::uint32_t OccluderGrid::cellOf(const glm::ivec3& place) const
{
    const std::uint32_t hash = static_cast<std::uint32_t>(place.x) * 73856093U ^
                               static_cast<std::uint32_t>(place.y) * 19349663U ^
                               static_cast<std::uint32_t>(place.z) * 83492791U;
    return hash & static_cast<std::uint32_t>(heads_.size() - 1);
}

void OccluderGrid::rebuild()
{
    cell_ = std::max(2 * largest_, 1e-6F);
    heads_.assign(std::bit_ceil(std::max<std::size_t>(2 * spheres_.size(), 1024)), 0);
    nexts_.clear();
    cells_.clear();
    for (std::uint32_t i = 0; i < spheres_.size(); ++i)
    {
        enter(i);
    }
}

std::size_t OccluderGrid::indexOf(const SphereInstance& sphere) const
{
    std::size_t found = spheres_.size();
    const glm::vec3 centre(sphere.x, sphere.y, sphere.z);
    const auto test = [&](std::uint32_t i)
    {
        const SphereInstance& other = spheres_[i];
        if (other.x == sphere.x && other.y == sphere.y && other.z == sphere.z &&
            other.radius == sphere.radius)
        {
            found = i;
        }
    };
    if (!spheres_.empty())
    {
        visitCell(placeOf(centre), test);
    }
    return found;
}

} // namespace frostfill
