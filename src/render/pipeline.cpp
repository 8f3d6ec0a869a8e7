// SPDX-License-Identifier: MIT
#include "render/pipeline.hpp"

#include <frostfill/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace frostfill
{
namespace
{

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

} // namespace

Pipeline::Pipeline(const TriangleMesh& mesh, const RenderSettings& wanted)
    : PictureBackend(mesh, wanted), context_(openContext(wanted.backend)),
      gl_(loadGlFunctions(*context_)), description_(describe(*context_, gl_)),
      framebuffer_(gl_, wanted.size.width, wanted.size.height, wanted.samples),
      painter_(gl_, viewpoint(), shell(), mesh.triangles.size(), sphereOcclusion(),
               samplePositions()),
      projector_(framing(), wanted.size)
{
    if (wanted.staticLayer)
    {
        layer_.emplace(gl_, wanted.size, wanted.samples, painter_.paintsOccluders());
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

void Pipeline::useFraming()
{
    context_->makeCurrent();
    painter_.useFraming();
    projector_ = SphereProjector(framing(), viewpoint().settings().size);
}

void Pipeline::useShell()
{
    context_->makeCurrent();
    painter_.useShell();
}

const std::vector<PixelRectangle>& Pipeline::draw(const Snapshot& snapshot, Image& /*image*/)
{
    context_->makeCurrent();
    const Changes changes = take(snapshot, false);
    const PixelRectangle polygons = painter_.setPolygons(changes.triangles, shell().states());
    dirty_ = {};
    if (layer_)
    {
        updateLayer(changes, polygons);
        drawOverLayer();
    }
    else
    {
        drawEverything();
    }
    framebuffer_.resolve(dirty_);
    gl_.finish();
    renewed_.assign(dirty_.empty() ? 0 : 1, dirty_);
    return renewed_;
}

void Pipeline::drawEverything()
{
    framebuffer_.bind();
    painter_.clear();
    painter_.paintGround();
    painter_.paintSpheres(spheres().resting());
    painter_.paintSpheres(spheres().running());
    painter_.paintShell();
    dirty_ = framebuffer_.whole();
}

void Pipeline::addDirty(const PixelRectangle& part)
{
    dirty_ = around(dirty_, common(part, framebuffer_.whole()));
}

void Pipeline::updateLayer(const Changes& changes, const PixelRectangle& polygons)
{
    const std::span<const SphereInstance> resting = spheres().resting();
    const std::size_t firstArrival = changes.spheres.firstArrival;
    if (changes.startAgain)
    {
        layer_->rebuild(painter_, projector_, resting);
        dirty_ = framebuffer_.whole();
        return;
    }
    PixelRectangle covered = polygons; // part of the layer that is drawn anew
    for (const std::size_t index : changes.spheres.recoloured)
    {
        covered = around(covered, layer_->visiblePart(index));
    }
    if (sphereOcclusion() != nullptr)
    {
        // What comes to rest takes light from what lies there.
        const auto isSeen = [&](std::uint32_t index)
        { return !layer_->visiblePart(index).empty(); };
        for (const std::uint32_t index : sphereOcclusion()->refresh(isSeen))
        {
            covered = around(covered, layer_->visiblePart(index));
        }
    }
    addDirty(running_);
    if (!covered.empty())
    {
        addDirty(layer_->repaint(painter_, resting.first(firstArrival), covered, framebuffer_));
    }
    if (firstArrival < resting.size())
    {
        addDirty(layer_->add(painter_, projector_, resting, firstArrival));
    }
}

void Pipeline::drawOverLayer()
{
    framebuffer_.restore(layer_->framebuffer(), dirty_);
    running_ = {};
    spheres_.clear();
    parts_.clear();
    for (const SphereInstance& sphere : spheres().running())
    {
        const ProjectedSphere seen = projector_.project(sphere);
        if (!layer_->hides(seen))
        {
            running_ = around(running_, seen.pixels);
            parts_.push_back({seen.pixels, seen.furthestDepth});
            spheres_.push_back(sphere);
        }
    }
    framebuffer_.bind();
    painter_.addSpheres(spheres_, parts_);
    addDirty(running_);
}

void Pipeline::readBack(Image& image, std::span<const PixelRectangle> parts)
{
    context_->makeCurrent();
    const bool withAlpha = viewpoint().settings().style.palette.background[3] < 255;
    framebuffer_.readColour(image, parts, withAlpha);
}

void Pipeline::drawSurfaces(const Snapshot& snapshot, const PictureSize& size, Surfaces& surfaces)
{
    context_->makeCurrent();
    follow(snapshot);
    if (!surfacePass_ || surfacePass_->size().width != size.width ||
        surfacePass_->size().height != size.height)
    {
        surfacePass_ = std::make_unique<SurfacePass>(gl_, shapesOnly(viewpoint().variant()), size);
    }
    surfacePass_->draw(placeSpheres(snapshot, framing()), viewpoint().uniforms(), surfaces);
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
        row -= viewpoint().settings().size.width;
        std::transform(row, row + viewpoint().settings().size.width, std::back_inserter(depth),
                       [](std::uint32_t bits) { return (bits >> 8) / double{0xffffff}; });
    }
    return depth;
}

} // namespace frostfill
