// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/framing.hpp"
#include "render/picture/sphere_instance.hpp"

#include <frostfill/mesh.hpp>
#include <frostfill/renderer.hpp>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace frostfill
{

/// A level surface under an object, with the object's shadow. [unit space]
struct GroundShadow
{
    int cells = 0;                 ///< of a square grid, along each edge; 0: nothing is dark
    std::vector<glm::vec4> places; ///< its corners: position, and how dark it is there, 0..1
    float level = 0;               ///< of the surface along `up`
};

/// The shadow of a mesh that stands on its lowest point: soft, of a wide lamp, and of the sky that
/// it hides from the ground, which is darkest where it touches. `positions` are its vertices, `up`
/// and `towardsLamp` unit vectors.
[[nodiscard]] GroundShadow groundShadow(const TriangleMesh& mesh,
                                        std::span<const glm::vec3> positions, const glm::vec3& up,
                                        const glm::vec3& towardsLamp);

/// What stands around the object in the style studio, and stays there when the camera moves. [unit
/// space]
struct Studio
{
    glm::vec3 up{0, 1, 0};
    glm::vec3 lamp{0, 1, 0};            ///< towards it
    std::optional<GroundShadow> ground; ///< where there is a shadow on it

    /// Only from above.
    [[nodiscard]] bool showsGround(const Framing& framing) const;
    /// Adds where the lamp and what is above are, as the camera sees them.
    void light(const Framing& framing, SphereUniforms& uniforms) const;
};

/// Returns none in other styles. `framing` is where the camera stands at first.
[[nodiscard]] std::optional<Studio>
studioOf(const TriangleMesh& mesh, const RenderSettings& settings, const Framing& framing);

/// The way to the lamp for SphereOcclusion: outside the studio there is none.
[[nodiscard]] inline glm::vec3 lampOf(const std::optional<Studio>& studio)
{
    return studio ? studio->lamp : glm::vec3(0);
}

} // namespace frostfill
