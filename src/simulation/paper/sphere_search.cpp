// SPDX-License-Identifier: MIT
#include "simulation/paper/sphere_search.hpp"

#include "simulation/paper/tolerances.hpp"

#include <algorithm>
#include <vector>

namespace frostfill
{
namespace
{

/// PAPER: every pair.
class AllPairs final : public SphereSearchPart
{
public:
    [[nodiscard]] std::span<const IdRange> near(const Spheres&, std::uint32_t,
                                                IdRange frozen) override
    {
        all_ = frozen;
        return {&all_, 1};
    }

private:
    IdRange all_;
};

/// Those in the cells near the sphere, in the order of all pairs: the same bits.
class SpheresByGrid final : public SphereSearchPart
{
public:
    explicit SpheresByGrid(const SphereGrid& resting) : resting_(resting) {}
    [[nodiscard]] std::span<const IdRange> near(const Spheres& spheres, std::uint32_t i,
                                                IdRange frozen) override
    {
        ids_.clear();
        const RunningSpheres& running = spheres.running();
        resting_.forEachNear(running.position[i], running.radius[i] + kGridReach,
                             [&](std::uint32_t id)
                             {
                                 if (id >= frozen.begin)
                                 {
                                     ids_.push_back(id);
                                 }
                             });
        std::sort(ids_.begin(), ids_.end());
        ranges_.resize(std::max(ranges_.size(), ids_.size()));
        IdRange* end = ranges_.data();
        for (const std::size_t id : ids_)
        {
            if (end == ranges_.data() || end[-1].end != id)
            {
                *end++ = {id, id};
            }
            ++end[-1].end;
        }
        return {ranges_.data(), end};
    }

private:
    const SphereGrid& resting_;
    std::vector<std::uint32_t> ids_;
    std::vector<IdRange> ranges_;
};

} // namespace

std::unique_ptr<SphereSearchPart> makeSphereSearch(SphereSearch search, const SphereGrid& resting)
{
    if (search == SphereSearch::allPairs)
    {
        return std::make_unique<AllPairs>();
    }
    return std::make_unique<SpheresByGrid>(resting);
}

} // namespace frostfill
