// SPDX-License-Identifier: MIT
#include "simulation/solver/broad_phase.hpp"

#include "simulation/contact/contact.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace frostfill
{

bool BroadPhase::mayTouch(const Eigen::Vector3d& a, double radiusOfA, const Eigen::Vector3d& b,
                          double radiusOfB) const
{
    return isWithin(a, b, radiusOfA + radiusOfB + margin_);
}

void BroadPhase::findPairs(const Found& found)
{
    findPairs(running_.radius.all(), found);
}

// Many runners are looked at in the order of cells, as neighbours then lie in memory together.
void BroadPhase::findPairs(std::span<const double> radii, const Found& found)
{
    radii_ = radii;
    const std::uint32_t size = running_.size();
    if (size <= kFewRunners)
    {
        findAmongAll();
    }
    else
    {
        layOutCells();
        sortIntoCells();
        const bool sizesDiffer = usual_ < 1;
        threads_.forEach(size,
                         [&](std::size_t i)
                         {
                             const Node& node = nodes_.values()[i];
                             sizesDiffer ? findSmaller(node) : findNear(node);
                         });
        if (sizesDiffer)
        {
            tellSmaller();
        }
    }
    threads_.forEach(size, [&](std::size_t row) { found(static_cast<std::uint32_t>(row)); });
}

void BroadPhase::findAmongAll()
{
    const std::span<const Eigen::Vector3d> position = running_.position.all();
    const std::span<const double> radius = radii_;
    for (std::uint32_t i = 0; i < position.size(); ++i)
    {
        nearby_[i].clear();
        for (std::uint32_t k = 0; k < i; ++k)
        {
            if (mayTouch(position[i], radius[i], position[k], radius[k]))
            {
                nearby_[i].push_back(k);
                nearby_[k].push_back(i);
            }
        }
    }
}

// Cells are for spheres of radius 1, or what is larger, so pairs are in the same cell or in
// neighbours; unless sizes differ: then cells are for those that are usual. Few runners far apart
// get larger cells, or looking through empty ones would take longer than looking at the runners.
void BroadPhase::layOutCells()
{
    Eigen::AlignedBox3d box;
    bool finite = true; // or the guard will tell at the end of the step
    for (const Eigen::Vector3d& p : running_.position.all())
    {
        box.extend(p);
        finite = finite && p.allFinite();
    }
    low_ = box.min();
    count_ = {1, 1, 1};
    if (!finite)
    {
        return;
    }
    const double most = (usual_ < 1 ? kCellsForSmallRunner : kCellsForRunner) * running_.size();
    const double radius =
        usual_ < 1 ? usual_ : std::max(1.0, *std::max_element(radii_.begin(), radii_.end()));
    for (edge_ = (2 * radius + margin_) * kBeyondRounding;; edge_ *= kCoarser)
    {
        const Eigen::Array3d cells = (box.sizes() / edge_).array().floor() + 1;
        if (cells.prod() <= most)
        {
            count_ = {static_cast<int>(cells.x()), static_cast<int>(cells.y()),
                      static_cast<int>(cells.z())};
            return;
        }
    }
}

int BroadPhase::along(double position, int axis) const
{
    return count_[axis] == 1 // places may then be no numbers
               ? 0
               : std::clamp(static_cast<int>((position - low_[axis]) / edge_), 0, count_[axis] - 1);
}

std::uint32_t BroadPhase::cellOf(const Eigen::Vector3d& p) const
{
    return cellAt(along(p.x(), 0), along(p.y(), 1), along(p.z(), 2));
}

void BroadPhase::sortIntoCells()
{
    cells_.resize(running_.size());
    for (std::uint32_t row = 0; row < running_.size(); ++row)
    {
        cells_[row] = cellOf(running_.position[row]);
    }
    nodes_ =
        Buckets<Node>(static_cast<std::size_t>(count_[0]) * count_[1] * count_[2],
                      [this](auto&& enter)
                      {
                          for (std::uint32_t row = 0; row < running_.size(); ++row)
                          {
                              enter(cells_[row], Node{running_.position[row], radii_[row], row});
                          }
                      });
}

std::span<const BroadPhase::Node> BroadPhase::nodesIn(int left, int right, int y, int z) const
{
    const std::uint32_t begin = nodes_.starts()[cellAt(left, y, z)];
    return nodes_.values().subspan(begin, nodes_.starts()[cellAt(right, y, z) + 1] - begin);
}

void BroadPhase::findNear(const Node& node)
{
    std::vector<std::uint32_t>& nearby = nearby_[node.row];
    nearby.clear();
    const auto cell = static_cast<int>(cells_[node.row]);
    const int x = cell % count_[0];
    const int y = cell / count_[0] % count_[1];
    const int z = cell / count_[0] / count_[1];
    const int left = std::max(0, x - 1);
    const int right = std::min(count_[0] - 1, x + 1);
    for (int nz = std::max(0, z - 1); nz <= std::min(count_[2] - 1, z + 1); ++nz)
    {
        for (int ny = std::max(0, y - 1); ny <= std::min(count_[1] - 1, y + 1); ++ny)
        {
            for (const Node& other : nodesIn(left, right, ny, nz))
            {
                if (mayTouch(node.position, node.radius, other.position, other.radius) &&
                    other.row != node.row)
                {
                    nearby.push_back(other.row);
                }
            }
        }
    }
    std::sort(nearby.begin(), nearby.end());
}

// A search that each pair is found by once, from the larger of the two: small ones, which are many,
// then look at few cells.
void BroadPhase::findSmaller(const Node& node)
{
    std::vector<std::uint32_t>& nearby = nearby_[node.row];
    nearby.clear();
    const Eigen::Vector3d& p = node.position;
    const double reach = (2 * node.radius + margin_) * kBeyondRounding;
    for (int z = along(p.z() - reach, 2); z <= along(p.z() + reach, 2); ++z)
    {
        for (int y = along(p.y() - reach, 1); y <= along(p.y() + reach, 1); ++y)
        {
            for (const Node& other :
                 nodesIn(along(p.x() - reach, 0), along(p.x() + reach, 0), y, z))
            {
                if (std::tie(other.radius, other.row) < std::tie(node.radius, node.row) &&
                    mayTouch(p, node.radius, other.position, other.radius))
                {
                    nearby.push_back(other.row);
                }
            }
        }
    }
}

void BroadPhase::tellSmaller()
{
    const std::uint32_t size = running_.size();
    found_.resize(size);
    for (std::uint32_t row = 0; row < size; ++row)
    {
        found_[row] = nearby_[row].size();
    }
    for (std::uint32_t row = 0; row < size; ++row)
    {
        for (std::size_t k = 0; k < found_[row]; ++k)
        {
            nearby_[nearby_[row][k]].push_back(row);
        }
    }
    threads_.forEach(size,
                     [&](std::size_t k)
                     {
                         auto& nearby = nearby_[static_cast<std::uint32_t>(k)];
                         std::sort(nearby.begin(), nearby.end());
                     });
}

} // namespace frostfill
