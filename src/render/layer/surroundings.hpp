// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/cutaway_planes.hpp"
#include "render/passes/sphere_pass.hpp"

#include <glm/ext/vector_int3.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace frostfill
{

/// What keeps light from spheres: all that are at rest, in a grid. The answer for a sphere depends
/// on which others are there and not on the order in which they came. [unit space]
class Surroundings
{
public:
    /// `towardsLamp` is a unit vector. What a cut takes away keeps no light off.
    Surroundings(const glm::vec3& towardsLamp, const std::optional<CutPlanes>& cut);

    /// Forgets all and takes these.
    void start(std::span<const SphereInstance> resting);
    void add(const SphereInstance& sphere);

    /// The neighbours that hide most from a sphere, and what all others let through to it. That of
    /// a sphere at rest is kept until one is added that reaches it.
    [[nodiscard]] SphereLight of(const SphereInstance& sphere);
    /// Whether spheres that were added have changed the light of one at rest since it was last
    /// asked for; true if it never was.
    [[nodiscard]] bool hasChanged(const SphereInstance& sphere);

    /// Whether a sphere's light may depend on another one's being there.
    [[nodiscard]] bool reaches(const SphereInstance& from, const SphereInstance& to) const;

private:
    /// What is known of a sphere's light.
    enum class Known : std::uint8_t
    {
        nothing,
        before, ///< that it was, before some came that may have changed it
        now,
    };

    struct Neighbour
    {
        float weight;  ///< how much it hides
        glm::vec3 way; ///< from the sphere's centre, in its radius
        float radius;  ///< in the sphere's
    };

    [[nodiscard]] std::uint32_t cellOf(const glm::ivec3& place) const;
    [[nodiscard]] glm::ivec3 placeOf(const glm::vec3& point) const;
    void rebuild();
    void push(const SphereInstance& sphere);
    /// Index of a sphere that was added; that of none is the number of spheres.
    [[nodiscard]] std::size_t indexOf(const SphereInstance& sphere) const;
    void forgetLightAround(const SphereInstance& arrival);
    /// Calls visit(index) for the spheres whose centres are in cells that a box touches.
    template <typename Visit>
    void eachIn(const glm::vec3& low, const glm::vec3& high, Visit visit) const;
    void collect(const SphereInstance& sphere);
    [[nodiscard]] SphereLight lightOn(const SphereInstance& sphere);
    /// On a sphere that was added; kept.
    const SphereLight& keptLight(std::size_t index);

    glm::vec3 lamp_;
    std::optional<CutPlanes> cut_;
    float largest_ = 0; ///< radius
    float cell_ = 1;    ///< edge of the grid's cells
    std::vector<SphereInstance> spheres_;
    std::vector<std::uint32_t> heads_; ///< of the cells' lists, hashed; index + 1, or 0
    std::vector<std::uint32_t> nexts_; ///< [spheres]
    std::vector<SphereLight> lights_;  ///< [spheres] when last asked for
    std::vector<Known> known_;         ///< [spheres]
    std::vector<bool> cutAway_;        ///< [spheres] and so keep no light off
    std::vector<Neighbour> near_;      ///< reused
};

} // namespace frostfill
