// SPDX-License-Identifier: MIT
#include "geometry/cell_rows.hpp"
#include "mesh/interior/near_surface.hpp"
#include "simulation/release/site_lattice.hpp"
#include "simulation/release/tolerances.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>

/// Which sites are inside an object, and far enough from its surface.
namespace frostfill
{

/// Closes the sites outside, one layer after another. Those near the surface are known; what is not
/// near it has sites on its own side beside it, so that few have to be asked.
class SiteLattice::Sides
{
public:
    /// All sites but those within `distance` of the surface are open yet.
    Sides(SiteLattice& sites, const InsideTest& inside, double distance, bool nearAreOpen)
        : sites_(sites), lattice_(sites.lattice_), inside_(inside),
          areLinked_(lattice_.cell <= 2 * distance), nearAreOpen_(nearAreOpen),
          before_(static_cast<std::size_t>(lattice_.count[0]))
    {
    }

    /// From layer z on, up to layer `end`.
    void close(int z, int end)
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
            closeInWords(first, next - first, start);
            first = next;
        }
    }

private:
    enum class Side : char
    {
        unknown,
        inside,
        outside
    };
    /// Where a site was asked for.
    struct Asked
    {
        Side side;
        int last; ///< of the sites after it that are on its side for certain
    };

    void closeInWords(std::size_t first, std::size_t words, const WordPlace& start)
    {
        std::uint64_t* const bits = &sites_.bits_[first];
        const int begin = 64 * start[0];
        const int end = std::min(begin + 64 * static_cast<int>(words), lattice_.count[0]);
        for (int x = begin; x < end;)
        {
            int next = x; // after those that follow each other and are not near
            while (next < end && (bits[(next - begin) / 64] >> (next % 64) & 1U) != 0)
            {
                ++next;
            }
            while (x < next)
            {
                const auto [side, last] = sideOf({x, next - 1}, start);
                std::fill(&before_[static_cast<std::size_t>(x)],
                          &before_[static_cast<std::size_t>(last)] + 1, side);
                if (side == Side::outside)
                {
                    forEachWordOf({x, last}, [&](int word, std::uint64_t its)
                                  { bits[word - start[0]] &= ~its; });
                }
                x = last + 1;
            }
            if (x < end)
            {
                before_[static_cast<std::size_t>(x)] = Side::unknown;
                bits[(x - begin) / 64] |= std::uint64_t{nearAreOpen_ ? 1U : 0U} << (x % 64);
                ++x;
            }
        }
        if (end % 64 != 0)
        {
            bits[words - 1] &= ~std::uint64_t{0} >> (64 - end % 64);
        }
    }

    /// Of the first of some sites that follow each other, none of them near the surface.
    Asked sideOf(CellRun run, const WordPlace& row) const
    {
        const Eigen::Vector3d place = lattice_.centre(run.first, row[1], row[2]);
        if (areLinked_)
        {
            const auto begin = before_.begin() + run.first;
            const auto end = before_.begin() + run.last + 1;
            const auto known =
                std::find_if(begin, end, [](Side side) { return side != Side::unknown; });
            const bool isInside =
                known == end ? inside_.isInsideByWinding(place) : *known == Side::inside;
            return {isInside ? Side::inside : Side::outside, run.last};
        }
        const double distance = inside_.distance(place);
        const Side side = distance > 0 ? Side::inside : Side::outside;
        const double far = std::abs(distance);
        const double until =
            far < inside_.reach()
                ? place.x() + far - kDistanceSlack
                : inside_.farUntil(place, lattice_.centre(run.last, row[1], row[2]).x());
        return {side, lastBefore(until, run)};
    }

    /// The last site of some in a row that lies before a coordinate; the first of them if none
    /// does.
    [[nodiscard]] int lastBefore(double end, CellRun run) const
    {
        const double site = std::ceil((end - lattice_.origin.x()) / lattice_.cell - 0.5) - 1;
        int result = static_cast<int>(std::clamp<double>(site, run.first, run.last));
        while (result > run.first && lattice_.centre(result, 0, 0).x() >= end) // rounding
        {
            --result;
        }
        return result;
    }

    SiteLattice& sites_;
    const GridFrame& lattice_;
    const InsideTest& inside_;
    bool areLinked_; ///< nothing is between two sites side by side that are not near
    bool nearAreOpen_;
    /// Of the row before; unknown near the surface. Where that has no such sites, of an older one:
    /// what it has there, if it is not near, is outside, as is all between.
    std::vector<Side> before_;
};

// All threads close sites at once, each what it has found near its triangles.
void SiteLattice::closeNear(const Surface& surface, double distance, Threads& threads)
{
    const auto close = [&](int y, int z, CellRun run, auto&& isNear)
    {
        forEachWordOf(run,
                      [&](int x, std::uint64_t some)
                      {
                          const std::size_t number = find({x, y, z});
                          if (number == kNone)
                          {
                              return;
                          }
                          const std::atomic_ref word(bits_[number]);
                          std::uint64_t near = 0;
                          for (std::uint64_t left = word.load(std::memory_order_relaxed) & some;
                               left != 0; left &= left - 1)
                          {
                              near |= isNear(64 * x + std::countr_zero(left)) ? left & -left : 0;
                          }
                          if (near != 0)
                          {
                              word.fetch_and(~near, std::memory_order_relaxed);
                          }
                      });
    };
    forEachGroup(surface, lattice_.cell, threads,
                 [&](const TriangleGroup& group)
                 { forEachRunNear(lattice_, surface, group, distance, close); });
}

void SiteLattice::closeOutside(const InsideTest& inside, double distance, bool nearAreOpen,
                               Threads& threads)
{
    const int layers = lattice_.count[2];
    forEachSlab(threads, (layers + kSlabThickness - 1) / kSlabThickness,
                [&](int slab)
                {
                    Sides(*this, inside, distance, nearAreOpen)
                        .close(slab * kSlabThickness,
                               std::min(layers, (slab + 1) * kSlabThickness));
                });
}

} // namespace frostfill
