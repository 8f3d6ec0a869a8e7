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
/// neighbours than bound a cell. Smaller: many are looked for twice.
constexpr double kFirstReach = 0.4;
/// Then, from so far, so many times as far again and again. Likewise.
constexpr double kSecondReach = 0.6;
constexpr double kNextReach = 1.5;
/// A cell that reaches farther is open. [mean diameter, or distance of neighbours in a regular
/// packing of the same density] Larger: spheres at a free surface take long. Smaller: cells in
/// loose packings do not count.
constexpr double kFarthest = 8;
/// Share of the distance of a plane within which rounding may have a vertex on either side of it.
constexpr double kRounding = 1e-9;

/// Makes cells one after another. voro++'s tolerances are lengths, so all is in mean diameters.
class CellMaker
{
public:
    CellMaker(const AnalysisInput& input, double farthest)
        : input_(input), unit_(input.meanDiameter), perUnit_(1 / unit_), farthest_(farthest)
    {
    }

    /// The kind of a cell and its volume [mesh unit].
    std::pair<CellKind, double> make(std::size_t k)
    {
        sphere_ = k;
        radius_ = input_.radii[k] / unit_;
        near_.clear();
        cell_.init(-farthest_, farthest_, -farthest_, farthest_, -farthest_, farthest_);
        double gathered = -1;
        double next = radius_ + kSecondReach;
        for (double most = radius_ + kFirstReach; most < farthest_; most = next)
        {
            next *= kNextReach;
            // What is farther than the cell reaches already cannot bound it.
            const double reach = std::min(most, std::sqrt(square()) * (1 + kRounding));
            const std::size_t before = near_.size();
            gather(gathered, reach);
            gathered = reach;
            if (holdsNearestWall(reach))
            {
                return {CellKind::atWall, AnalysisInput::kNothing};
            }
            if (!cut(before))
            {
                return {CellKind::none, AnalysisInput::kNothing};
            }
            cell_.vertices(vertices_);
            if (reachesOutside(reach))
            {
                return {CellKind::atWall, AnalysisInput::kNothing};
            }
            if (square() <= reach * reach)
            {
                return {CellKind::whole, cell_.volume() * unit_ * unit_ * unit_};
            }
        }
        return {CellKind::open, AnalysisInput::kNothing};
    }

private:
    struct Neighbour
    {
        Eigen::Vector3d apart; ///< from the sphere at hand
        double square;         ///< of that
        double rest;           ///< by which the square of its radius is smaller
    };
    /// What neighbours are sorted by: little is moved.
    struct Key
    {
        double square;
        std::uint32_t id;
        std::uint32_t place; ///< among those that were found
    };

    /// The largest value of any vertex, from two at a time so that neither waits for the other;
    /// voro++'s coordinates are doubled.
    template <class Value>
    [[nodiscard]] double largest(Value&& value) const
    {
        const double* at = cell_.pts;
        const double* end = at + 3 * static_cast<std::ptrdiff_t>(cell_.p);
        double even = value(at);
        double odd = even;
        for (at += 3; at + 3 < end; at += 6)
        {
            even = std::max(even, value(at));
            odd = std::max(odd, value(at + 3));
        }
        return std::max({even, odd, value(end - 3)});
    }
    [[nodiscard]] double square() const
    {
        return largest([](const double* at)
                       { return at[0] * at[0] + at[1] * at[1] + at[2] * at[2]; }) /
               4;
    }
    /// Whether the plane of a neighbour surely leaves the cell as it is.
    [[nodiscard]] bool isBeyond(const Eigen::Vector3d& apart, double distance) const
    {
        return largest([&](const double* at)
                       { return at[0] * apart.x() + at[1] * apart.y() + at[2] * apart.z(); }) <
               distance - kRounding * std::abs(distance);
    }

    /// How far a sphere may be that bounds the cell within `reach`: a place there is as near to it
    /// as to the cell's own, by squares of distances less squares of radii.
    static double farthestNeighbour(double reach, double rest)
    {
        const double within = reach * reach - rest;
        return reach < 0 || within < 0 ? 0 : reach + std::sqrt(within);
    }

    /// Adds all that may bound the cell within `reach` and is not there yet, the nearest first.
    /// Those up to `gathered` are there; below 0, none.
    void gather(double gathered, double reach)
    {
        const Eigen::Vector3d& centre = input_.centres[sphere_];
        const double squareOfUnit = unit_ * unit_;
        found_.clear();
        keys_.clear();
        for (const SphereLevels::Level& level : input_.levels.levels())
        {
            const double largest = level.largest * perUnit_;
            const double step = radius_ * radius_ - largest * largest;
            const double limit = farthestNeighbour(reach, step);
            const double had = farthestNeighbour(gathered, step);
            const double most = limit * limit * squareOfUnit;
            const double least = gathered < 0 ? -1 : had * had * squareOfUnit;
            const auto look = [&](std::uint32_t first, std::uint32_t end)
            {
                for (std::uint32_t place = first; place < end; ++place)
                {
                    const SphereLevels::Sphere& other = level.spheres[place];
                    const Eigen::Vector3d apart = other.centre - centre;
                    const double square = apart.squaredNorm();
                    if (square <= most && square > least && level.ids[place] != sphere_)
                    {
                        add(apart, square, other.radius, level.ids[place]);
                    }
                }
            };
            level.forEachRange(centre, limit * unit_, look);
        }
        std::sort(keys_.begin(), keys_.end(),
                  [](const Key& a, const Key& b)
                  { return a.square != b.square ? a.square < b.square : a.id < b.id; });
        for (const Key& key : keys_)
        {
            near_.push_back(found_[key.place]);
        }
    }
    /// In the unit of the mesh.
    void add(const Eigen::Vector3d& apart, double square, double radius, std::uint32_t id)
    {
        const double its = radius * perUnit_;
        keys_.push_back(
            {square * (perUnit_ * perUnit_), id, static_cast<std::uint32_t>(found_.size())});
        found_.push_back({apart * perUnit_, keys_.back().square, radius_ * radius_ - its * its});
    }

    /// Whether the nearest place of all walls belongs to the cell.
    [[nodiscard]] bool holdsNearestWall(double reach) const
    {
        if (input_.wallDistances[sphere_] > reach * unit_)
        {
            return false;
        }
        const Eigen::Vector3d& centre = input_.centres[sphere_];
        const Eigen::Vector3d wall = (input_.container.nearestWallPoint(centre) - centre) / unit_;
        return std::all_of(near_.begin(), near_.end(),
                           [&](const Neighbour& other)
                           { return 2 * wall.dot(other.apart) <= other.square + other.rest; });
    }

    /// Cuts off what belongs to neighbours from `first` on. False if nothing is left.
    bool cut(std::size_t first)
    {
        double far = std::sqrt(square());
        for (const Neighbour& other : std::span(near_).subspan(first))
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
            const double distance = other.square + other.rest;
            if (isBeyond(other.apart, distance))
            {
                continue;
            }
            if (!cell_.plane(other.apart.x(), other.apart.y(), other.apart.z(), distance))
            {
                return false;
            }
            far = std::sqrt(square());
        }
        return true;
    }

    /// Whether a vertex is outside, or what the cell surely has of the way to it.
    [[nodiscard]] bool reachesOutside(double reach) const
    {
        for (std::size_t v = 0; v + 2 < vertices_.size(); v += 3)
        {
            const Eigen::Vector3d vertex(vertices_[v], vertices_[v + 1], vertices_[v + 2]);
            const double known = std::min(1.0, reach / vertex.norm());
            if (known * vertex.norm() * unit_ > input_.wallDistances[sphere_] &&
                !input_.container.contains(input_.centres[sphere_] + known * unit_ * vertex))
            {
                return true;
            }
        }
        return false;
    }

    const AnalysisInput& input_;
    double unit_;
    double perUnit_;
    double farthest_; ///< [unit_]
    // Of the sphere at hand.
    std::size_t sphere_ = 0;
    double radius_ = 0; ///< [unit_]
    voro::voronoicell cell_;
    std::vector<Neighbour> near_; ///< the nearest first, those of each reach by themselves
    std::vector<Neighbour> found_;
    std::vector<Key> keys_;
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
