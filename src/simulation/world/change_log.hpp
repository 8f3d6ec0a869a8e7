// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace frostfill
{

/// Ids in the order in which the state of their spheres changed. It keeps the newest changes only,
/// at most a quarter as many as there are spheres: who follows a run looks often, and who looks
/// seldom has to look at most of them anyway.
class ChangeLog
{
public:
    /// All changes so far.
    [[nodiscard]] std::size_t count() const { return forgotten_ + ids_.size(); }

    /// One of so many spheres has changed.
    void add(std::uint32_t id, std::size_t spheres)
    {
        const std::size_t kept = std::max(kKept, spheres / 8);
        if (ids_.size() >= 2 * kept)
        {
            const std::size_t old = ids_.size() - kept;
            ids_.erase(ids_.begin(), ids_.begin() + static_cast<std::ptrdiff_t>(old));
            forgotten_ += old;
        }
        ids_.push_back(id);
    }

    /// Calls visit(id), in order and maybe more than once, for whatever has changed since count()
    /// was `seen`; for each of so many spheres if not all of that is kept. Brings `seen` up to
    /// date.
    template <class Visit>
    void forEachSince(std::size_t& seen, std::size_t spheres, Visit&& visit) const
    {
        if (seen < forgotten_)
        {
            for (std::uint32_t id = 0; id < spheres; ++id)
            {
                visit(id);
            }
            seen = count();
        }
        for (; seen < count(); ++seen)
        {
            visit(ids_[seen - forgotten_]);
        }
    }

private:
    static constexpr std::size_t kKept = 4096; ///< however few spheres there are

    std::size_t forgotten_ = 0;
    std::vector<std::uint32_t> ids_;
};

} // namespace frostfill
