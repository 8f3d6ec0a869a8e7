// SPDX-License-Identifier: MIT
#include <frostfill/renderer.hpp>

#include "pipeline.hpp"
#include "shown_picture.hpp"

#include <frostfill/error.hpp>

#include <chrono>

namespace frostfill
{
namespace
{

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A sphere in an empty picture; true when it is there and its surroundings are background.
bool drawsASphere(Pipeline& pipeline)
{
    Snapshot snapshot;
    snapshot.centres.emplace_back(0, 0, 0);
    snapshot.radii.push_back(0.4F);
    snapshot.states.push_back(SphereState::frozen);
    pipeline.draw(snapshot);
    Image image;
    pipeline.readColour(image);
    const auto* middle = image.at(image.width / 2, image.height / 2);
    const auto* corner = image.at(0, 0);
    return middle[2] > middle[0] && corner[0] == 255 && corner[2] == 255;
}

} // namespace

struct Renderer::Implementation
{
    Implementation(const TriangleMesh& mesh, const RenderSettings& settings)
        : pipeline(mesh, settings)
    {
    }

    Pipeline pipeline;
    ShownPicture picture;
    StageTimes times;
};

Renderer::Renderer(const TriangleMesh& mesh, const RenderSettings& settings)
    : implementation_(std::make_unique<Implementation>(mesh, settings))
{
}

Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

const Image& Renderer::draw(const Snapshot& snapshot)
{
    auto& [pipeline, picture, times] = *implementation_;
    const auto drawing = Clock::now();
    const auto& parts = pipeline.draw(snapshot);
    times[Stage::rendering] += secondsSince(drawing);

    const auto reading = Clock::now();
    pipeline.readColour(picture.pixels(), parts);
    times[Stage::readback] += secondsSince(reading);

    const auto writing = Clock::now();
    picture.finish(parts, pipeline.legend(), snapshot);
    times[Stage::rendering] += secondsSince(writing);
    return picture.image();
}

std::span<const std::uint8_t> Renderer::changedRows() const
{
    return implementation_->picture.changedRows();
}

void Renderer::render(const Snapshot& snapshot, Image& image)
{
    image = draw(snapshot);
}

void Renderer::setCamera(const Camera& camera)
{
    implementation_->pipeline.lookFrom(camera);
}

const std::string& Renderer::description() const
{
    return implementation_->pipeline.description();
}

const StageTimes& Renderer::times() const
{
    return implementation_->times;
}

std::vector<BackendAttempt> probeBackends()
{
    TriangleMesh tetrahedron;
    tetrahedron.vertices = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    tetrahedron.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
    RenderSettings settings;
    settings.size = {64, 64};

    std::vector<BackendAttempt> attempts;
    for (const BackendChoice& choice : backendChoices())
    {
        BackendAttempt attempt{choice.name, false, {}, choice.remedy};
        try
        {
            settings.backend = choice.backend;
            settings.style.legend = false;
            settings.style.shell = false;
            Pipeline pipeline(tetrahedron, settings);
            attempt.works = drawsASphere(pipeline);
            attempt.description = pipeline.description();
            if (!attempt.works)
            {
                attempt.description += " (draws a wrong picture)";
            }
        }
        catch (const Error& error)
        {
            attempt.description = error.what();
        }
        if (attempt.works)
        {
            attempt.remedy.clear();
        }
        attempts.push_back(attempt);
    }
    return attempts;
}

} // namespace frostfill
