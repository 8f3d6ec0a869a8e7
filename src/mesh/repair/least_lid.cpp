// SPDX-License-Identifier: MIT
// The lid of least area, by dynamic programming over the rim: [Barequet & Sharir 1995, 2.3].
#include "mesh/repair/least_lid.hpp"

#include <limits>

namespace frostfill
{
namespace
{

constexpr double kShortChords =
    1e-3; // [1] weight of squared edges: favours fat triangles in a flat lid
constexpr double kImpossible = std::numeric_limits<double>::infinity();

class Lid
{
public:
    Lid(const TriangleMesh& mesh, const EdgeTable& edges, const Rim& rim)
        : mesh_(mesh), edges_(edges), rim_(rim), count_(rim.size()),
          cost_(count_ * count_, kImpossible), middle_(count_ * count_, 0)
    {
        for (std::size_t i = 0; i + 1 < count_; ++i)
        {
            cost_[i * count_ + i + 1] = 0;
        }
        for (std::size_t span = 2; span < count_; ++span)
        {
            for (std::size_t i = 0; i + span < count_; ++i)
            {
                solve(i, i + span);
            }
        }
    }

    /// Empty if there is no lid.
    [[nodiscard]] std::vector<Triangle> triangles() const
    {
        std::vector<Triangle> result;
        if (count_ < 3 || cost_[count_ - 1] == kImpossible)
        {
            return result;
        }
        std::vector<std::array<std::size_t, 2>> chords = {{0, count_ - 1}};
        while (!chords.empty())
        {
            const auto [i, j] = chords.back();
            chords.pop_back();
            if (j < i + 2)
            {
                continue;
            }
            const std::size_t k = middle_[i * count_ + j];
            result.push_back({rim_[i], rim_[k], rim_[j]});
            chords.push_back({i, k});
            chords.push_back({k, j});
        }
        return result;
    }

private:
    /// The cheapest lid over rim vertices i..j, closed by the chord from j to i.
    void solve(std::size_t i, std::size_t j)
    {
        const bool isChord = j - i + 1 < count_;
        if (isChord && !edges_.find(rim_[i], rim_[j]).empty())
        {
            return;
        }
        double& best = cost_[i * count_ + j];
        for (std::size_t k = i + 1; k < j; ++k)
        {
            const double parts = cost_[i * count_ + k] + cost_[k * count_ + j];
            if (parts >= best)
            {
                continue;
            }
            const double whole = parts + weight(i, k, j);
            if (whole < best)
            {
                best = whole;
                middle_[i * count_ + j] = k;
            }
        }
    }

    [[nodiscard]] double weight(std::size_t i, std::size_t k, std::size_t j) const
    {
        const Eigen::Vector3d& a = mesh_.vertices[rim_[i]];
        const Eigen::Vector3d& b = mesh_.vertices[rim_[k]];
        const Eigen::Vector3d& c = mesh_.vertices[rim_[j]];
        if (isFlat(a, b, c))
        {
            return kImpossible;
        }
        const double squares =
            (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
        return 0.5 * (b - a).cross(c - a).norm() + kShortChords * squares;
    }

    const TriangleMesh& mesh_;
    const EdgeTable& edges_;
    const Rim& rim_;
    std::size_t count_;
    std::vector<double> cost_;
    std::vector<std::size_t> middle_;
};

} // namespace

std::vector<Triangle> leastLid(const TriangleMesh& mesh, const EdgeTable& edges, const Rim& rim)
{
    return Lid(mesh, edges, rim).triangles();
}

} // namespace frostfill
