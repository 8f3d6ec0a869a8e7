// SPDX-License-Identifier: MIT
// How many threads a crowd keeps busy that is taken strip by strip in the order of one thread.
// Counts, which a machine with fewer cores gives as well: a turn takes one unit of time, and
// nothing else does. build/release/tests/benchmark/benchmark_strips [SPHERES]

#include "simulation/engine/make_engine.hpp"
#include "simulation/solver/turns.hpp"

#include <frostfill/mesh.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>

namespace frostfill
{
namespace
{

constexpr std::uint64_t kSpheres = 20000;
constexpr int kStepsBetween = 50;
constexpr std::array kStrips = {1, 2, 4, 16, 64};

struct Count
{
    std::size_t strips = 0;
    std::size_t members = 0;
    std::size_t shared = 0; ///< near to some of other strips
    std::size_t time = 0;   ///< of a sweep, in turns
};

/// A member's turn begins once its strip and those below it in other strips are ready.
std::size_t timeOfSweep(const Crowd& crowd)
{
    std::vector<std::uint32_t> slots(crowd.size());
    std::vector<std::size_t> strip(crowd.size());
    for (std::size_t k = 0; k < crowd.strips().size(); ++k)
    {
        crowd.forEachMember(k,
                            [&](std::uint32_t slot)
                            {
                                slots[crowd.rank(slot)] = slot;
                                strip[slot] = k;
                            });
    }
    std::vector<std::size_t> ready(crowd.strips().size(), 0);
    std::vector<std::size_t> done(crowd.size(), 0);
    for (const std::uint32_t slot : slots)
    {
        std::size_t begin = ready[strip[slot]];
        for (const Crowd::Near& near : crowd.near(slot))
        {
            begin = near.isLower != 0 ? std::max(begin, done[near.slot]) : begin;
        }
        done[slot] = ready[strip[slot]] = begin + 1;
    }
    return *std::max_element(ready.begin(), ready.end());
}

void countStrips(World& world, int strips, Count& count)
{
    Threads threads(strips, static_cast<std::size_t>(strips));
    BroadPhase pairs(world.spheres.running(), threads);
    pairs.findPairs();
    Crowd crowd(world.spheres.running(), pairs, threads);
    crowd.gather({0, -1, 0});
    crowd.arrange();
    crowd.forEachStrip([&](std::size_t k) { crowd.enlist(k); });
    if (crowd.size() == 0)
    {
        return;
    }
    count.strips = std::max(count.strips, crowd.strips().size());
    count.members += crowd.size();
    count.time += timeOfSweep(crowd);
    for (std::uint32_t slot = 0; slot < crowd.size(); ++slot)
    {
        count.shared += crowd.isShared(slot) ? 1 : 0;
    }
}

void measure(std::uint64_t spheres, std::uint64_t groupSize)
{
    Scene scene = presetScene(Preset::fast, "cube");
    scene.spheres.count = spheres;
    scene.spheres.groupSize = static_cast<std::uint32_t>(groupSize);
    scene.spheres.groupsPerSet = 1;
    World world(scene, builtInMesh("cube"));
    const auto engine = makeEngine(world);
    std::array<Count, kStrips.size()> counts;
    for (int step = 0; engine->step(); ++step)
    {
        for (std::size_t k = 0; step % kStepsBetween == 0 && k < kStrips.size(); ++k)
        {
            countStrips(world, kStrips[k], counts[k]);
        }
    }
    fmt::print("cube, {} spheres, {}\n{:>8} {:>8} {:>22} {:>22}\n", spheres,
               groupSize == 0 ? "sets as usual" : fmt::format("{} at a time", groupSize), "threads",
               "strips", "near another strip [%]", "turns at once, mean");
    for (std::size_t k = 0; k < kStrips.size(); ++k)
    {
        const Count& count = counts[k];
        const auto members = static_cast<double>(count.members);
        fmt::print("{:>8} {:>8} {:>22.1f} {:>22.1f}\n", kStrips[k], count.strips,
                   100 * static_cast<double>(count.shared) / members,
                   members / static_cast<double>(count.time));
    }
}

} // namespace
} // namespace frostfill

int main(int argc, char** argv)
{
    const std::uint64_t spheres =
        argc > 1 ? std::strtoull(argv[1], nullptr, 10) : frostfill::kSpheres;
    frostfill::measure(spheres, 0);
    frostfill::measure(spheres, spheres / 4);
    frostfill::measure(spheres, spheres);
    return 0;
}
