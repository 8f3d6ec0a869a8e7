// SPDX-License-Identifier: MIT
#include "render/layer/scene_painter.hpp"

#include "render/picture/painter_settings.hpp"
#include "render/picture/projected_sphere.hpp"
#include "render/picture/swatch_mesh.hpp"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

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
                           const RenderSettings& settings, const Legend& legend,
                           const SphereColours& colours, const Framing& framing,
                           std::span<const glm::vec2> samplePositions)
    : gl_(gl), legend_(legend), colours_(colours), settings_(settings),
      variant_(variantOf(settings, mesh)),
      spherePass_(gl, uncut(variant_), samplePositions, settings_.style,
                  strokesFor(settings).lineWidth),
      meshPass_(gl, variant_, shellPalette(settings_.style),
                strokesFor(settings, mesh.triangles.size())),
      spheres_(gl, variant_.occlusion), regions_(settings.size.width, settings.size.height)
{
    if (variant_.cutaway)
    {
        cutSpherePass_.emplace(gl, variant_, samplePositions, settings_.style,
                               strokesFor(settings).lineWidth);
    }
    studio_ = studioOf(mesh, inUnitSpace(mesh, framing), settings, framing);
    if (variant_.occlusion)
    {
        sphereOcclusion_.emplace(lampOf(studio_), cutPlanesOf(settings_, framing));
    }
    if (studio_ && studio_->ground)
    {
        ground_ = std::make_unique<GroundPass>(gl_, *studio_->ground);
    }
    setView(framing);
    setShell(shell);
    if (legend_.visible())
    {
        const ShaderVariant flat = variantOfSwatches(variant_);
        if (!variant_.orthographic || variant_.occlusion)
        {
            flatSpherePass_.emplace(gl_, flat, samplePositions, settings_.style,
                                    strokesFor(settings).lineWidth);
        }
        if (!variant_.orthographic || variant_.cutaway)
        {
            flatMeshPass_.emplace(gl_, flat, shellPalette(settings_.style), strokesFor(settings));
        }
        uploadSwatches();
    }
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
    shell_ = std::make_unique<MeshBuffer>(
        gl_, shaded_, edgeStrengths(shaded_, glm::vec3(framing_.eye), framing_.orthographic));
    tiles_.emplace(shaded_, framing_, settings_.size);
}

void ScenePainter::uploadSwatches()
{
    const SwatchShapes shapes = swatchShapes(legend_, colours_, settings_.size.height);
    swatches_.reset(
        new Swatches{SphereBuffer(gl_), MeshBuffer(gl_, shapes.polygons, shapes.strengths)});
    swatches_->spheres.update(shapes.spheres);
    swatches_->polygons.update(shapes.states);
    flatUniforms_.projection = pixelProjection(settings_.size);
    flatUniforms_.supersample = uniforms_.supersample;
    flatUniforms_.depthSlope = -0.5F * flatUniforms_.projection[2][2];
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
        tiles_.emplace(shaded_, framing_, settings_.size);
    }
}

std::span<const PixelRectangle> ScenePainter::setPolygons(std::span<const PolygonState> states)
{
    changed_.clear();
    if (shell_)
    {
        for (const std::uint32_t triangle : shell_->update(states))
        {
            changed_.push_back(tiles_->bounds(triangle));
        }
    }
    return changed_;
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
    if (shell_)
    {
        meshPass_.draw(*shell_, uniforms_.view, uniforms_.projection);
    }
}

void ScenePainter::paintShell(std::span<const TriangleTiles::Part> parts)
{
    if (shell_)
    {
        tiles_->find(parts);
        shell_->choose(tiles_->backs(), tiles_->fronts());
        meshPass_.draw(*shell_, uniforms_.view, uniforms_.projection, MeshPass::Triangles::chosen);
    }
}

void ScenePainter::paintShellPerRegion(std::span<const TriangleTiles::Part> parts)
{
    if (!shell_)
    {
        return;
    }
    // A triangle reaches far beyond a sphere that it covers a piece of, and with several samples
    // Mesa shades it there too before it finds no mark. The regions are disjoint, so that no pixel
    // gets the surface twice.
    regions_.clear();
    for (const TriangleTiles::Part& part : parts)
    {
        regions_.add(grown(part.pixels, kScissorMargin));
    }
    for (const PixelRectangle& region : regions_.joined())
    {
        regionParts_.clear();
        std::copy_if(parts.begin(), parts.end(), std::back_inserter(regionParts_),
                     [&](const TriangleTiles::Part& part) { return part.pixels.overlaps(region); });
        confine(region);
        paintShell(regionParts_);
    }
    endConfinement();
}

void ScenePainter::paintLegend()
{
    if (swatches_)
    {
        (flatSpherePass_ ? *flatSpherePass_ : spherePass_).draw(swatches_->spheres, flatUniforms_);
        paintSwatchPolygons();
    }
}

void ScenePainter::paintSwatchPolygons()
{
    (flatMeshPass_ ? *flatMeshPass_ : meshPass_)
        .draw(swatches_->polygons, flatUniforms_.view, flatUniforms_.projection);
}

void ScenePainter::addSpheres(std::span<const SphereInstance> spheres,
                              std::span<const TriangleTiles::Part> parts)
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
    paintShellPerRegion(parts);
    const PixelRectangle legend = {0,
                                   settings_.size.height - static_cast<int>(legend_.height()) - 1,
                                   static_cast<int>(legend_.width()) + 1, settings_.size.height};
    if (swatches_ &&
        std::any_of(parts.begin(), parts.end(),
                    [&](const TriangleTiles::Part& part) { return part.pixels.overlaps(legend); }))
    {
        paintSwatchPolygons();
    }
    gl_.disable(GL_STENCIL_TEST);
}

} // namespace frostfill
