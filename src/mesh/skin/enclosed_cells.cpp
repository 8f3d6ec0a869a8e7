// SPDX-License-Identifier: MIT
#include "mesh/skin/enclosed_cells.hpp"

#include "geometry/closest_point.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

/// A byte each. Seventy times those of the default alpha.
constexpr double kMaxCells = 16e6;
/// Cubes looked at, for all triangles: a second.
constexpr std::size_t kMaxLooks = 100'000'000;

class Cells
{
public:
    Cells(const Eigen::AlignedBox3d& box, double edge) : low_(box.min()), edge_(edge)
    {
        const Eigen::Vector3d counts = (box.sizes() / edge).array().ceil() + 2 * kMargin;
        if (counts.prod() > kMaxCells)
        {
            return;
        }
        low_ -= Eigen::Vector3d::Constant(kMargin * edge);
        counts_ = counts.cast<int>();
        state_.assign(static_cast<std::size_t>(counts_.prod()), kFree);
    }

    [[nodiscard]] bool tooMany() const { return state_.empty(); }

    /// Marks the cubes that come near a triangle: all that it meets, and some beside. False when
    /// that would take too long.
    [[nodiscard]] bool block(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                             const Eigen::Vector3d& c)
    {
        const double reach = std::sqrt(0.75) * edge_;
        const Eigen::Array3d low = a.cwiseMin(b).cwiseMin(c).array() - reach;
        const Eigen::Array3d high = a.cwiseMax(b).cwiseMax(c).array() + reach;
        const Eigen::Array3i first = cell(low).max(0);
        const Eigen::Array3i last = cell(high).min(counts_ - 1);
        looks_ += static_cast<std::size_t>((last - first + 1).cast<double>().prod());
        if (looks_ > kMaxLooks)
        {
            return false;
        }
        for (int z = first.z(); z <= last.z(); ++z)
        {
            for (int y = first.y(); y <= last.y(); ++y)
            {
                for (int x = first.x(); x <= last.x(); ++x)
                {
                    char& state = state_[index(x, y, z)];
                    const Eigen::Vector3d middle =
                        low_ + edge_ * Eigen::Vector3d(x + 0.5, y + 0.5, z + 0.5);
                    if (state == kFree &&
                        (closestPointOnTriangle(middle, a, b, c).point - middle).norm() <= reach)
                    {
                        state = kBlocked;
                    }
                }
            }
        }
        return true;
    }

    /// Walks in from a corner, through faces of cubes.
    void flood()
    {
        std::vector<std::array<int, 3>> front = {{0, 0, 0}};
        state_[0] = kReached;
        while (!front.empty())
        {
            const std::array<int, 3> at = front.back();
            front.pop_back();
            for (int face = 0; face < 6; ++face)
            {
                std::array<int, 3> next = at;
                next[face / 2] += face % 2 == 0 ? -1 : 1;
                if (next[face / 2] < 0 || next[face / 2] >= counts_[face / 2])
                {
                    continue;
                }
                char& state = state_[index(next[0], next[1], next[2])];
                if (state == kFree)
                {
                    state = kReached;
                    front.push_back(next);
                }
            }
        }
    }

    [[nodiscard]] bool anyFree() const
    {
        return std::find(state_.begin(), state_.end(), kFree) != state_.end();
    }

private:
    static constexpr double kMargin = 2; // cubes around the box, so that the flood gets round it
    static constexpr char kFree = 0;
    static constexpr char kBlocked = 1;
    static constexpr char kReached = 2;

    [[nodiscard]] Eigen::Array3i cell(const Eigen::Array3d& p) const
    {
        return ((p - low_.array()) / edge_).floor().cast<int>();
    }
    [[nodiscard]] std::size_t index(int x, int y, int z) const
    {
        return (static_cast<std::size_t>(z) * counts_.y() + y) * counts_.x() + x;
    }

    Eigen::Vector3d low_;
    double edge_;
    std::size_t looks_ = 0;
    Eigen::Array3i counts_ = Eigen::Array3i::Zero();
    std::vector<char> state_;
};

} // namespace

bool enclosesRoom(const TriangleMesh& mesh, double alpha)
{
    Cells cells(boundingBox(mesh), alpha);
    if (cells.tooMany())
    {
        return false;
    }
    for (const auto& t : mesh.triangles)
    {
        if (!cells.block(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]))
        {
            return false;
        }
    }
    cells.flood();
    return cells.anyFree();
}

} // namespace frostfill
