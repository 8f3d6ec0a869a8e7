// SPDX-License-Identifier: MIT
#include "study/error/tessellated_spheres.hpp"

#include "mesh/geodesic_sphere.hpp"
#include "render/picture/shrink.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include <array>
#include <vector>

namespace frostfill
{
namespace
{

constexpr const char* kVertexShader = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 sphere;
uniform mat4 toClip;
out vec3 normal;
void main()
{
    normal = position;
    gl_Position = toClip * vec4(sphere.xyz + sphere.w * position, 1.0);
})";
constexpr const char* kFragmentShader = R"(
in vec3 normal;
out vec4 colour;
void main()
{
    float light = 0.3 + 0.7 * max(dot(normalize(normal), vec3(0.4, 0.7, 0.6)), 0.0);
    colour = vec4(vec3(0.0, 0.45, 0.7) * light, 1.0);
})";

} // namespace

TessellatedSpheres::TessellatedSpheres(PictureSize size, int samples, int supersample,
                                       int subdivisions, float scale)
    : context_(openContext(Backend::automatic)), gl_(loadGlFunctions(*context_)),
      framebuffer_(gl_, size.width * supersample, size.height * supersample, samples),
      supersample_(supersample), scale_(scale), program_(gl_, "", kVertexShader, kFragmentShader),
      toClip_(glm::perspective(0.61F,
                               static_cast<float>(size.width) / static_cast<float>(size.height),
                               1.0F, 6.0F) *
              glm::lookAt(glm::vec3(1.4F, 1.0F, 2.4F), glm::vec3(0), glm::vec3(0, 1, 0)))
{
    const TriangleMesh sphere = geodesicSphere(std::size_t{1} << subdivisions);
    std::vector<Eigen::Vector3f> corners;
    for (const std::array<std::uint32_t, 3>& triangle : sphere.triangles)
    {
        for (const std::uint32_t vertex : triangle)
        {
            corners.push_back(sphere.vertices[vertex].cast<float>());
        }
    }
    vertices_ = static_cast<GLsizei>(corners.size());
    gl_.viewport(0, 0, size.width * supersample, size.height * supersample);
    gl_.genVertexArrays(1, &array_);
    gl_.genBuffers(2, buffers_.data());
    gl_.bindVertexArray(array_);
    gl_.bindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
    gl_.bufferData(GL_ARRAY_BUFFER,
                   static_cast<GLsizeiptr>(corners.size() * sizeof corners.front()), corners.data(),
                   GL_STATIC_DRAW);
    gl_.vertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 12, nullptr);
    gl_.enableVertexAttribArray(0);
    gl_.bindBuffer(GL_ARRAY_BUFFER, buffers_[1]);
    gl_.vertexAttribPointer(1, 4, GL_FLOAT, GL_FALSE, 16, nullptr);
    gl_.vertexAttribDivisor(1, 1);
    gl_.enableVertexAttribArray(1);
}

TessellatedSpheres::~TessellatedSpheres()
{
    context_->makeCurrent();
    gl_.deleteBuffers(2, buffers_.data());
    gl_.deleteVertexArrays(1, &array_);
}

void TessellatedSpheres::draw(const Snapshot& snapshot, Image& image)
{
    context_->makeCurrent();
    instances_.clear();
    for (std::size_t i = 0; i < snapshot.centres.size(); ++i)
    {
        const Eigen::Vector3f& c = snapshot.centres[i];
        instances_.insert(instances_.end(), {scale_ * c.x(), scale_ * c.y(), scale_ * c.z(),
                                             scale_ * snapshot.radii[i]});
    }
    framebuffer_.bind();
    gl_.clearColor(1, 1, 1, 1);
    gl_.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    program_.use();
    program_.set("toClip", toClip_);
    gl_.enable(GL_DEPTH_TEST);
    gl_.enable(GL_CULL_FACE);
    gl_.cullFace(GL_BACK);
    gl_.bindVertexArray(array_);
    gl_.bindBuffer(GL_ARRAY_BUFFER, buffers_[1]);
    gl_.bufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(instances_.size() * sizeof(float)),
                   instances_.data(), GL_STREAM_DRAW);
    gl_.drawArraysInstanced(GL_TRIANGLES, 0, vertices_,
                            static_cast<GLsizei>(snapshot.centres.size()));
    const PixelRectangle whole = framebuffer_.whole();
    framebuffer_.resolve({&whole, 1});
    Image& target = supersample_ > 1 ? drawn_ : image;
    framebuffer_.readColour(target, {&whole, 1}, false);
    if (supersample_ > 1)
    {
        image = shrunk(drawn_, supersample_);
    }
}

} // namespace frostfill
