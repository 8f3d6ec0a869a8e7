// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace frostfill
{

/// Disjoint sets of numbers. The smallest number represents its set.
class DisjointSets
{
public:
    explicit DisjointSets(std::size_t count) : parent_(count)
    {
        std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
    }

    std::size_t find(std::size_t i)
    {
        while (parent_[i] != i)
        {
            parent_[i] = parent_[parent_[i]];
            i = parent_[i];
        }
        return i;
    }

    /// Whether the two were apart.
    bool join(std::size_t i, std::size_t j)
    {
        i = find(i);
        j = find(j);
        parent_[i < j ? j : i] = static_cast<std::uint32_t>(i < j ? i : j);
        return i != j;
    }

private:
    std::vector<std::uint32_t> parent_;
};

} // namespace frostfill
