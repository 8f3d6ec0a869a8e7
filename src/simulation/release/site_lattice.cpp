// SPDX-License-Identifier: MIT
#include "simulation/release/site_lattice.hpp"

#include "simulation/release/tolerances.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace frostfill
{

namespace
{

double cellFor(const Eigen::Vector3d& size, double radius)
{
    double cell = kSiteCell * radius;
    while ((size.array() / cell + 1).prod() > kMaxSites)
    {
        cell *= kCellGrowth;
    }
    return cell;
}

} // namespace

SiteLattice::SiteLattice(const Surface& surface, const InsideTest& inside, double radius,
                         Threads& threads)
    : radius_(radius),
      lattice_(GridFrame::cover(surface.box(), cellFor(surface.box().sizes(), radius), 0)),
      bits_((lattice_.size() + 63) / 64, 0)
{
    // Layers share words with those beside them.
    const int layers = lattice_.count[2];
    forEachSlab(threads, (layers + kSlabThickness - 1) / kSlabThickness,
                [&](int slab)
                {
                    const int end = std::min(layers, (slab + 1) * kSlabThickness);
                    for (int z = slab * kSlabThickness; z < end; ++z)
                    {
                        openLayer(inside, z);
                    }
                });
}

void SiteLattice::openLayer(const InsideTest& inside, int z)
{
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const double least = radius_ - halfDiagonal();
    // From one site to the next a distance changes less.
    const double known = lattice_.cell + kDistanceSlack;
    std::size_t site = lattice_.index(0, 0, z);
    struct Bounds
    {
        double low = -kInfinity;
        double high = kInfinity;
    };
    std::vector<Bounds> row(static_cast<std::size_t>(lattice_.count[0])); // the one before
    for (int y = 0; y < lattice_.count[1]; ++y)
    {
        Bounds distance;
        for (int x = 0; x < lattice_.count[0]; ++x, ++site)
        {
            Bounds& beside = row[static_cast<std::size_t>(x)];
            distance.low = std::max(distance.low, beside.low) - known;
            distance.high = std::min(distance.high, beside.high) + known;
            if (distance.low < least && distance.high >= least)
            {
                const Eigen::Vector3d place = lattice_.centre(x, y, z);
                const double its = inside.distance(place, std::max(-distance.low, distance.high));
                // What is beyond the reach of the test is only known to be beyond it.
                const bool far = std::abs(its) >= inside.reach();
                distance.low = far && its < 0 ? -kInfinity : its;
                distance.high = far && its > 0 ? kInfinity : its;
                if (far && its < 0)
                {
                    const int last = lastBefore(inside.farOutsideUntil(place), x);
                    std::fill(&beside, &beside + (last - x), distance);
                    site += static_cast<std::size_t>(last - x);
                    x = last;
                }
            }
            row[static_cast<std::size_t>(x)] = distance;
            if (distance.low >= least)
            {
                bits_[site / 64] |= std::uint64_t{1} << (site % 64);
            }
        }
    }
}

int SiteLattice::lastBefore(double end, int x) const
{
    const double site = std::ceil((end - lattice_.origin.x()) / lattice_.cell - 0.5) - 1;
    int last = static_cast<int>(std::clamp<double>(site, x, lattice_.count[0] - 1));
    while (last > x && lattice_.centre(last, 0, 0).x() >= end) // rounding
    {
        --last;
    }
    return last;
}

void SiteLattice::close(const Eigen::Vector3d& centre, double radius)
{
    const double limit = closedWithin(radius);
    if (limit <= 0)
    {
        return;
    }
    const auto low = lattice_.coordinates(centre.array() - limit);
    const auto high = lattice_.coordinates(centre.array() + limit);
    for (int z = low[2]; z <= high[2]; ++z)
    {
        const double dz = lattice_.centre(0, 0, z).z() - centre.z();
        for (int y = low[1]; y <= high[1]; ++y)
        {
            const double dy = lattice_.centre(0, y, 0).y() - centre.y();
            const double left = limit * limit - dz * dz - dy * dy;
            if (left <= 0)
            {
                continue;
            }
            // Cells of the row whose centre is within the half chord.
            const double half = std::sqrt(left);
            const double first = (centre.x() - half - lattice_.origin.x()) / lattice_.cell - 0.5;
            const double last = (centre.x() + half - lattice_.origin.x()) / lattice_.cell - 0.5;
            const int begin = std::max(0, static_cast<int>(std::ceil(first)));
            const int end = std::min(lattice_.count[0] - 1, static_cast<int>(std::floor(last)));
            if (begin <= end)
            {
                const std::size_t row = lattice_.index(0, y, z);
                closeRun(row + static_cast<std::size_t>(begin),
                         row + static_cast<std::size_t>(end));
            }
        }
    }
}

void SiteLattice::closeRun(std::size_t first, std::size_t last)
{
    for (std::size_t word = first / 64; word <= last / 64; ++word)
    {
        std::uint64_t run = ~std::uint64_t{0};
        run &= word == first / 64 ? ~std::uint64_t{0} << first % 64 : run;
        run &= word == last / 64 ? ~std::uint64_t{0} >> (63 - last % 64) : run;
        bits_[word] &= ~run;
    }
}

std::uint64_t SiteLattice::openFrom(std::size_t site) const
{
    const std::size_t word = site / 64;
    const std::uint64_t here = word < bits_.size() ? bits_[word] >> site % 64 : 0;
    const std::uint64_t next = site % 64 > 0 && word + 1 < bits_.size() ? bits_[word + 1] : 0;
    return next == 0 ? here : here | next << (64 - site % 64);
}

std::vector<std::uint32_t> SiteLattice::highest() const
{
    const auto row = static_cast<std::size_t>(lattice_.count[0]);
    const std::size_t plane = row * static_cast<std::size_t>(lattice_.count[1]);
    std::vector<std::uint32_t> found;
    for (std::size_t begin = 0; begin < lattice_.size(); begin += row)
    {
        const bool isTop = begin % plane + row == plane;
        for (std::size_t x = 0; x < row; x += 64)
        {
            const std::uint64_t inRow =
                row - x < 64 ? ~(~std::uint64_t{0} << (row - x)) : ~std::uint64_t{0};
            const std::uint64_t above = isTop ? 0 : openFrom(begin + x + row);
            for (std::uint64_t bits = openFrom(begin + x) & ~above & inRow; bits != 0;
                 bits &= bits - 1)
            {
                const auto bit = static_cast<std::size_t>(std::countr_zero(bits));
                found.push_back(static_cast<std::uint32_t>(begin + x + bit));
            }
        }
    }
    return found;
}

Eigen::Vector3d SiteLattice::centre(std::size_t site) const
{
    const auto nx = static_cast<std::size_t>(lattice_.count[0]);
    const auto ny = static_cast<std::size_t>(lattice_.count[1]);
    return lattice_.centre(static_cast<int>(site % nx), static_cast<int>(site / nx % ny),
                           static_cast<int>(site / nx / ny));
}

std::size_t SiteLattice::nextOpen(std::size_t site) const
{
    std::size_t word = site / 64;
    if (word >= bits_.size())
    {
        return lattice_.size();
    }
    std::uint64_t rest = bits_[word] & (~std::uint64_t{0} << (site % 64));
    while (rest == 0)
    {
        if (++word == bits_.size())
        {
            return lattice_.size();
        }
        rest = bits_[word];
    }
    return word * 64 + static_cast<std::size_t>(std::countr_zero(rest));
}

} // namespace frostfill
