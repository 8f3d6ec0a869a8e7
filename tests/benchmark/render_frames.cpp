// SPDX-License-Identifier: MIT
// What a frame takes: to memory with the static layer, with everything redrawn, with the shell; and
// to PNG files. Milliseconds and frames a second of one run on this
// machine. Run it by hand on an idle machine:
// build/release/tests/benchmark/benchmark_render [--samples 4] [--quick] [--opengl] [--only WORD]
// `--opengl` draws with OpenGL what is otherwise drawn without it.

#include "benchmark/render_scene.hpp"
#include "run/frame_writer.hpp"

#include <frostfill/renderer.hpp>

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <vector>

namespace frostfill::benchmark
{
namespace
{

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

struct Timing
{
    double best = 1e30;   ///< [ms]
    double median = 1e30; ///< [ms]
    double processor = 0; ///< [ms] mean over all threads, which other programs disturb less
};

/// The most memory that the process has had; it counts what is measured first only.
std::size_t peakBytes()
{
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return 1024 * static_cast<std::size_t>(usage.ru_maxrss);
}

/// `work` is called `count` times; the first two are not counted.
template <class Work>
Timing timed(int count, Work work)
{
    std::vector<double> times;
    std::clock_t processor = 0;
    for (int i = 0; i < count + 2; ++i)
    {
        processor = i == 2 ? std::clock() : processor;
        const auto start = Clock::now();
        work();
        times.push_back(millisecondsSince(start));
    }
    times.erase(times.begin(), times.begin() + 2);
    std::sort(times.begin(), times.end());
    const double processorMs = 1e3 * static_cast<double>(std::clock() - processor) /
                               (static_cast<double>(CLOCKS_PER_SEC) * count);
    return {times.front(), times[times.size() / 2], processorMs};
}

void print(const std::string& what, const Timing& timing)
{
    fmt::print("{:46} {:10.3f} {:10.3f} {:10.3f}\n", what, timing.best, timing.median,
               timing.processor);
}

struct Options
{
    int samples = 1;
    bool quick = false;
    bool openGl = false;
    std::string only; ///< part of the names of what is measured
};

RenderSettings settingsFor(const Options& options)
{
    RenderSettings settings;
    settings.samples = options.samples;
    settings.backend = options.openGl ? Backend::osmesa : Backend::automatic;
    settings.style.legend = false;
    settings.style.shell = false;
    return settings;
}

std::vector<std::uint8_t> rowsOf(const Renderer& renderer)
{
    return {renderer.changedRows().begin(), renderer.changedRows().end()};
}

Timing frameToMemory(const Options& options, std::size_t frozen, std::size_t running, int quads,
                     bool legend = false)
{
    RenderSettings settings = settingsFor(options);
    settings.style.shell = quads > 0;
    settings.style.legend = legend;
    RenderScene scene(frozen, running);
    Renderer renderer(unitCube(std::max(quads, 1)), settings);
    return timed(options.quick ? 50 : 400,
                 [&]
                 {
                     static_cast<void>(renderer.draw(scene.snapshot));
                     scene.advance();
                 });
}

Timing everythingRedrawn(const Options& options, std::size_t frozen, bool layer, int quads = 0,
                         Look look = Look::clean)
{
    RenderSettings settings = settingsFor(options);
    settings.style.look = look;
    settings.style.palette = paletteOf(look);
    settings.staticLayer = layer;
    settings.style.shell = settings.style.legend = quads > 0;
    const RenderScene scene(frozen, 20);
    const std::size_t before = peakBytes();
    Renderer renderer(unitCube(std::max(quads, 1)), settings);
    double azimuth = 30;
    const Timing timing = timed(options.quick || frozen > 1000000 ? 5 : 20,
                                [&]
                                {
                                    settings.camera.azimuth = azimuth += 7;
                                    renderer.setCamera(settings.camera);
                                    static_cast<void>(renderer.draw(scene.snapshot));
                                });
    if (frozen >= 1000000)
    {
        fmt::print("{:46} {:10.1f}\n", "  bytes a sphere beyond the state, at the peak",
                   static_cast<double>(peakBytes() - before) / static_cast<double>(frozen));
    }
    return timing;
}

/// Frames a second from snapshots to files: what a run does, without the simulation.
double framesPerSecond(const Options& options, const std::filesystem::path& folder, int frames)
{
    RenderScene scene(10000, 20);
    Renderer renderer(unitCube(1), settingsFor(options));
    FrameWriter writer(folder, {{"Software", "Frostfill"}});
    static_cast<void>(renderer.draw(scene.snapshot));
    scene.advance();
    const auto start = Clock::now();
    for (int i = 0; i < frames; ++i)
    {
        const Image& image = renderer.draw(scene.snapshot);
        writer.put(static_cast<std::size_t>(i), image,
                   i == 0 ? std::vector<std::uint8_t>(720, 1) : rowsOf(renderer), 0, {});
        scene.advance();
    }
    writer.finish();
    const double seconds = millisecondsSince(start) / 1000;
    fmt::print("{:46} {:10.3f} {:10.3f}\n", "  of that encoding and writing, ms a frame",
               1000 * writer.times()[Stage::encoding] / frames,
               1000 * writer.times()[Stage::writing] / frames);
    return frames / seconds;
}

void measureFiles(const Options& options)
{
    const auto folder =
        std::filesystem::temp_directory_path() / fmt::format("frostfill_benchmark_{}", ::getpid());
    std::filesystem::create_directories(folder);
    const double ours = framesPerSecond(options, folder, options.quick ? 100 : 600);
    std::filesystem::remove_all(folder);
    fmt::print("10k + 20 to PNG files: {:.1f} frames/s\n", ours);
}

void run(const Options& options)
{
    fmt::print("1280x720, {} sample(s) a pixel\n{:46} {:>10} {:>10} {:>10}\n", options.samples, "",
               "best ms", "median ms", "all cores");
    const auto measure = [&](const std::string& what, const auto& work)
    {
        if (what.find(options.only) != std::string::npos)
        {
            print(what, work());
        }
    };
    measure("10k frozen + 20 running, to memory",
            [&] { return frameToMemory(options, 10000, 20, 0); });
    measure("the same with a legend", [&] { return frameToMemory(options, 10000, 20, 0, true); });
    measure("10k frozen + 200 running", [&] { return frameToMemory(options, 10000, 200, 0); });
    measure("100k frozen + 20 running", [&] { return frameToMemory(options, 100000, 20, 0); });
    measure("10k + 20 and a shell of 5,292 triangles",
            [&] { return frameToMemory(options, 10000, 20, 21); });
    measure("the same with a legend: a default picture",
            [&] { return frameToMemory(options, 10000, 20, 21, true); });
    measure("10k, default picture, camera moves",
            [&] { return everythingRedrawn(options, 10000, true, 21); });
    measure("1M, default picture, camera moves",
            [&] { return everythingRedrawn(options, 1000000, true, 21); });
    if (!options.only.empty()) // they take gigabytes
    {
        measure("10M, default picture, camera moves",
                [&] { return everythingRedrawn(options, 10000000, true, 21); });
        measure("10M, studio, camera moves",
                [&] { return everythingRedrawn(options, 10000000, true, 21, Look::studio); });
    }
    if (options.only.empty())
    {
        measureFiles(options);
    }
    measure("10k, camera moves", [&] { return everythingRedrawn(options, 10000, true); });
    measure("10k, camera moves, layer off",
            [&] { return everythingRedrawn(options, 10000, false); });
    measure("100k, camera moves", [&] { return everythingRedrawn(options, 100000, true); });
    measure("100k, camera moves, layer off",
            [&] { return everythingRedrawn(options, 100000, false); });
    if (!options.quick)
    {
        measure("1M frozen + 20 running", [&] { return frameToMemory(options, 1000000, 20, 0); });
        measure("1M, camera moves", [&] { return everythingRedrawn(options, 1000000, true); });
    }
}

} // namespace
} // namespace frostfill::benchmark

int main(int argc, char** argv)
{
    frostfill::benchmark::Options options;
    for (int i = 1; i < argc; ++i)
    {
        options.openGl = options.openGl || std::strcmp(argv[i], "--opengl") == 0;
        options.quick = options.quick || std::strcmp(argv[i], "--quick") == 0;
        if (std::strcmp(argv[i], "--only") == 0 && i + 1 < argc)
        {
            options.only = argv[++i];
        }
        if (std::strcmp(argv[i], "--samples") == 0 && i + 1 < argc)
        {
            options.samples = std::atoi(argv[++i]);
        }
    }
    frostfill::benchmark::run(options);
}
