// SPDX-License-Identifier: MIT
#include "render/layer/scene_painter.hpp"

#include "render/picture/painter_settings.hpp"
#include "render/picture/projected_sphere.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace frostfill
{

namespace
{

/// A sphere that is smaller by this, and by as far as the outermost sample is from a pixel's
/// centre, covers a centre only where the full one covers all samples of the pixel, and lies in
/// front of the small one there. For rounding. [pixel]
constexpr float kOccluderSlack = 0.1F;

ShaderVariant uncut(ShaderVariant variant)
{
    variant.cutaway = false;
    return variant;
}

} // namespace

ScenePainter::ScenePainter(const GlFunctions& gl, const TriangleMesh& mesh, const DrawnShell& shell,
                           const RenderSettings& settings, const Framing& framing,
                           std::span<const glm::vec2> samplePositions)
    : gl_(gl), settings_(settings), variant_(variantOf(settings, mesh)),
      spherePass_(gl, uncut(variant_), samplePositions, settings_.style,
                  strokesFor(settings).lineWidth),
      meshPass_(gl, variant_, shellPalette(settings_.style),
                strokesFor(settings, mesh.triangles.size())),
      spheres_(gl, variant_.occlusion)
{
    if (variant_.cutaway)
    {
        cutSpherePass_.emplace(gl, variant_, samplePositions, settings_.style,
                               strokesFor(settings).lineWidth);
    }
    studio_ = studioOf(mesh, settings, framing);
    if (variant_.occlusion)
    {
        sphereOcclusion_.emplace(lampOf(studio_), cutPlanesOf(settings_, framing));
    }
    if (studio_ && studio_->ground)
    {
        ground_ = std::make_unique<GroundPass>(gl_, *studio_->ground);
    }
    framing_ = framing;
    setShell(shell);
    lookFrom(framing);
    for (const glm::vec2& sample : samplePositions)
    {
        occluderShrink_ = std::max(occluderShrink_, glm::length(sample) + kOccluderSlack);
    }
    if (samplePositions.size() > 1 && paintsOccluders())
    {
        plainSpherePass_.emplace(gl_, shapesOnly(variant_), std::span<const glm::vec2>(),
                                 settings_.style, strokesFor(settings).lineWidth);
    }
}

void ScenePainter::setShell(const DrawnShell& shell)
{
    if (!settings_.style.shell)
    {
        return;
    }
    shaded_ = shell.shaded(framing_, variant_.fadingLines);
    shell_ = std::make_unique<MeshBuffer>(gl_, shaded_);
}

void ScenePainter::findBounds()
{
    const SphereProjector projector(framing_, settings_.size);
    bounds_.clear();
    for (std::size_t t = 0; t < shaded_.triangles.size(); ++t)
    {
        const auto [a, b, c] = shaded_.corners(t);
        const glm::vec3 middle = (a + b + c) / 3.0F;
        const float reach = std::max(
            {glm::distance(middle, a), glm::distance(middle, b), glm::distance(middle, c)});
        bounds_.push_back(
            projector.project({middle.x, middle.y, middle.z, 1.0001F * reach + 1e-6F, 0}));
    }
}

void ScenePainter::setView(const Framing& framing)
{
    framing_ = framing;
    uniforms_ = uniformsOf(framing, settings_);
    if (studio_)
    {
        studio_->light(framing, uniforms_);
    }
    if (variant_.cutaway)
    {
        meshPass_.setCutPlanes(uniforms_.cutPlanes);
    }
}

void ScenePainter::lookFrom(const Framing& framing)
{
    setView(framing);
    if (shell_)
    {
        shell_->setEdges(edgeStrengths(shaded_, glm::vec3(framing_.eye), framing_.orthographic));
        findBounds();
    }
}

PixelRectangle ScenePainter::setPolygons(std::span<const std::uint32_t> changed,
                                         std::span<const PolygonState> states)
{
    PixelRectangle part;
    if (shell_)
    {
        shell_->update(changed, states);
        for (const std::uint32_t triangle : changed)
        {
            part = around(part, bounds_[triangle].pixels);
        }
    }
    return part;
}

void ScenePainter::clear()
{
    const glm::vec4 background = toVector(settings_.style.palette.background);
    // Colours are premultiplied by alpha until they are read.
    gl_.clearColor(background.r * background.a, background.g * background.a,
                   background.b * background.a, background.a);
    gl_.clearStencil(0);
    gl_.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

void ScenePainter::paintGround()
{
    if (ground_ && studio_->showsGround(framing_))
    {
        ground_->draw(uniforms_.view, uniforms_.projection);
    }
}

void ScenePainter::resetStencil()
{
    gl_.clearStencil(0);
    gl_.clear(GL_STENCIL_BUFFER_BIT);
}

void ScenePainter::confine(const PixelRectangle& part)
{
    gl_.enable(GL_SCISSOR_TEST);
    gl_.scissor(part.left, part.bottom, part.width(), part.height());
}

void ScenePainter::endConfinement()
{
    gl_.disable(GL_SCISSOR_TEST);
}

void ScenePainter::paintSpheres(std::span<const SphereInstance> spheres)
{
    if (!variant_.cutaway)
    {
        paintSpheres(spheres, spherePass_);
        return;
    }
    whole_.clear();
    cut_.clear();
    for (const SphereInstance& sphere : spheres)
    {
        const CutShare share = cutShareOf(sphere, uniforms_);
        if (share != CutShare::nothing)
        {
            (share == CutShare::whole ? whole_ : cut_).push_back(sphere);
        }
    }
    paintSpheres(whole_, spherePass_);
    paintSpheres(cut_, *cutSpherePass_);
}

void ScenePainter::paintSpheres(std::span<const SphereInstance> spheres, const SpherePass& pass)
{
    if (spheres.empty())
    {
        return;
    }
    spheres_.update(spheres);
    if (sphereOcclusion_)
    {
        lights_.clear();
        for (const SphereInstance& sphere : spheres)
        {
            lights_.push_back(sphereOcclusion_->of(sphere));
        }
        spheres_.light(lights_);
    }
    pass.draw(spheres_, uniforms_);
}

void ScenePainter::paintOccluders(std::span<const SphereInstance> spheres,
                                  const SphereProjector& projector)
{
    shrunk_.clear();
    for (SphereInstance sphere : spheres)
    {
        const float ahead = framing_.orthographic ? 1 : projector.project(sphere).ahead;
        sphere.radius -= occluderShrink_ * ahead / uniforms_.pixelScale;
        if (sphere.radius > 0 && ahead > 0)
        {
            shrunk_.push_back(sphere);
        }
    }
    if (!shrunk_.empty())
    {
        spheres_.update(shrunk_);
        plainSpherePass_->draw(spheres_, uniforms_);
    }
}

void ScenePainter::paintShell()
{
    const PicturePart all{{0, 0, settings_.size.width, settings_.size.height}};
    paintShell({&all, 1});
}

void ScenePainter::paintShell(std::span<const PicturePart> parts)
{
    if (!shell_)
    {
        return;
    }
    chosen_.clear();
    for (std::uint32_t t = 0; t < bounds_.size(); ++t)
    {
        const auto meets = [&bounds = bounds_[t]](const PicturePart& part)
        { return bounds.nearestDepth < part.furthest && bounds.pixels.overlaps(part.pixels); };
        if (std::any_of(parts.begin(), parts.end(), meets))
        {
            chosen_.push_back(t);
        }
    }
    shell_->choose(chosen_);
    meshPass_.draw(*shell_, uniforms_.view, uniforms_.projection);
}

void ScenePainter::addSpheres(std::span<const SphereInstance> spheres,
                              std::span<const PicturePart> parts)
{
    if (spheres.empty())
    {
        return;
    }
    ++stencilValue_;
    gl_.enable(GL_STENCIL_TEST);
    gl_.stencilFunc(GL_ALWAYS, stencilValue_, 0xff);
    gl_.stencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    paintSpheres(spheres);
    // Only what shows a new sphere has lost the surface over it; elsewhere it must not lie twice.
    gl_.stencilFunc(GL_EQUAL, stencilValue_, 0xff);
    gl_.stencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    // A triangle reaches far beyond a sphere that it covers a piece of, and with several samples
    // Mesa shades it there too before it finds no mark.
    PixelRectangle region;
    for (const PicturePart& part : parts)
    {
        region = around(region, grown(part.pixels, kScissorMargin));
    }
    confine(region);
    paintShell(parts);
    endConfinement();
    gl_.disable(GL_STENCIL_TEST);
}

} // namespace frostfill
