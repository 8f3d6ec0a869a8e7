// SPDX-License-Identifier: MIT
#pragma once

#include "render/context/gl.hpp"
#include "render/context/shader.hpp"
#include "render/picture/contact_shadows.hpp"

#include <glm/mat4x4.hpp>

#include <array>
#include <memory>
#include <vector>

namespace frostfill
{

/// The program that draws the shadows of spheres on the walls that they touch. Owns what it
/// creates.
class ContactPass
{
public:
    ContactPass(const GlFunctions& gl, std::unique_ptr<ContactShadows> shadows);
    ~ContactPass();
    ContactPass(const ContactPass&) = delete;
    ContactPass& operator=(const ContactPass&) = delete;

    [[nodiscard]] ContactShadows& shadows() { return *shadows_; }
    /// Blends those over what is there, whatever its depth, that may be seen in `part` of the
    /// picture.
    void draw(const PixelRectangle& part, const glm::mat4& view, const glm::mat4& projection);

private:
    struct Corner
    {
        glm::vec3 place;
        glm::vec2 corner;
        std::array<float, 4> numbers; ///< as contact.vert has them
    };

    const GlFunctions& gl_;
    std::unique_ptr<ContactShadows> shadows_;
    ShaderProgram program_;
    GLuint array_ = 0;
    GLuint buffer_ = 0;
    std::vector<Corner> corners_; ///< six a shadow
};

} // namespace frostfill
