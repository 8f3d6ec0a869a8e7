// SPDX-License-Identifier: MIT
#include "simulation/release/site_lattice.hpp"

#include "simulation/release/tolerances.hpp"
#include "simulation/world/tolerances.hpp"

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
    if ((size.array() + 2 * kGridMargin).prod() > kLargeBox)
    {
        return cell; // only sites in the object count
    }
    while ((size.array() / cell + 1).prod() > kMaxSites)
    {
        cell *= kCellGrowth;
    }
    return cell;
}

} // namespace

/// Opens the sites of one layer after another. Most are decided by those beside them.
class SiteLattice::Opening
{
public:
    Opening(SiteLattice& sites, const InsideTest& inside)
        : sites_(sites), lattice_(sites.lattice_), inside_(inside),
          beside_(static_cast<std::size_t>(lattice_.count[0])), knownIn_(sites.wordsPerRow_, kNoRow)
    {
    }

    /// From layer z on, up to layer `end`.
    void open(int z, int end)
    {
        const std::size_t last = sites_.firstFrom({0, 0, end});
        for (std::size_t first = sites_.firstFrom({0, 0, z}); first < last;)
        {
            const WordPlace start = sites_.place(first);
            std::size_t next = first + 1;
            for (WordPlace word = start; next < last; ++next) // words without a gap
            {
                const WordPlace other = sites_.place(next);
                if (other != WordPlace{word[0] + 1, word[1], word[2]})
                {
                    break;
                }
                word = other;
            }
            openWords(first, next - first, start);
            first = next;
        }
    }

private:
    static constexpr double kInfinity = std::numeric_limits<double>::infinity();
    static constexpr std::int64_t kNoRow = -1;
    struct Bounds
    {
        double low = -kInfinity;
        double high = kInfinity;
    };

    // What is not known of the row before, because it has no such word, counts as anything.
    void takeOver(std::size_t words, const WordPlace& start)
    {
        const std::int64_t row = std::int64_t{start[2]} * lattice_.count[1] + start[1];
        for (std::size_t k = 0; k < words; ++k)
        {
            const std::size_t word = static_cast<std::size_t>(start[0]) + k;
            if (knownIn_[word] != row - 1 || start[1] == 0)
            {
                const std::size_t end = std::min(64 * (word + 1), beside_.size());
                std::fill(beside_.begin() + static_cast<std::ptrdiff_t>(64 * word),
                          beside_.begin() + static_cast<std::ptrdiff_t>(end), Bounds{});
            }
            knownIn_[word] = row;
        }
    }

    void openWords(std::size_t first, std::size_t words, const WordPlace& start)
    {
        takeOver(words, start);
        const int begin = 64 * start[0];
        const int end = std::min(begin + 64 * static_cast<int>(words), lattice_.count[0]);
        const int y = start[1];
        const int z = start[2];
        const double least = sites_.radius_ - sites_.halfDiagonal();
        // From one site to the next a distance changes less.
        const double known = lattice_.cell + kDistanceSlack;
        const double endOfRow = lattice_.centre(end - 1, y, z).x();
        Bounds distance;
        for (int x = begin; x < end; ++x)
        {
            int last = x; // of those that are decided with it
            Bounds& beside = beside_[static_cast<std::size_t>(x)];
            distance.low = std::max(distance.low, beside.low) - known;
            distance.high = std::min(distance.high, beside.high) + known;
            if (distance.low < least && distance.high >= least)
            {
                const Eigen::Vector3d place = lattice_.centre(x, y, z);
                const double its = inside_.distance(place, std::max(-distance.low, distance.high));
                // What is beyond the reach of the test is only known to be beyond it.
                const bool far = std::abs(its) >= inside_.reach();
                distance.low = far && its < 0 ? -kInfinity : its;
                distance.high = far && its > 0 ? kInfinity : its;
                last = far ? lastBefore(inside_.farUntil(place, endOfRow), x, end - 1) : x;
            }
            std::fill(&beside, &beside + (last - x + 1), distance);
            if (distance.low >= least)
            {
                forEachWord(x, last,
                            [&](int word, std::uint64_t open) {
                                sites_.bits_[first + static_cast<std::size_t>(word - start[0])] |=
                                    open;
                            });
            }
            x = last;
        }
    }

    /// The last site of a row, from site x to `last`, that lies before a coordinate; x if none
    /// does.
    [[nodiscard]] int lastBefore(double end, int x, int last) const
    {
        const double site = std::ceil((end - lattice_.origin.x()) / lattice_.cell - 0.5) - 1;
        int result = static_cast<int>(std::clamp<double>(site, x, last));
        while (result > x && lattice_.centre(result, 0, 0).x() >= end) // rounding
        {
            --result;
        }
        return result;
    }

    SiteLattice& sites_;
    const GridFrame& lattice_;
    const InsideTest& inside_;
    std::vector<Bounds> beside_;        ///< of the row before
    std::vector<std::int64_t> knownIn_; ///< [#words of a row] the row whose bounds are in beside_
};

SiteLattice::SiteLattice(const Surface& surface, const InsideTest& inside, double radius,
                         Threads& threads, double smallLattice, double coarsest,
                         std::size_t inMemory)
    : radius_(radius),
      lattice_(GridFrame::cover(surface.box(),
                                cellFor(surface.box().sizes(), std::max(radius, coarsest)), 0)),
      wordsPerRow_((static_cast<std::size_t>(lattice_.count[0]) + 63) / 64), bits_(inMemory)
{
    const double words = static_cast<double>(wordsPerRow_) * lattice_.count[1] * lattice_.count[2];
    const bool isSmall = words <= smallLattice;
    if (!isSmall)
    {
        listWords(surface.box(), inside);
    }
    bits_.resize(isSmall ? static_cast<std::size_t>(words) : list_.size(), 0);
    const int layers = lattice_.count[2];
    forEachSlab(threads, (layers + kSlabThickness - 1) / kSlabThickness,
                [&](int slab)
                {
                    Opening(*this, inside)
                        .open(slab * kSlabThickness, std::min(layers, (slab + 1) * kSlabThickness));
                });
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
    bits_.resize(kept.size(), 0);
    bits_.shrinkToFit();
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
    if (first > last)
    {
        return;
    }
    forEachWord(first, last,
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
