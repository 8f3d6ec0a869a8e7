// SPDX-License-Identifier: MIT
#include "simulation/paper/sphere_search.hpp"

#include <algorithm>
#include <vector>

namespace frostfill
{
namespace
{

/// How far from a sphere's surface others' centres may be to be looked at by way of a grid: the
/// largest radius, and as much again for what the spheres before may have pushed. [r]
constexpr double kGridReach = 2;

/// PAPER: every pair.
class AllPairs final : public SphereSearchPart
{
public:
    [[nodiscard]] std::span<const IdRange> near(const Spheres&, std::size_t,
                                                IdRange frozen) override
    {
        all_ = frozen;
        return {&all_, 1};
    }

private:
    IdRange all_;
};

/// Those in the cells near the sphere, in the order of all pairs: the same bits.
class ByGrid final : public SphereSearchPart
{
public:
    explicit ByGrid(const SphereGrid& resting) : resting_(resting) {}
    [[nodiscard]] std::span<const IdRange> near(const Spheres& spheres, std::size_t i,
                                                IdRange frozen) override
    {
        found_.clear();
        resting_.forEachNear(spheres.position(i), spheres.radius[i] + kGridReach,
                             [&](std::uint32_t id)
                             {
                                 if (id >= frozen.begin)
                                 {
                                     found_.push_back({id, id + std::size_t{1}});
                                 }
                             });
        std::sort(found_.begin(), found_.end(),
                  [](const IdRange& a, const IdRange& b) { return a.begin < b.begin; });
        return found_;
    }

private:
    const SphereGrid& resting_;
    std::vector<IdRange> found_;
};

} // namespace

PartTable<SphereSearch, MakeSphereSearch>& sphereSearches()
{
    static PartTable<SphereSearch, MakeSphereSearch> table = {
        [](const SphereGrid&) { return std::make_unique<AllPairs>(); },
        [](const SphereGrid& resting) { return std::make_unique<ByGrid>(resting); },
    };
    return table;
}

} // namespace frostfill
