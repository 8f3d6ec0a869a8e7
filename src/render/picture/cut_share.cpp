// SPDX-License-Identifier: MIT
#include "render/picture/cut_share.hpp"

#include <glm/geometric.hpp>

#include <algorithm>

namespace frostfill
{

CutShare cutShareOf(const SphereInstance& sphere, const SphereUniforms& uniforms)
{
    const glm::vec4 centre = uniforms.view * glm::vec4(sphere.x, sphere.y, sphere.z, 1);
    const float radius = 1.0001F * sphere.radius + 1e-6F; // for rounding
    const float depth =
        std::min(glm::dot(uniforms.cutPlanes[0], centre), glm::dot(uniforms.cutPlanes[1], centre));
    if (depth > radius)
    {
        return CutShare::nothing;
    }
    return depth < -radius ? CutShare::whole : CutShare::part;
}

} // namespace frostfill
