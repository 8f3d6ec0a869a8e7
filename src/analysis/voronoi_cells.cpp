// SPDX-License-Identifier: MIT
#include "analysis/analysis_input.hpp"

#include <voro++/cell.hh>

#include <algorithm>
#include <memory>
#include <utility>

namespace frostfill
{
namespace
{

/// A cell is first known up to so far from the surface of its sphere [mean diameter]. Larger: more
/// neighbours than bound a cell. Smaller: many cells are made twice.
constexpr double kFirstReach = 0.6;
/// And then so many times as far. Likewise.
constexpr double kNextReach = 1.5;
/// A cell that reaches farther is open. [mean diameter, or distance of neighbours in a regular
/// packing of the same density] Larger: spheres at a free surface take long. Smaller: cells in
/// loose packings do not count.
constexpr double kFarthest = 8;
/// Planes between two looks at how large the cell still is.
constexpr int kLookEvery = 2;

/// Makes cells one after another. voro++'s tolerances are lengths, so all is in mean diameters.
class CellMaker
{
public:
    CellMaker(const AnalysisInput& input, double farthest)
        : input_(input), unit_(input.meanDiameter), farthest_(farthest)
    {
    }

    /// The kind of a cell and its volume [mesh unit].
    std::pair<CellKind, double> make(std::size_t k)
    {
        for (double reach = input_.radii[k] / unit_ + kFirstReach; reach < farthest_;
             reach *= kNextReach)
        {
            gather(k, reach);
            if (holdsNearestWall(k, reach))
            {
                return {CellKind::atWall, AnalysisInput::kNothing};
            }
            if (!cut(reach))
            {
                return {CellKind::none, AnalysisInput::kNothing};
            }
            cell_.vertices(vertices_);
            if (reachesOutside(k, reach))
            {
                return {CellKind::atWall, AnalysisInput::kNothing};
            }
            if (square(cell_) <= reach * reach)
            {
                return {CellKind::whole, cell_.volume() * unit_ * unit_ * unit_};
            }
        }
        return {CellKind::open, AnalysisInput::kNothing};
    }

private:
    struct Neighbour
    {
        double square; ///< of the distance
        std::uint32_t id;
        double rest; ///< by which the square of its radius is smaller than that of this sphere
        Eigen::Vector3d apart;
    };

    /// Of the farthest vertex; voro++'s coordinates are doubled.
    static double square(voro::voronoicell& cell) { return cell.max_radius_squared() / 4; }

    /// How far a sphere may be that bounds the cell within `reach`: a place there is as near to it
    /// as to the cell's own, by squares of distances less squares of radii.
    static double farthestNeighbour(double reach, double rest)
    {
        const double within = reach * reach - rest;
        return within < 0 ? 0 : reach + std::sqrt(within);
    }

    /// All that may bound the cell within `reach`, the nearest first.
    void gather(std::size_t k, double reach)
    {
        const double radius = input_.radii[k] / unit_;
        const double perUnit = 1 / unit_;
        near_.clear();
        for (const SphereLevels::Level& level : input_.levels.levels())
        {
            const double largest = level.largest * perUnit;
            const double limit = farthestNeighbour(reach, radius * radius - largest * largest);
            level.forEachRange(input_.centres[k], limit * unit_,
                               [&](std::uint32_t first, std::uint32_t end)
                               {
                                   for (std::uint32_t place = first; place < end; ++place)
                                   {
                                       const SphereLevels::Sphere& other = level.spheres[place];
                                       const Eigen::Vector3d apart =
                                           (other.centre - input_.centres[k]) * perUnit;
                                       const double square = apart.squaredNorm();
                                       if (square <= limit * limit && level.ids[place] != k)
                                       {
                                           const double its = other.radius * perUnit;
                                           near_.push_back({square, level.ids[place],
                                                            radius * radius - its * its, apart});
                                       }
                                   }
                               });
        }
        std::sort(near_.begin(), near_.end(),
                  [](const Neighbour& a, const Neighbour& b)
                  { return std::pair(a.square, a.id) < std::pair(b.square, b.id); });
    }

    /// Whether the nearest place of all walls belongs to the cell.
    [[nodiscard]] bool holdsNearestWall(std::size_t k, double reach) const
    {
        if (input_.wallDistances[k] > reach * unit_)
        {
            return false;
        }
        const Eigen::Vector3d wall =
            (input_.container.nearestWallPoint(input_.centres[k]) - input_.centres[k]) / unit_;
        return std::all_of(near_.begin(), near_.end(),
                           [&](const Neighbour& other)
                           { return 2 * wall.dot(other.apart) <= other.square + other.rest; });
    }

    /// Cuts a cube down to the cell, as far as `reach`. False if nothing is left.
    bool cut(double reach)
    {
        cell_.init(-reach, reach, -reach, reach, -reach, reach);
        double far = std::sqrt(square(cell_));
        int planes = 0;
        for (const Neighbour& other : near_)
        {
            const double limit = farthestNeighbour(far, other.rest);
            if (other.square > limit * limit)
            {
                continue;
            }
            if (other.square == 0) // two in one place: the larger one has the cell
            {
                if (other.rest < 0)
                {
                    return false;
                }
                continue;
            }
            if (!cell_.plane(other.apart.x(), other.apart.y(), other.apart.z(),
                             other.square + other.rest))
            {
                return false;
            }
            if (++planes % kLookEvery == 0)
            {
                far = std::sqrt(square(cell_));
            }
        }
        return true;
    }

    /// Whether a vertex is outside, or what the cell surely has of the way to it.
    [[nodiscard]] bool reachesOutside(std::size_t k, double reach) const
    {
        for (std::size_t v = 0; v + 2 < vertices_.size(); v += 3)
        {
            const Eigen::Vector3d vertex(vertices_[v], vertices_[v + 1], vertices_[v + 2]);
            const double known = std::min(1.0, reach / vertex.norm());
            if (known * vertex.norm() * unit_ > input_.wallDistances[k] &&
                !input_.container.contains(input_.centres[k] + known * unit_ * vertex))
            {
                return true;
            }
        }
        return false;
    }

    const AnalysisInput& input_;
    double unit_;
    double farthest_; ///< [unit_]
    voro::voronoicell cell_;
    std::vector<Neighbour> near_;
    std::vector<double> vertices_;
};

} // namespace

bool hasVoronoiCells()
{
    return true;
}

CellStatistics findCells(const AnalysisInput& input)
{
    CellStatistics cells;
    cells.kinds.resize(input.size());
    cells.volumes.resize(input.size());
    cells.fractions.resize(input.size());
    const double spacing =
        std::cbrt(input.container.report().volume / static_cast<double>(input.size()));
    const double farthest = kFarthest * std::max(1.0, spacing / input.meanDiameter);
    input.forEachPartOfSpheres(
        [&](std::size_t first, std::size_t end, std::size_t)
        {
            const auto maker = std::make_unique<CellMaker>(input, farthest);
            for (const std::uint32_t k : input.levels.order().subspan(first, end - first))
            {
                std::tie(cells.kinds[k], cells.volumes[k]) = maker->make(k);
                cells.fractions[k] = ballVolume(input.radii[k]) / cells.volumes[k];
            }
        });
    double inCells = 0;
    double inSpheres = 0;
    for (std::size_t k = 0; k < input.size(); ++k)
    {
        cells.atWall += cells.kinds[k] == CellKind::atWall ? 1 : 0;
        cells.open += cells.kinds[k] == CellKind::open ? 1 : 0;
        if (cells.kinds[k] == CellKind::whole)
        {
            ++cells.whole;
            inCells += cells.volumes[k];
            inSpheres += ballVolume(input.radii[k]);
        }
    }
    cells.fraction = inSpheres / inCells; // no number without any
    return cells;
}

} // namespace frostfill
