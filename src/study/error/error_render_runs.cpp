// SPDX-License-Identifier: MIT
#include "base/processor_time.hpp"
#include "study/error/error_finish.hpp"
#include "study/error/error_runs.hpp"
#include "study/error/tessellated_spheres.hpp"

#include <frostfill/renderer.hpp>
#include <frostfill/simulation.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace frostfill
{
namespace
{

/// Pictures that are drawn for one time; the least counts.
constexpr int kPictures = 5;
/// The reference has so many times as many pixels each way.
constexpr int kReference = 16;
/// And that of the shell, with 4 samples each.
constexpr int kShellReference = 8;
constexpr int kFinest = 5;     // subdivisions of the reference for tessellated spheres
constexpr float kScale = 0.5F; // that brings a torus of size 3 into view

/// Times `draw` and compares what it draws with `reference`. Completes the details.
template <class Draw>
ErrorPoint measurePictures(const char* curve, const std::string& setting, bool isDefault,
                           std::vector<double> details, const std::string& rivals,
                           const Image& reference, Draw&& draw)
{
    Image image;
    draw(image); // uploads, compiles
    double seconds = std::numeric_limits<double>::infinity();
    for (int k = 0; k < kPictures; ++k)
    {
        const ProcessorClock clock;
        draw(image);
        seconds = std::min(seconds, clock.seconds());
    }
    const ImageDifference apart = compareImages(image, reference);
    details.push_back(apart.largest);
    details.push_back(static_cast<double>(apart.pixelsApart));
    return {"rendering",          curve,   setting, isDefault, seconds,
            apart.rootMeanSquare, details, false,   rivals};
}

/// A filled torus as it is drawn, and the picture that all others are compared with.
class Subject
{
public:
    explicit Subject(bool quick) : mesh_(builtInMesh("torus"))
    {
        Scene scene = presetScene(Preset::fast, "torus");
        scene.spheres.count = quick ? 200 : 1000;
        scene.spheres.radius.reset();
        scene.motion.mode = Motion::skip;
        Simulation simulation(scene, mesh_);
        while (simulation.step())
        {
        }
        simulation.capture(snapshot_);
        settings_.size = quick ? PictureSize{240, 135} : PictureSize{480, 270};
        settings_.style.legend = false;
        settings_.style.shell = false;
        settings_.staticLayer = false; // all of it is drawn each time
        RenderSettings fine = settings_;
        fine.samples = 1;
        fine.supersample = kReference;
        Renderer(mesh_, fine).render(snapshot_, reference_);
    }

    [[nodiscard]] ErrorPoint exact(int samples, int supersample) const
    {
        RenderSettings settings = settings_;
        settings.samples = samples;
        settings.supersample = supersample;
        Renderer renderer(mesh_, settings);
        const RenderSettings usual;
        const bool isDefault = samples == usual.samples && supersample == usual.supersample;
        return measurePictures(
            "exact spheres", fmt::format("{} samples, {}x{}", samples, supersample, supersample),
            isDefault, {static_cast<double>(samples), static_cast<double>(supersample), 0}, "",
            reference_, [&](Image& image) { renderer.render(snapshot_, image); });
    }

    /// With a shading of their own, so beside a picture that has it too: of finer spheres.
    [[nodiscard]] ErrorPoint tessellated(int subdivisions, int samples)
    {
        if (tessellatedReference_.pixels.empty())
        {
            TessellatedSpheres(settings_.size, 1, kReference, kFinest, kScale)
                .draw(snapshot_, tessellatedReference_);
        }
        TessellatedSpheres spheres(settings_.size, samples, 1, subdivisions, kScale);
        const int triangles = 20 << (2 * subdivisions);
        return measurePictures(
            "tessellated spheres", fmt::format("{} triangles, {} samples", triangles, samples),
            false, {static_cast<double>(samples), 1, static_cast<double>(triangles)}, "",
            tessellatedReference_, [&](Image& image) { spheres.draw(snapshot_, image); });
    }

private:
    TriangleMesh mesh_;
    Snapshot snapshot_;
    RenderSettings settings_;
    Image reference_;
    Image tessellatedReference_;
};

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
    const std::string triangles = fmt::format("{} triangles", mesh.triangles.size());
    return measurePictures(
        "shell", fmt::format("{}, {} samples", triangles, samples), isDefault,
        {static_cast<double>(samples), 1, static_cast<double>(mesh.triangles.size())},
        "shell of " + triangles, reference,
        [&](Image& image) { renderer.render(snapshot, image); });
}

} // namespace

void addRenderRuns(std::vector<ErrorTask>& tasks, bool quick)
{
    // Made when it is asked for first.
    const auto subject = std::make_shared<std::unique_ptr<Subject>>();
    const auto made = [=]() -> Subject&
    {
        if (!*subject)
        {
            *subject = std::make_unique<Subject>(quick);
        }
        return **subject;
    };
    for (const int samples : {1, 2, 4})
    { // the most that Mesa's software has
        tasks.emplace_back([=] { return made().exact(samples, 1); });
    }
    for (const int supersample : {2, 3, 4})
    {
        tasks.emplace_back([=] { return made().exact(1, supersample); });
    }
    for (const int subdivisions : {1, 2, 3, 4})
    {
        for (const int samples : {1, 4})
        {
            tasks.emplace_back([=] { return made().tessellated(subdivisions, samples); });
        }
    }
}

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
