// SPDX-License-Identifier: MIT
#include "render/picture/occluder_grid.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace frostfill
{
namespace
{

/// So many, and so large a part of all, are looked at one by one before cells are built anew.
constexpr std::size_t kMostInList = 16;
constexpr std::size_t kPartInList = 128;

constexpr float kMostAlong = 1000; ///< cells along an axis

glm::vec4 ballOf(const SphereInstance& sphere)
{
    return {sphere.x, sphere.y, sphere.z, sphere.radius};
}

} // namespace

void OccluderGrid::start(std::span<const SphereInstance> spheres)
{
    spheres_.clear();
    spheres_.reserve(spheres.size());
    std::transform(spheres.begin(), spheres.end(), std::back_inserter(spheres_), ballOf);
    build();
}

void OccluderGrid::add(const SphereInstance& sphere)
{
    spheres_.push_back(ballOf(sphere));
    largest_ = std::max(largest_, sphere.radius);
    const std::size_t inList = spheres_.size() - inCells_.size();
    if (inList > kMostInList + inCells_.size() / kPartInList)
    {
        build();
    }
}

glm::ivec3 OccluderGrid::placeOf(const glm::vec3& point) const
{
    const glm::vec3 place = glm::floor((point - corner_) / cell_);
    return glm::ivec3(glm::clamp(place, glm::vec3(0), glm::vec3(cells_ - 1)));
}

std::size_t OccluderGrid::rowOf(int y, int z) const
{
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(cells_.y) +
            static_cast<std::size_t>(y)) *
           static_cast<std::size_t>(cells_.x);
}

std::size_t OccluderGrid::cellOf(std::size_t sphere) const
{
    const glm::ivec3 place = placeOf(glm::vec3(spheres_[sphere]));
    return rowOf(place.y, place.z) + static_cast<std::size_t>(place.x);
}

void OccluderGrid::build()
{
    glm::vec3 low(std::numeric_limits<float>::infinity());
    glm::vec3 high = -low;
    largest_ = 0;
    for (const glm::vec4& sphere : spheres_)
    {
        low = glm::min(low, glm::vec3(sphere));
        high = glm::max(high, glm::vec3(sphere));
        largest_ = std::max(largest_, sphere.w);
    }
    inCells_.resize(spheres_.size());
    if (spheres_.empty())
    {
        cells_ = glm::ivec3(1);
        begins_.assign(2, 0);
        return;
    }
    // Not many more cells than spheres.
    const glm::vec3 edges = high - low;
    const auto count = static_cast<float>(spheres_.size());
    corner_ = low;
    cell_ = std::max({2 * largest_, std::cbrt(edges.x * edges.y * edges.z / count),
                      std::max({edges.x, edges.y, edges.z}) / kMostAlong, 1e-6F});
    cells_ = glm::ivec3(glm::floor(edges / cell_)) + 1;
    begins_.assign(rowOf(0, cells_.z) + 2, 0);
    for (std::size_t i = 0; i < spheres_.size(); ++i)
    {
        ++begins_[cellOf(i) + 2];
    }
    for (std::size_t cell = 2; cell < begins_.size(); ++cell)
    {
        begins_[cell] += begins_[cell - 1];
    }
    // What is counted one further on moves to the end of each cell, which is where the next begins.
    for (std::uint32_t i = 0; i < spheres_.size(); ++i)
    {
        inCells_[begins_[cellOf(i) + 1]++] = i;
    }
}

std::size_t OccluderGrid::indexOf(const SphereInstance& sphere) const
{
    std::size_t found = spheres_.size();
    const glm::vec4 ball = ballOf(sphere);
    eachIn(
        glm::vec3(ball), glm::vec3(ball), [](const glm::vec3&, float) { return true; },
        [&](std::uint32_t i) { found = spheres_[i] == ball ? i : found; });
    return found;
}

} // namespace frostfill
