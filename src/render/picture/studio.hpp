// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/framing.hpp"
#include "render/framing/ground_shadow.hpp"
#include "render/picture/sphere_instance.hpp"

#include <frostfill/renderer.hpp>

#include <glm/vec3.hpp>

#include <optional>

namespace frostfill
{

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
