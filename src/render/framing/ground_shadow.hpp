// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// A level surface under an object, with the object's shadow. [unit space]
struct GroundShadow
{
    int cells = 0;                      ///< of a square grid, along each edge
    std::vector<glm::vec4> places;      ///< its corners: position, and how dark it is there, 0..1
    std::vector<std::uint32_t> corners; ///< of triangles, three each, two for each cell but where
                                        ///< nothing is dark
    float level = 0;                    ///< of the surface along `up`
};

/// The shadow of a mesh that stands on its lowest point: soft, of a wide lamp, and of the sky that
/// it hides from the ground, which is darkest where it touches. `positions` are its vertices, `up`
/// and `towardsLamp` unit vectors.
[[nodiscard]] GroundShadow groundShadow(const TriangleMesh& mesh,
                                        std::span<const glm::vec3> positions, const glm::vec3& up,
                                        const glm::vec3& towardsLamp);

} // namespace frostfill
