// SPDX-License-Identifier: MIT
#include "import/sphere_numbers.hpp"

#include <algorithm>

namespace frostfill
{

void SphereNumbers::update(const std::vector<std::uint64_t>& ids)
{
    const std::unordered_map<std::uint64_t, std::size_t> before = std::move(places_);
    places_.clear();
    std::vector<std::uint64_t> fresh;
    for (std::size_t k = 0; k < ids.size(); ++k)
    {
        places_.emplace(ids[k], k);
        if (!before.contains(ids[k]))
        {
            fresh.push_back(ids[k]);
        }
    }
    std::sort(fresh.begin(), fresh.end());
    ids_.insert(ids_.end(), fresh.begin(), fresh.end());
    for (std::size_t number = 0; number < ids_.size();)
    {
        if (places_.contains(ids_[number]))
        {
            ++number;
            continue;
        }
        ids_[number] = ids_.back(); // which may be gone too: the number is looked at again
        ids_.pop_back();
    }
}

} // namespace frostfill
