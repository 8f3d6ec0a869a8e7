// SPDX-License-Identifier: MIT
#include "base/processor_time.hpp"
#include "study/error/error_runs.hpp"

#include <frostfill/renderer.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace frostfill
{
namespace
{

/// Pictures that are drawn for one time; the least counts.
constexpr int kShellPictures = 5;
/// The reference: so many times as many pixels each way, with 4 samples each.
constexpr int kShellReference = 8;

/// A torus with so many quads along its tube, and a quarter of that around it.
TriangleMesh torusOf(std::uint32_t along)
{
    const std::uint32_t around = along / 4;
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < along; ++i)
    {
        for (std::uint32_t j = 0; j < around; ++j)
        {
            const double u = 2 * M_PI * i / along;
            const double v = 2 * M_PI * j / around;
            const double ring = 1 + 0.4 * std::cos(v);
            mesh.vertices.emplace_back(ring * std::cos(u), ring * std::sin(u), 0.4 * std::sin(v));
        }
    }
    for (std::uint32_t i = 0; i < along; ++i)
    {
        for (std::uint32_t j = 0; j < around; ++j)
        {
            const auto at = [&](std::uint32_t u, std::uint32_t v)
            { return u % along * around + v % around; };
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    return mesh;
}

/// The shell alone, its lower half discarded, against the same with 256 samples a pixel.
ErrorPoint shellRun(std::uint32_t along, int samples, bool quick)
{
    const TriangleMesh mesh = torusOf(along);
    Snapshot snapshot;
    for (const auto& triangle : mesh.triangles)
    {
        snapshot.polygons.push_back(mesh.vertices[triangle[0]].y() < 0 ? PolygonState::discarded
                                                                       : PolygonState::active);
    }
    RenderSettings settings;
    settings.size = quick ? PictureSize{240, 135} : PictureSize{480, 270};
    settings.style.legend = false;
    settings.staticLayer = false;
    RenderSettings fine = settings;
    fine.supersample = kShellReference;
    Image reference;
    Renderer(mesh, fine).render(snapshot, reference);

    const bool isDefault = samples == settings.samples;
    settings.samples = samples;
    Renderer renderer(mesh, settings);
    Image image;
    renderer.render(snapshot, image); // uploads, compiles
    double seconds = std::numeric_limits<double>::infinity();
    for (int k = 0; k < kShellPictures; ++k)
    {
        const ProcessorClock clock;
        renderer.render(snapshot, image);
        seconds = std::min(seconds, clock.seconds());
    }
    const ImageDifference apart = compareImages(image, reference);
    const auto triangles = static_cast<double>(mesh.triangles.size());
    const std::string setting =
        fmt::format("{} triangles, {} samples", mesh.triangles.size(), samples);
    return {"rendering",
            "shell",
            setting,
            isDefault,
            seconds,
            apart.rootMeanSquare,
            {static_cast<double>(samples), 1, triangles, double(apart.largest),
             static_cast<double>(apart.pixelsApart)},
            false,
            fmt::format("shell of {} triangles", mesh.triangles.size())};
}

} // namespace

void addShellRuns(std::vector<ErrorTask>& tasks, bool quick)
{
    for (const std::uint32_t along : {48U, 192U, 768U})
    {
        for (const int samples : {1, 4})
        {
            tasks.emplace_back([=] { return shellRun(along, samples, quick); });
        }
    }
}

} // namespace frostfill
