// SPDX-License-Identifier: MIT
#include "render/passes/contact_pass.hpp"

#include "render/context/embedded.hpp"

#include <cstddef>
#include <utility>

namespace frostfill
{

ContactPass::ContactPass(const GlFunctions& gl, std::unique_ptr<ContactShadows> shadows)
    : gl_(gl), shadows_(std::move(shadows)),
      program_(gl, "", embedded::shader_contact_vert(), embedded::shader_contact_frag())
{
    gl.genVertexArrays(1, &array_);
    gl.genBuffers(1, &buffer_);
    gl.bindVertexArray(array_);
    gl.bindBuffer(GL_ARRAY_BUFFER, buffer_);
    gl.vertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Corner), nullptr);
    gl.vertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof(Corner),
                           inBuffer(offsetof(Corner, corner)));
    gl.vertexAttribPointer(2, 4, GL_FLOAT, GL_FALSE, sizeof(Corner),
                           inBuffer(offsetof(Corner, numbers)));
    for (GLuint attribute = 0; attribute < 3; ++attribute)
    {
        gl.enableVertexAttribArray(attribute);
    }
}

ContactPass::~ContactPass()
{
    gl_.deleteBuffers(1, &buffer_);
    gl_.deleteVertexArrays(1, &array_);
}

void ContactPass::draw(const PixelRectangle& part, const glm::mat4& view,
                       const glm::mat4& projection)
{
    corners_.clear();
    for (const auto& [shadow, pixels] : shadows_->seen())
    {
        if (!pixels.overlaps(part))
        {
            continue;
        }
        const glm::vec3 along = shadow.along();
        for (const auto& [x, y] :
             {std::array{-1.0F, -1.0F}, std::array{1.0F, -1.0F}, std::array{-1.0F, 1.0F},
              std::array{-1.0F, 1.0F}, std::array{1.0F, -1.0F}, std::array{1.0F, 1.0F}})
        {
            corners_.push_back({shadow.foot + x * shadow.across + y * along,
                                {x, y},
                                {shadow.height, shadow.lamp.x, shadow.lamp.y, shadow.strength}});
        }
    }
    if (corners_.empty())
    {
        return;
    }
    program_.use();
    program_.set("view", view);
    program_.set("projection", projection);
    gl_.disable(GL_DEPTH_TEST);
    gl_.enable(GL_DEPTH_CLAMP);
    gl_.depthMask(GL_FALSE);
    gl_.enable(GL_BLEND);
    gl_.blendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl_.bindVertexArray(array_);
    gl_.bindBuffer(GL_ARRAY_BUFFER, buffer_);
    gl_.bufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners_.size() * sizeof(Corner)),
                   corners_.data(), GL_STREAM_DRAW);
    gl_.drawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners_.size()));
    gl_.disable(GL_DEPTH_CLAMP);
    gl_.depthMask(GL_TRUE);
}

} // namespace frostfill
