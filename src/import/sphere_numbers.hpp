// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace frostfill
{

/// Gives spheres that are known by ids numbers from 0 without a gap, as snapshots have them. New
/// ones come last, by their ids. When a sphere is gone, the last one takes its number.
class SphereNumbers
{
public:
    /// The ids that are there now, in any order, none twice.
    void update(const std::vector<std::uint64_t>& ids);
    [[nodiscard]] std::size_t count() const { return ids_.size(); }
    [[nodiscard]] std::uint64_t id(std::size_t number) const { return ids_[number]; }
    /// Where the sphere was in the list of the last update.
    [[nodiscard]] std::size_t index(std::size_t number) const { return places_.at(ids_[number]); }

private:
    std::vector<std::uint64_t> ids_;                        ///< by number
    std::unordered_map<std::uint64_t, std::size_t> places_; ///< in the list, by id
};

} // namespace frostfill
