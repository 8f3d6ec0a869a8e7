// SPDX-License-Identifier: MIT
#include "render/passes/ground_pass.hpp"

#include "render/context/embedded.hpp"

namespace frostfill
{

GroundPass::GroundPass(const GlFunctions& gl, const GroundShadow& ground)
    : gl_(gl), program_(gl, "", embedded::shader_ground_vert(), embedded::shader_ground_frag()),
      corners_(static_cast<GLsizei>(ground.corners.size()))
{
    gl.genVertexArrays(1, &array_);
    gl.genBuffers(2, buffers_.data());
    gl.bindVertexArray(array_);
    gl.bindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
    gl.bufferData(GL_ARRAY_BUFFER,
                  static_cast<GLsizeiptr>(ground.places.size() * sizeof(glm::vec4)),
                  ground.places.data(), GL_STATIC_DRAW);
    gl.vertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(glm::vec4), nullptr);
    gl.enableVertexAttribArray(0);
    gl.bindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[1]);
    gl.bufferData(GL_ELEMENT_ARRAY_BUFFER,
                  static_cast<GLsizeiptr>(ground.corners.size() * sizeof(std::uint32_t)),
                  ground.corners.data(), GL_STATIC_DRAW);
}

GroundPass::~GroundPass()
{
    gl_.deleteBuffers(2, buffers_.data());
    gl_.deleteVertexArrays(1, &array_);
}

void GroundPass::draw(const glm::mat4& view, const glm::mat4& projection) const
{
    program_.use();
    program_.set("view", view);
    program_.set("projection", projection);
    gl_.disable(GL_DEPTH_TEST);
    gl_.enable(GL_DEPTH_CLAMP); // it reaches further than the object, for which the far plane is
    gl_.depthMask(GL_FALSE);
    gl_.enable(GL_BLEND);
    gl_.blendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl_.bindVertexArray(array_);
    gl_.drawElements(GL_TRIANGLES, corners_, GL_UNSIGNED_INT, nullptr);
    gl_.disable(GL_DEPTH_CLAMP);
    gl_.depthMask(GL_TRUE);
}

} // namespace frostfill
