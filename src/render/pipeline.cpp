// SPDX-License-Identifier: MIT
#include "pipeline.hpp"

#include <frostfill/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace frostfill
{
namespace
{

/// Share of the background in the furthest spheres.
constexpr float kHaze = 0.26F;

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

ShaderVariant variantOf(const RenderSettings& settings)
{
    return {settings.camera.orthographic, settings.style.cutaway.kind != Cutaway::Kind::none,
            settings.style.look == Look::paper};
}

const RenderSettings& checked(const RenderSettings& settings)
{
    if (settings.samples < 1 || settings.samples > kMostSamples)
    {
        throw Error(ErrorCode::usage,
                    fmt::format("samples a pixel must be between 1 and {}, not {}", kMostSamples,
                                settings.samples));
    }
    if (settings.size.width < 1 || settings.size.height < 1)
    {
        throw Error(ErrorCode::usage, fmt::format("a picture of {}x{} pixels cannot be drawn",
                                                  settings.size.width, settings.size.height));
    }
    return settings;
}

/// Strokes grow with the picture, so that a large one looks like a small one, only sharper.
MeshStrokes strokesFor(const PictureSize& size)
{
    const auto edge = static_cast<float>(std::min(size.width, size.height));
    return {std::max(0.75F, edge / 720), std::max(6.0F, edge / 72)};
}

/// From pixels, y downwards, to clip space. Swatches lie at the very front of the depth range.
glm::mat4 pixelProjection(const PictureSize& size)
{
    glm::mat4 projection(0);
    projection[0][0] = 2.0F / static_cast<float>(size.width);
    projection[1][1] = 2.0F / static_cast<float>(size.height);
    projection[2][2] = -1e-5F;
    projection[3] = {-1, -1, -0.99F, 1};
    return projection;
}

/// A square a swatch, as two triangles that face the viewer, y upwards.
TriangleMesh squares(const std::vector<Legend::Swatch>& swatches, double height)
{
    TriangleMesh mesh;
    for (const Legend::Swatch& swatch : swatches)
    {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const auto& [x, y] : {std::array{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
        {
            mesh.vertices.emplace_back(swatch.x + x * swatch.halfSize,
                                       height - swatch.y + y * swatch.halfSize, 0);
        }
        mesh.triangles.push_back({first, first + 1, first + 2});
        mesh.triangles.push_back({first, first + 2, first + 3});
    }
    return mesh;
}

std::vector<glm::vec3> positionsOf(const TriangleMesh& mesh)
{
    std::vector<glm::vec3> positions;
    for (const Eigen::Vector3d& vertex : mesh.vertices)
    {
        positions.emplace_back(vertex.x(), vertex.y(), vertex.z());
    }
    return positions;
}

} // namespace

Pipeline::Pipeline(const TriangleMesh& mesh, const RenderSettings& settings)
    : settings_(checked(settings)), colours_(settings, mesh.vertices),
      legend_(settings, mesh.triangles.size(), colours_),
      still_(frameBesideLegend(mesh.vertices, settings, legend_)), framing_(still_),
      context_(openContext(settings.backend)), gl_(loadGlFunctions(*context_)),
      description_(describe(*context_, gl_)),
      framebuffer_(gl_, settings.size.width, settings.size.height, settings.samples),
      spherePass_(gl_, variantOf(settings), samplePositions(), settings.style,
                  strokesFor(settings.size).lineWidth),
      meshPass_(gl_, variantOf(settings), settings.style.palette, strokesFor(settings.size)),
      spheres_(gl_)
{
    if (settings.style.cutaway.kind != Cutaway::Kind::none)
    {
        cutPlanes_ = cutPlanes(settings.style.cutaway, still_, settings.up);
    }
    if (settings.style.shell)
    {
        uploadMesh(mesh);
    }
    if (legend_.visible())
    {
        uploadSwatches();
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

void Pipeline::uploadMesh(const TriangleMesh& mesh)
{
    std::vector<glm::vec3> positions;
    for (const Eigen::Vector3d& vertex : mesh.vertices)
    {
        positions.emplace_back(framing_.toUnit(vertex));
    }
    shaded_ = shadeMesh(mesh, positions);
    shell_ = std::make_unique<MeshBuffer>(
        gl_, shaded_, edgeStrengths(shaded_, glm::vec3(framing_.eye), framing_.orthographic));
}

void Pipeline::uploadSwatches()
{
    const ShaderVariant flat{true, false, settings_.style.look == Look::paper};
    if (!framing_.orthographic || cutPlanes_)
    {
        flatSpherePass_.emplace(gl_, flat, samplePositions(), settings_.style,
                                strokesFor(settings_.size).lineWidth);
    }
    if (cutPlanes_)
    {
        wholeMeshPass_.emplace(gl_, flat, settings_.style.palette, strokesFor(settings_.size));
    }
    const double height = settings_.size.height;
    const TriangleMesh mesh = squares(legend_.polygons(), height);
    const ShadedMesh shaded = shadeMesh(mesh, positionsOf(mesh));
    auto strengths = edgeStrengths(shaded, {0, 0, 1}, true);
    strengths[0][1] = strengths[1][2] = strengths[2][1] = strengths[3][2] = 0; // the diagonals
    swatches_.reset(new Swatches{SphereBuffer(gl_), MeshBuffer(gl_, shaded, strengths)});

    std::vector<SphereInstance> spheres;
    for (const Legend::Swatch& swatch : legend_.spheres())
    {
        spheres.push_back({static_cast<float>(swatch.x), static_cast<float>(height - swatch.y), 0,
                           static_cast<float>(swatch.halfSize),
                           static_cast<std::uint32_t>(swatch.state),
                           colours_.ofSwatch(static_cast<SphereState>(swatch.state))});
    }
    swatches_->spheres.update(spheres);
    std::vector<PolygonState> states;
    for (const Legend::Swatch& swatch : legend_.polygons())
    {
        states.insert(states.end(), 2, static_cast<PolygonState>(swatch.state));
    }
    swatches_->polygons.update(states);
}

void Pipeline::drawSwatches() const
{
    SphereUniforms uniforms;
    uniforms.projection = pixelProjection(settings_.size);
    uniforms.depthSlope = -0.5F * uniforms.projection[2][2];
    (flatSpherePass_ ? *flatSpherePass_ : spherePass_).draw(swatches_->spheres, uniforms);
    (wholeMeshPass_ ? *wholeMeshPass_ : meshPass_)
        .draw(swatches_->polygons, uniforms.view, uniforms.projection);
}

void Pipeline::turn(double degrees)
{
    if (degrees == turned_)
    {
        return;
    }
    turned_ = degrees;
    framing_ = revolved(still_, settings_.up, degrees);
    if (shell_)
    {
        context_->makeCurrent();
        shell_->setEdges(
            edgeStrengths(shaded_, glm::vec3(framing_.eye), framing_.orthographic));
    }
}

SphereUniforms Pipeline::uniforms() const
{
    SphereUniforms uniforms;
    uniforms.view = framing_.view;
    uniforms.projection = framing_.projection;
    uniforms.depthAtInfinity = static_cast<float>(framing_.depthAtInfinity);
    uniforms.depthSlope = static_cast<float>(framing_.depthSlope);
    uniforms.pixelScale = 0.5F * static_cast<float>(framing_.projection[1][1]) *
                          static_cast<float>(settings_.size.height);
    uniforms.heightPlane = framing_.heightPlane;
    uniforms.distancePlane = framing_.distancePlane;
    uniforms.haze = settings_.style.look == Look::paper ? 0 : kHaze;
    if (cutPlanes_)
    {
        uniforms.cutPlanes = toEyeSpace(*cutPlanes_, framing_);
    }
    return uniforms;
}

void Pipeline::draw(const Snapshot& snapshot)
{
    context_->makeCurrent();
    placeSpheres(snapshot, framing_, colours_, instances_);
    spheres_.update(instances_);

    const glm::vec4 background = toVector(settings_.style.palette.background);
    framebuffer_.bind();
    // Colours are premultiplied by alpha until they are read.
    gl_.clearColor(background.r * background.a, background.g * background.a,
                   background.b * background.a, background.a);
    gl_.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

    const SphereUniforms uniforms = this->uniforms();
    spherePass_.draw(spheres_, uniforms);
    if (shell_)
    {
        shell_->update(snapshot.polygons);
        meshPass_.setCutPlanes(uniforms.cutPlanes);
        meshPass_.draw(*shell_, uniforms.view, uniforms.projection);
    }
    if (swatches_)
    {
        drawSwatches();
    }
    framebuffer_.resolve();
    gl_.finish();
}

void Pipeline::readColour(Image& image)
{
    context_->makeCurrent();
    framebuffer_.readColour(image, settings_.style.palette.background[3] < 255);
}

void Pipeline::drawSurfaces(const Snapshot& snapshot, const PictureSize& size, Surfaces& surfaces)
{
    context_->makeCurrent();
    const auto found = std::find_if(surfacePasses_.begin(), surfacePasses_.end(),
                                    [&](const std::unique_ptr<SurfacePass>& pass)
                                    {
                                        return pass->size().width == size.width &&
                                               pass->size().height == size.height;
                                    });
    SurfacePass& pass =
        found != surfacePasses_.end()
            ? **found
            : *surfacePasses_.emplace_back(
                  std::make_unique<SurfacePass>(gl_, variantOf(settings_), size));
    std::vector<SphereInstance> spheres;
    placeSpheres(snapshot, framing_, colours_, spheres);
    pass.draw(spheres, uniforms(), surfaces);
}

std::vector<float> Pipeline::readDepth()
{
    context_->makeCurrent();
    return framebuffer_.readDepth();
}

} // namespace frostfill
