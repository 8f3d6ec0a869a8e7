// SPDX-License-Identifier: MIT
#include "simulation/release/site_lattice.hpp"

#include "geometry/cell_rows.hpp"
#include "simulation/release/tolerances.hpp"
#include "simulation/world/tolerances.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

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
                         Threads& threads, double smallLattice, double coarsest)
    : radius_(radius), lattice_(GridFrame::cover(surface.box(),
                                                 cellOfSites(surface.box().sizes(),
                                                             volumeInReach(surface.box(), inside),
                                                             std::max(radius, coarsest)),
                                                 0)),
      wordsPerRow_((static_cast<std::size_t>(lattice_.count[0]) + 63) / 64)
{
    const double words = static_cast<double>(wordsPerRow_) * lattice_.count[1] * lattice_.count[2];
    const bool isSmall = words <= smallLattice;
    if (!isSmall)
    {
        listWords(surface.box(), inside);
    }
    bits_.resize(isSmall ? static_cast<std::size_t>(words) : list_.size(), ~std::uint64_t{0});
    // A cell is open where its centre is so deep inside, or less than that outside.
    const double depth = radius_ - halfDiagonal();
    closeNear(surface, std::abs(depth), threads);
    closeOutside(inside, std::abs(depth), depth < 0, threads);
    if (!isSmall)
    {
        dropClosedWords();
    }
}

// Numbers of sites fit 32 bits; where there are too many, cells grow.
void SiteLattice::listWords(const Eigen::AlignedBox3d& box, const InsideTest& inside)
{
    while (true)
    {
        BrickedCells<1> words(
            {static_cast<int>(wordsPerRow_), lattice_.count[1], lattice_.count[2]}, 0);
        inside.forEachBoxInReach(
            [&](const Eigen::AlignedBox3d& part)
            {
                const GridPlace low = lattice_.coordinates(part.min());
                const GridPlace high = lattice_.coordinates(part.max());
                constexpr int kSide = BrickedCells<1>::kSide;
                for (int z = low[2] / kSide; z <= high[2] / kSide; ++z)
                {
                    for (int y = low[1] / kSide; y <= high[1] / kSide; ++y)
                    {
                        for (int x = low[0] / 64; x <= high[0] / 64; ++x)
                        {
                            words.obtain(x, y * kSide, z * kSide);
                        }
                    }
                }
            });
        if (static_cast<double>(words.size()) <= kMaxSites / 64)
        {
            std::vector<WordPlace> list;
            for (std::size_t word = 0; word < words.size(); ++word)
            {
                if (words.isInGrid(words.cell(word)))
                {
                    list.push_back(words.cell(word));
                }
            }
            std::sort(list.begin(), list.end(), WordSpans::isBefore);
            std::for_each(list.begin(), list.end(),
                          [&](const WordPlace& word) { list_.append(word); });
            return;
        }
        lattice_ = GridFrame::cover(box, kCellGrowth * lattice_.cell, 0);
        wordsPerRow_ = (static_cast<std::size_t>(lattice_.count[0]) + 63) / 64;
    }
}

void SiteLattice::dropClosedWords()
{
    WordSpans kept;
    for (std::size_t word = 0; word < bits_.size(); ++word)
    {
        if (bits_[word] != 0)
        {
            bits_[kept.size()] = bits_[word];
            kept.append(list_.place(word));
        }
    }
    if (kept.size() == 0 && !bits_.empty()) // a list without words would be that of a small one
    {
        kept.append(list_.place(0));
    }
    bits_.resize(kept.size());
    bits_.shrink_to_fit();
    list_ = std::move(kept);
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
                      const std::size_t word = find({x, y, z});
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
        const std::size_t above = y + 1 < lattice_.count[1] ? find({x, y + 1, z}) : kNone;
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
