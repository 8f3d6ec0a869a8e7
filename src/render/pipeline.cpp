// SPDX-License-Identifier: MIT
#include "render/pipeline.hpp"

#include "render/framing/front.hpp"
#include "render/framing/pose_framing.hpp"

#include <frostfill/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace frostfill
{
namespace
{

/// Nearest first pays from so many spheres at rest: only then are many of them found hidden.
constexpr std::size_t kSortFrom = 2000;

/// More samples a pixel than this are not to be had from OSMesa.
constexpr int kMostSamples = 4;

std::string describe(const Context& context, const GlFunctions& gl)
{
    const auto text = [&](GLenum name)
    {
        const auto* value = reinterpret_cast<const char*>(gl.getString(name));
        return value != nullptr ? value : "?";
    };
    return fmt::format("{}: {}, {}, OpenGL {}", context.name(), text(GL_RENDERER), text(GL_VENDOR),
                       text(GL_VERSION));
}

/// Refuses what cannot be drawn, and finds the front of the object.
RenderSettings checked(const RenderSettings& wanted, const TriangleMesh& mesh)
{
    RenderSettings settings = wanted;
    if (settings.samples < 1 || settings.samples > kMostSamples)
    {
        throw Error(ErrorCode::usage,
                    fmt::format("samples per pixel must be between 1 and {}, not {}", kMostSamples,
                                settings.samples));
    }
    if (settings.size.width < 1 || settings.size.height < 1)
    {
        throw Error(ErrorCode::usage, fmt::format("a picture of {}x{} pixels cannot be drawn",
                                                  settings.size.width, settings.size.height));
    }
    if (!settings.camera.azimuth)
    {
        settings.camera.azimuth = frontAzimuth(mesh, settings.up.normalized());
    }
    return settings;
}

} // namespace

Pipeline::Pipeline(const TriangleMesh& mesh, const RenderSettings& wanted)
    : settings_(checked(wanted, mesh)), vertices_(verticesInPoses(mesh.vertices, wanted.poses)),
      colours_(settings_, vertices_), legend_(settings_, mesh.triangles.size(), colours_),
      still_(frameBesideLegend(vertices_, settings_, legend_)), framing_(still_),
      context_(openContext(wanted.backend)), gl_(loadGlFunctions(*context_)),
      description_(describe(*context_, gl_)),
      framebuffer_(gl_, wanted.size.width, wanted.size.height, wanted.samples),
      painter_(gl_, mesh, settings_, legend_, colours_, framing_, samplePositions()),
      projector_(framing_, wanted.size), dirty_(wanted.size.width, wanted.size.height),
      covered_(dirty_)
{
    if (wanted.staticLayer)
    {
        layer_.emplace(gl_, wanted.size, wanted.samples);
    }
}

Pipeline::~Pipeline()
{
    // What the members give back belongs to this context.
    try
    {
        context_->makeCurrent();
    }
    catch (const Error&)
    {
        // The context is lost, and with it all that was in it.
    }
}

std::vector<glm::vec2> Pipeline::samplePositions() const
{
    std::vector<glm::vec2> positions;
    for (int i = 0; framebuffer_.samples() > 1 && i < framebuffer_.samples(); ++i)
    {
        std::array<GLfloat, 2> position{};
        gl_.getMultisamplefv(GL_SAMPLE_POSITION, static_cast<GLuint>(i), position.data());
        positions.emplace_back(position[0] - 0.5F, position[1] - 0.5F);
    }
    return positions;
}

void Pipeline::lookFrom(const Camera& camera)
{
    if (camera.orthographic != framing_.orthographic)
    {
        throw Error(ErrorCode::usage,
                    "a renderer cannot change between perspective and parallel projection");
    }
    const double azimuth = *settings_.camera.azimuth;
    settings_.camera = camera;
    settings_.camera.azimuth = camera.azimuth.value_or(azimuth);
    still_ = frameBesideLegend(vertices_, settings_, legend_);
    turned_ = 0;
    useFraming();
}

void Pipeline::turn(double degrees)
{
    if (degrees != turned_)
    {
        turned_ = degrees;
        useFraming();
    }
}

void Pipeline::follow(const Snapshot& snapshot)
{
    if (snapshot.pose.rotation != pose_.rotation || snapshot.pose.offset != pose_.offset)
    {
        pose_ = snapshot.pose;
        origin_ = snapshot.origin;
        moved_ = true;
        useFraming();
    }
}

void Pipeline::useFraming()
{
    framing_ = turned_ != 0 ? revolved(still_, settings_.up, turned_) : still_;
    if (moved_)
    {
        framing_ = posed(framing_, pose_, origin_);
    }
    context_->makeCurrent();
    painter_.lookFrom(framing_);
    projector_ = SphereProjector(framing_, settings_.size);
    stale_ = true;
}

const std::vector<PixelRectangle>& Pipeline::draw(const Snapshot& snapshot)
{
    context_->makeCurrent();
    follow(snapshot);
    renewMarks();
    const SphereLedger::Changes& changes = ledger_.update(snapshot, framing_, colours_);
    const auto polygonParts = painter_.setPolygons(snapshot.polygons);
    const bool startAgain = stale_ || changes.everything;
    if (startAgain && ledger_.resting().size() >= kSortFrom)
    {
        ledger_.sortFrontToBack(framing_);
    }
    stale_ = false;
    renewSurroundings(changes);
    dirty_.clear();
    if (layer_)
    {
        updateLayer(changes, polygonParts, startAgain);
        drawOverLayer();
    }
    else
    {
        drawEverything();
    }
    const std::vector<PixelRectangle>& parts = dirty_.joined();
    framebuffer_.resolve(parts);
    gl_.finish();
    return parts;
}

void Pipeline::renewSurroundings(const SphereLedger::Changes& changes)
{
    Surroundings* surroundings = painter_.surroundings();
    const auto resting = ledger_.resting();
    if (surroundings && (changes.everything || changes.firstArrival == 0))
    {
        surroundings->start(resting);
        return;
    }
    for (std::size_t i = changes.firstArrival; surroundings && i < resting.size(); ++i)
    {
        surroundings->add(resting[i]);
    }
}

void Pipeline::drawEverything()
{
    framebuffer_.bind();
    painter_.clear();
    painter_.paintGround();
    painter_.paintSpheres(ledger_.resting());
    painter_.paintSpheres(ledger_.running());
    painter_.paintShell();
    painter_.paintLegend();
    dirty_.addAll();
}

void Pipeline::updateLayer(const SphereLedger::Changes& changes,
                           std::span<const PixelRectangle> polygonParts, bool startAgain)
{
    if (startAgain)
    {
        layer_->rebuild(painter_, projector_, ledger_.resting());
        dirty_.addAll();
        return;
    }
    covered_.clear();
    covered_.add(polygonParts);
    for (const std::size_t index : changes.recoloured)
    {
        covered_.add(layer_->whereSeen(index));
    }
    if (const Surroundings* surroundings = painter_.surroundings())
    {
        // What comes to rest takes light from what lies there.
        const auto resting = ledger_.resting();
        layer_->eachSeen(
            [&](std::size_t index, const PixelRectangle& pixels)
            {
                const auto arrivals = resting.subspan(changes.firstArrival);
                if (std::any_of(arrivals.begin(), arrivals.end(),
                                [&](const SphereInstance& arrival)
                                { return surroundings->reaches(arrival, resting[index]); }))
                {
                    covered_.add(pixels);
                }
            });
    }
    dirty_.add(running_);
    if (!covered_.empty())
    {
        layer_->repaint(painter_, ledger_.resting().first(changes.firstArrival), covered_.joined(),
                        framebuffer_, dirty_);
    }
    if (changes.firstArrival < ledger_.resting().size())
    {
        layer_->add(painter_, projector_, ledger_.resting(), changes.firstArrival, dirty_);
    }
}

void Pipeline::drawOverLayer()
{
    framebuffer_.restore(layer_->framebuffer(), dirty_.joined());
    running_.clear();
    spheres_.clear();
    parts_.clear();
    for (const SphereInstance& sphere : ledger_.running())
    {
        const ProjectedSphere seen = projector_.project(sphere);
        if (!layer_->hides(seen))
        {
            running_.push_back(seen.pixels);
            parts_.push_back({seen.pixels, seen.furthestDepth});
            spheres_.push_back(sphere);
        }
    }
    framebuffer_.bind();
    painter_.addSpheres(spheres_, parts_);
    dirty_.add(running_);
}

void Pipeline::renewMarks()
{
    if (!layer_ || !painter_.outOfMarks())
    {
        return;
    }
    layer_->framebuffer().bind();
    painter_.clearMarks();
    framebuffer_.bind();
    painter_.clearMarks();
    painter_.startMarks();
}

void Pipeline::readColour(Image& image, std::span<const PixelRectangle> parts)
{
    context_->makeCurrent();
    framebuffer_.readColour(image, parts, settings_.style.palette.background[3] < 255);
}

void Pipeline::readColour(Image& image)
{
    const PixelRectangle whole = framebuffer_.whole();
    readColour(image, {&whole, 1});
}

void Pipeline::drawSurfaces(const Snapshot& snapshot, const PictureSize& size, Surfaces& surfaces)
{
    context_->makeCurrent();
    follow(snapshot);
    const auto found = std::find_if(surfacePasses_.begin(), surfacePasses_.end(),
                                    [&](const std::unique_ptr<SurfacePass>& pass) {
                                        return pass->size().width == size.width &&
                                               pass->size().height == size.height;
                                    });
    SurfacePass& pass = found != surfacePasses_.end()
                            ? **found
                            : *surfacePasses_.emplace_back(std::make_unique<SurfacePass>(
                                  gl_, shapesOnly(painter_.variant()), size));
    pass.draw(placeSpheres(snapshot, framing_), painter_.uniforms(), surfaces);
}

std::vector<double> Pipeline::readDepth()
{
    context_->makeCurrent();
    std::vector<std::uint32_t> bottomUp;
    framebuffer_.readDepth(framebuffer_.whole(), bottomUp);
    std::vector<double> depth;
    depth.reserve(bottomUp.size());
    for (auto row = bottomUp.end(); row != bottomUp.begin();)
    {
        row -= settings_.size.width;
        std::transform(row, row + settings_.size.width, std::back_inserter(depth),
                       [](std::uint32_t bits) { return (bits >> 8) / double{0xffffff}; });
    }
    return depth;
}

} // namespace frostfill
