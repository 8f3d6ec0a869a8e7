// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

/// Cells of a grid, row by row along x.
namespace frostfill
{

/// Widens a filter before the exact test: what a row is asked for. [cells] Smaller: rounding hides
/// a cell. Larger: cells are tested in vain.
inline constexpr double kFilterRounding = 1e-6;

/// Cells first..last of a row; none when last < first.
struct CellRun
{
    int first;
    int last;
};

/// Of rows that a search may leave out: none.
struct EveryRow
{
    template <class... Window>
    int operator()(int, int z, int, const Window&...) const
    {
        return z;
    }
};

/// Calls visit(word, bits) for the words of a row, 64 cells each, that have cells of a run: bit i
/// of word w is cell 64 w + i.
template <class Visit>
void forEachWordOf(CellRun run, Visit&& visit)
{
    for (int word = run.first / 64; run.first <= run.last && word <= run.last / 64; ++word)
    {
        std::uint64_t bits = ~std::uint64_t{0};
        bits &= word == run.first / 64 ? ~std::uint64_t{0} << run.first % 64 : bits;
        bits &= word == run.last / 64 ? ~std::uint64_t{0} >> (63 - run.last % 64) : bits;
        visit(word, bits);
    }
}

} // namespace frostfill
