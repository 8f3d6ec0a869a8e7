// SPDX-License-Identifier: MIT
#include "base/processor_time.hpp"
#include "study/error/error_finish.hpp"
#include "study/error/error_runs.hpp"
#include "study/error/tessellated_spheres.hpp"

#include <frostfill/renderer.hpp>
#include <frostfill/simulation.hpp>

#include <fmt/format.h>

#include <algorithm>
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
constexpr int kFinest = 5;     // subdivisions of the reference for tessellated spheres
constexpr float kScale = 0.5F; // that brings a torus of size 3 into view

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
        return measure(
            "exact spheres", fmt::format("{} samples, {}x{}", samples, supersample, supersample),
            isDefault, {static_cast<double>(samples), static_cast<double>(supersample), 0},
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
        return measure(
            "tessellated spheres", fmt::format("{} triangles, {} samples", triangles, samples),
            false, {static_cast<double>(samples), 1, static_cast<double>(triangles)},
            tessellatedReference_, [&](Image& image) { spheres.draw(snapshot_, image); });
    }

private:
    template <class Draw>
    static ErrorPoint measure(const char* curve, const std::string& setting, bool isDefault,
                              std::vector<double> details, const Image& reference, Draw&& draw)
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
                apart.rootMeanSquare, details, false,   ""};
    }

    TriangleMesh mesh_;
    Snapshot snapshot_;
    RenderSettings settings_;
    Image reference_;
    Image tessellatedReference_;
};

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

} // namespace frostfill
