// SPDX-License-Identifier: MIT
#include "simulation/discard/watch_lists.hpp"

#include <algorithm>

namespace frostfill
{

void WatchLists::add(const std::vector<Watcher>& watchers)
{
    for (std::size_t i = 0; i < watchers.size(); ++i)
    {
        const auto& [obstacle, witness] = watchers[i];
        if (i == 0 || witness != watchers[i - 1].witness)
        {
            lists_.push_back({witness, kNone});
        }
        next_[obstacle] = lists_.back().first;
        lists_.back().first = obstacle;
    }
}

std::vector<WatchLists::Watcher> WatchLists::takeFallen()
{
    std::vector<Watcher> fallen;
    std::size_t left = 0;
    for (std::size_t i = 0; i < lists_.size(); ++i)
    {
        if (stands_[i] != 0)
        {
            lists_[left++] = lists_[i];
            continue;
        }
        for (std::uint32_t one = lists_[i].first; one != kNone; one = next_[one])
        {
            fallen.push_back({one, lists_[i].witness});
        }
    }
    lists_.resize(left);
    std::sort(fallen.begin(), fallen.end(),
              [](const Watcher& a, const Watcher& b) { return a.obstacle < b.obstacle; });
    return fallen;
}

} // namespace frostfill
