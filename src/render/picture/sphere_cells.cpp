// SPDX-License-Identifier: MIT
#include "render/picture/sphere_cells.hpp"

#include "render/picture/for_all.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

/// Of a cell, in the mean. Fewer: more cells to place and order. More: more hidden spheres are
/// looked at.
constexpr double kInCell = 48;
constexpr std::uint32_t kMostInCell = 96;

constexpr int kIndexBits = 32;
constexpr int kAxisBits = 10;

/// The bits of a number of ten, two apart.
std::uint64_t spread(std::uint32_t value)
{
    std::uint64_t bits = 0;
    for (int k = 0; k < kAxisBits; ++k)
    {
        bits |= static_cast<std::uint64_t>(value >> k & 1U) << (3 * k);
    }
    return bits;
}

glm::vec3 centreOf(const SphereInstance& sphere)
{
    return {sphere.x, sphere.y, sphere.z};
}

struct Box
{
    glm::vec3 low, high;
};

Box boxOfCentres(std::span<const SphereInstance> spheres)
{
    Box box = {centreOf(spheres[0]), centreOf(spheres[0])};
    for (const SphereInstance& sphere : spheres)
    {
        box.low = glm::min(box.low, centreOf(sphere));
        box.high = glm::max(box.high, centreOf(sphere));
    }
    return box;
}

SphereInstance around(std::span<const SphereInstance> spheres)
{
    const auto [low, high] = boxOfCentres(spheres);
    const glm::vec3 middle = 0.5F * (low + high);
    float reach = 0;
    for (const SphereInstance& sphere : spheres)
    {
        reach = std::max(reach, glm::length(centreOf(sphere) - middle) + sphere.radius);
    }
    return {middle.x, middle.y, middle.z, 1.0001F * reach, 0};
}

/// Above each place the number of its cell along a curve that keeps neighbours together.
std::vector<std::uint64_t> keyed(std::span<const SphereInstance> spheres)
{
    const auto [low, high] = boxOfCentres(spheres);
    const glm::dvec3 size = glm::max(glm::dvec3(high - low), 1e-6);
    const double cells = static_cast<double>(spheres.size()) / kInCell;
    constexpr float kLast = (1 << kAxisBits) - 1;
    const auto perLength = static_cast<float>(std::cbrt(cells / (size.x * size.y * size.z)));
    std::vector<std::uint64_t> keys(spheres.size());
    forAll(spheres.size(), kSpheresPerTask,
           [&, low = low](std::size_t i)
           {
               const glm::vec3 way = centreOf(spheres[i]) - low;
               const glm::uvec3 place(glm::clamp(perLength * way, 0.0F, kLast));
               const std::uint64_t cell =
                   spread(place.x) | spread(place.y) << 1 | spread(place.z) << 2;
               keys[i] = cell << kIndexBits | i;
           });
    return keys;
}

} // namespace

CellOrder orderByCells(std::span<const SphereInstance> spheres)
{
    CellOrder result;
    if (spheres.empty())
    {
        return result;
    }
    std::vector<std::uint64_t> keys = keyed(spheres);
    tbb::parallel_sort(keys.begin(), keys.end());
    const auto count = static_cast<std::uint32_t>(keys.size());
    for (std::uint32_t first = 0; first < count;)
    {
        std::uint32_t end = first + 1;
        while (end < count && end - first < kMostInCell &&
               keys[end] >> kIndexBits == keys[first] >> kIndexBits)
        {
            ++end;
        }
        result.cells.push_back({first, end, {}});
        first = end;
    }
    forAll(result.cells.size(), kSpheresPerTask / kMostInCell,
           [&](std::size_t c)
           {
               SphereCell& cell = result.cells[c];
               std::vector<SphereInstance> own;
               for (std::uint32_t i = cell.first; i < cell.end; ++i)
               {
                   own.push_back(spheres[static_cast<std::uint32_t>(keys[i])]);
               }
               cell.around = around(own);
           });
    result.order.assign(keys.begin(), keys.end()); // without the keys
    return result;
}

} // namespace frostfill
