// SPDX-License-Identifier: MIT
#include "base/timers.hpp"
#include "render/annotated_picture.hpp"
#include "render/pipeline.hpp"
#include "render/raster/tile_pipeline.hpp"

#include <frostfill/error.hpp>
#include <frostfill/renderer.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <memory>

namespace frostfill
{
namespace
{

/// Longest edge of a picture in tiles, as OpenGL has it in OSMesa.
constexpr std::int64_t kLongestEdge = 16384;
/// No driver draws more; most draw less, and say so.
constexpr std::int64_t kLongestEdgeOfOpenGl = 32768;

bool drawsInTiles(Backend backend)
{
    return backend == Backend::builtin || backend == Backend::automatic;
}

/// Everything in the picture grows with it, so a larger one made small shows the same.
RenderSettings enlarged(RenderSettings settings)
{
    if (settings.supersample < 1)
    {
        throw Error(ErrorCode::usage, "supersampling must be at least 1");
    }
    const std::int64_t width = std::int64_t{settings.size.width} * settings.supersample;
    const std::int64_t height = std::int64_t{settings.size.height} * settings.supersample;
    const std::int64_t longest =
        drawsInTiles(settings.backend) ? kLongestEdge : kLongestEdgeOfOpenGl;
    if (std::min(width, height) < 1 || std::max(width, height) > longest)
    {
        throw Error(ErrorCode::usage,
                    fmt::format("a picture of {}x{} pixels cannot be drawn: each edge must be "
                                "between 1 and {} pixels",
                                width, height, longest));
    }
    settings.size = {static_cast<int>(width), static_cast<int>(height)};
    return settings;
}

/// A sphere in an empty picture; true when it is there and its surroundings are background.
bool drawsASphere(PictureBackend& backend)
{
    Snapshot snapshot;
    snapshot.centres.emplace_back(0, 0, 0);
    snapshot.radii.push_back(0.4F);
    snapshot.states.push_back(SphereState::frozen);
    Image image;
    backend.readBack(image, backend.draw(snapshot, image));
    const auto* middle = image.at(image.width / 2, image.height / 2);
    const auto* corner = image.at(0, 0);
    return middle[2] > middle[0] && corner[0] == 255 && corner[2] == 255;
}

std::unique_ptr<PictureBackend> openBackend(const TriangleMesh& mesh,
                                            const RenderSettings& settings)
{
    if (drawsInTiles(settings.backend))
    {
        return std::make_unique<TilePipeline>(mesh, settings);
    }
    return std::make_unique<Pipeline>(mesh, settings);
}

} // namespace

struct Renderer::Implementation
{
    Implementation(const TriangleMesh& mesh, const RenderSettings& wanted)
        : size(wanted.size), backend(openBackend(mesh, enlarged(wanted))),
          picture(backend->viewpoint())
    {
    }

    PictureSize size; ///< that was asked for
    std::unique_ptr<PictureBackend> backend;
    AnnotatedPicture picture;
    StageTimes times;
    Surfaces surfaces; ///< reused from frame to frame
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
    auto& own = *implementation_;
    auto& picture = own.picture;
    const std::vector<PixelRectangle>* parts = nullptr;
    {
        const StageTimer timer(own.times, Stage::rendering);
        parts = &own.backend->draw(snapshot, picture.pixels());
    }
    {
        const StageTimer timer(own.times, Stage::readback);
        own.backend->readBack(picture.pixels(), *parts);
    }
    const StageTimer timer(own.times, Stage::rendering);
    picture.finish(*parts, snapshot);
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
    auto& own = *implementation_;
    const StageTimer timer(own.times, Stage::rendering);
    own.backend->lookFrom(camera);
}

void Renderer::turn(double degrees)
{
    auto& own = *implementation_;
    const StageTimer timer(own.times, Stage::rendering);
    own.backend->turn(degrees);
}

void Renderer::renderPasses(const Snapshot& snapshot, PassPictures& pictures)
{
    auto& own = *implementation_;
    const StageTimer timer(own.times, Stage::rendering);
    own.backend->drawSurfaces(snapshot, own.size, own.surfaces);
    makePassPictures(own.surfaces, own.backend->framing(), pictures);
}

const std::string& Renderer::description() const
{
    return implementation_->backend->description();
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
