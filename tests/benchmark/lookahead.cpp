// SPDX-License-Identifier: MIT
// How much of an instant fill (--motion descend) is shared among threads, and how much of that is
// done twice because something came to rest in the way. Counts, which a machine with fewer cores
// gives as well; the share of the time is that of one thread:
// build/release/tests/benchmark/benchmark_lookahead [RADIUS]

#include "simulation/engine/drop_and_roll_engine.hpp"

#include <frostfill/mesh.hpp>

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <cstdlib>

namespace frostfill
{
namespace
{

constexpr double kRadius = 0.0222; // 98,000 fill the cube

double secondsSince(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

struct Fill
{
    std::size_t spheres = 0;
    std::size_t paths = 0;
    double inPaths = 0; ///< [s] of one thread
    double all = 0;     ///< [s] of the rain, without what comes before and after it
};

Fill fillCube(double radius, int threadCount)
{
    Scene scene = presetScene(Preset::fast, "cube");
    scene.spheres.radius = radius;
    scene.spheres.count.reset();
    scene.motion.mode = Motion::descend;
    scene.discard.rule = DiscardRule::none;
    World world(scene, builtInMesh("cube"));
    Threads threads(threadCount);
    const std::unique_ptr<ReleasePart> release = makeRelease(world, world.height, threads);
    const DropAndRoll descent(world);
    ReleaseQuery query = queryOfRest(descent, threads.concurrency());
    std::atomic<std::size_t> paths = 0;
    Fill fill;
    query.prepare =
        [&, settle = query.prepare](Eigen::Vector3d& p, double its, Eigen::AlignedBox3d& seen)
    {
        ++paths;
        const auto start = std::chrono::steady_clock::now();
        const bool rests = settle(p, its, seen);
        fill.inPaths += threadCount == 1 ? secondsSince(start) : 0;
        return rests;
    };
    const auto start = std::chrono::steady_clock::now();
    while (const auto found = release->next(query))
    {
        world.spheres.addResting(found->place, found->radius, 0);
        release->close(found->place, found->radius);
    }
    fill.all = secondsSince(start);
    fill.spheres = world.spheres.size();
    fill.paths = paths;
    return fill;
}

void measure(double radius)
{
    fmt::print(
        "cube, radius {:g}, until full, --motion descend\n{:>8} {:>10} {:>10} {:>14} {:>22}\n",
        radius, "threads", "spheres", "paths", "done again", "times as fast, if all");
    fmt::print("{:>8} {:>10} {:>10} {:>14} {:>22}\n", "", "", "", "[% of spheres]",
               "else is on one thread");
    double shared = 0;
    for (const int threads : {1, 2, 4, 16, 64})
    {
        const Fill fill = fillCube(radius, threads);
        shared = threads == 1 ? fill.inPaths / fill.all : shared;
        const double each = static_cast<double>(fill.paths) / static_cast<double>(fill.spheres);
        fmt::print("{:>8} {:>10} {:>10} {:>14.2f} {:>22.1f}\n", threads, fill.spheres, fill.paths,
                   100 * (each - 1), 1 / (1 - shared + shared * each / threads));
        std::fflush(stdout);
    }
    fmt::print("On one thread {:.0f} % of the time of the rain are paths.\n", 100 * shared);
}

} // namespace
} // namespace frostfill

int main(int argc, char** argv)
{
    frostfill::measure(argc > 1 ? std::atof(argv[1]) : frostfill::kRadius);
    return 0;
}
