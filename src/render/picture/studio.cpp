// SPDX-License-Identifier: MIT
#include "render/picture/studio.hpp"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <utility>

namespace frostfill
{
namespace
{

/// Towards the lamp in eye space, before it is raised a little.
const glm::dvec3 kLamp(-0.50, 0.50, 0.72);
constexpr float kRaised = 0.4F;

} // namespace

bool Studio::showsGround(const Framing& framing) const
{
    return ground &&
           glm::dot(glm::vec3(framing.eye), up) > (framing.orthographic ? 0 : ground->level);
}

void Studio::light(const Framing& framing, SphereUniforms& uniforms) const
{
    const glm::mat3 toEye(framing.view);
    uniforms.lamp = toEye * lamp;
    uniforms.above = toEye * up;
}

std::optional<Studio> studioOf(const TriangleMesh& mesh, const RenderSettings& settings,
                               const Framing& framing)
{
    if (settings.style.look != Look::studio)
    {
        return {};
    }
    Studio studio;
    studio.up = unitVector(settings.up);
    const glm::dmat3 toUnit = glm::transpose(glm::dmat3(framing.view));
    studio.lamp = glm::normalize(glm::vec3(toUnit * kLamp) + kRaised * studio.up);
    if (settings.style.ground && settings.poses.empty())
    {
        GroundShadow ground =
            groundShadow(mesh, inUnitSpace(mesh, framing), studio.up, studio.lamp);
        if (!ground.corners.empty())
        {
            studio.ground = std::move(ground);
        }
    }
    return studio;
}

} // namespace frostfill
