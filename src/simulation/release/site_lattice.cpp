// SPDX-License-Identifier: MIT
#include "simulation/release/site_lattice.hpp"

#include "geometry/grid_frame.hpp"
#include "mesh/interior/near_surface.hpp"
#include "simulation/release/tolerances.hpp"
#include "simulation/world/tolerances.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <utility>

namespace frostfill
{

namespace
{

bool isLarge(const Eigen::Vector3d& box)
{
    return (box.array() + 2 * kGridMargin).prod() > kLargeBox;
}

/// Of the part of a large box in which sites count [r^3].
double volumeInReach(const Eigen::AlignedBox3d& box, const InsideTest& inside)
{
    double volume = 0;
    if (isLarge(box.sizes()))
    {
        inside.forEachBoxInReach([&](const Eigen::AlignedBox3d& part)
                                 { volume += part.intersection(box).sizes().cwiseMax(0).prod(); });
    }
    return volume;
}

} // namespace

double cellOfSites(const Eigen::Vector3d& box, double inReach, double radius)
{
    const auto areTooMany = [&](double cell)
    {
        const Eigen::Array3d along = box.array() / cell + 1;
        const double all = isLarge(box) ? inReach / (cell * cell * cell) : along.prod();
        return all > kMaxSites || along.maxCoeff() > kMostCellsAlong;
    };
    double cell = kSiteCell * radius;
    while (areTooMany(cell))
    {
        cell *= kCellGrowth;
    }
    return cell;
}

SiteLattice::SiteLattice(const Surface& surface, const InsideTest& inside, double radius,
                         Threads& threads, double coarsest, std::size_t smallLattice)
    : radius_(radius), lattice_(GridFrame::cover(surface.box(),
                                                 cellOfSites(surface.box().sizes(),
                                                             volumeInReach(surface.box(), inside),
                                                             std::max(radius, coarsest)),
                                                 0)),
      words_(countOfWords(), smallLattice)
{
    if (!words_.isOne())
    {
        obtainWords(surface.box(), inside);
    }
    bits_.resize(words_.size());
    // Two sites side by side, none of them near the surface, are on the same side of it.
    const double least = lattice_.cell / 2 * (1 + kDistanceSlack);
    depth_ = radius_ - halfDiagonal();
    depth_ = std::abs(depth_) < least ? -least : depth_;
    markNear(surface, std::abs(depth_), threads);
    openInside(inside, threads);
}

// Numbers of sites fit 32 bits; where there are too many, cells grow.
void SiteLattice::obtainWords(const Eigen::AlignedBox3d& box, const InsideTest& inside)
{
    while (true)
    {
        inside.forEachBoxInReach(
            [&](const Eigen::AlignedBox3d& part)
            {
                const GridPlace low = lattice_.coordinates(part.min());
                const GridPlace high = lattice_.coordinates(part.max());
                for (int z = low[2] / Words::kSide; z <= high[2] / Words::kSide; ++z)
                {
                    for (int y = low[1] / Words::kSide; y <= high[1] / Words::kSide; ++y)
                    {
                        for (int x = low[0] / 64; x <= high[0] / 64; ++x)
                        {
                            words_.obtain(x, y * Words::kSide, z * Words::kSide);
                        }
                    }
                }
            });
        if (static_cast<double>(words_.size()) <= kMaxSites / 64)
        {
            return;
        }
        lattice_ = GridFrame::cover(box, kCellGrowth * lattice_.cell, 0);
        words_ = Words(countOfWords(), 0);
    }
}

// All threads set bits at once, each those of sites near its triangles.
void SiteLattice::markNear(const Surface& surface, double distance, Threads& threads)
{
    const auto mark = [&](int y, int z, CellRun run, auto&& isNear)
    {
        forEachWordOf(run,
                      [&](int x, std::uint64_t some)
                      {
                          const std::size_t number = words_.find(x, y, z);
                          if (number == kNone)
                          {
                              return;
                          }
                          const std::atomic_ref word(bits_[number]);
                          std::uint64_t near = 0;
                          for (std::uint64_t left = some & ~word.load(std::memory_order_relaxed);
                               left != 0; left &= left - 1)
                          {
                              near |= isNear(64 * x + std::countr_zero(left)) ? left & -left : 0;
                          }
                          if (near != 0)
                          {
                              word.fetch_or(near, std::memory_order_relaxed);
                          }
                      });
    };
    forEachGroup(surface, lattice_.cell, threads,
                 [&](const TriangleGroup& group)
                 { forEachRunNear(lattice_, surface, group, distance, mark); });
}

// Sites near the surface are marked; what remains are those to be open.
void SiteLattice::openInside(const InsideTest& inside, Threads& threads)
{
    const std::vector<std::uint64_t> near = std::exchange(bits_, {});
    bits_.resize(near.size());
    forEachPart(threads, near.size(), kWordsOfPart,
                [&](std::size_t first, std::size_t last, std::size_t)
                {
                    for (std::size_t word = first; word < last; ++word)
                    {
                        bits_[word] = openOfWord(word, near, first, inside);
                    }
                });
}

// A site that is not near the surface is on the side of the one below it, if that is not near
// either and is known: words from `first` on are.
std::uint64_t SiteLattice::openOfWord(std::size_t word, std::span<const std::uint64_t> near,
                                      std::size_t first, const InsideTest& inside) const
{
    const auto [x, y, z] = place(word);
    if (!words_.isInGrid({x, y, z}))
    {
        return 0;
    }
    const std::size_t below = y > 0 ? words_.find(x, y - 1, z) : kNone;
    const std::uint64_t known = below >= first && below < word ? ~near[below] : 0;
    const std::uint64_t inRow =
        ~std::uint64_t{0} >> (64 - std::min(64, lattice_.count[0] - 64 * x));
    std::uint64_t open = depth_ < 0 ? near[word] : 0;
    for (std::uint64_t left = ~near[word] & inRow; left != 0;)
    {
        // The lowest bits that follow each other: adding the first carries beyond the last.
        const std::uint64_t run = left & ~(left + (left & -left));
        const int site = 64 * x + std::countr_zero(left);
        const bool isInside = (run & known) != 0
                                  ? (bits_[below] & run & known) != 0
                                  : inside.isInsideByWinding(lattice_.centre(site, y, z));
        open |= isInside ? run : 0;
        left &= ~run;
    }
    return open & inRow;
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
    const Eigen::Vector3d first = lattice_.centre(0, 0, 0);
    const double middle = (centre.x() - first.x()) / lattice_.cell;
    for (int z = low[2]; z <= high[2]; ++z)
    {
        const double dz = first.z() + lattice_.cell * z - centre.z();
        for (int y = low[1]; y <= high[1]; ++y)
        {
            const double dy = first.y() + lattice_.cell * y - centre.y();
            const double left = limit * limit - dz * dz - dy * dy;
            if (left > 0)
            {
                // Cells of the row whose centre is within the half chord.
                const double half = std::sqrt(left) / lattice_.cell;
                const auto [begin, end] =
                    wholeNumbers(middle - half, middle + half, lattice_.count[0]);
                closeRun(y, z, begin, end);
            }
        }
    }
}

void SiteLattice::closeRun(int y, int z, int first, int last)
{
    forEachWordOf({first, last},
                  [&](int x, std::uint64_t run)
                  {
                      const std::size_t word = words_.find(x, y, z);
                      if (word != kNone)
                      {
                          bits_[word] &= ~run;
                      }
                  });
}

std::vector<std::uint32_t> SiteLattice::highest() const
{
    std::vector<std::uint32_t> found;
    for (std::size_t word = 0; word < bits_.size(); ++word)
    {
        if (bits_[word] == 0)
        {
            continue;
        }
        const auto [x, y, z] = place(word);
        const std::size_t above = y + 1 < lattice_.count[1] ? words_.find(x, y + 1, z) : kNone;
        const std::uint64_t openAbove = above == kNone ? 0 : bits_[above];
        for (std::uint64_t bits = bits_[word] & ~openAbove; bits != 0; bits &= bits - 1)
        {
            const auto bit = static_cast<std::size_t>(std::countr_zero(bits));
            found.push_back(static_cast<std::uint32_t>(64 * word + bit));
        }
    }
    return found;
}

Eigen::Vector3d SiteLattice::centre(std::size_t site) const
{
    const auto [x, y, z] = place(site / 64);
    return lattice_.centre(64 * x + static_cast<int>(site % 64), y, z);
}

std::size_t SiteLattice::nextOpen(std::size_t site) const
{
    std::size_t word = site / 64;
    if (word >= bits_.size())
    {
        return end();
    }
    std::uint64_t rest = bits_[word] & (~std::uint64_t{0} << (site % 64));
    while (rest == 0)
    {
        if (++word == bits_.size())
        {
            return end();
        }
        rest = bits_[word];
    }
    return word * 64 + static_cast<std::size_t>(std::countr_zero(rest));
}

} // namespace frostfill
