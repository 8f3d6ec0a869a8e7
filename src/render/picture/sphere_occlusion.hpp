// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/framing.hpp"
#include "render/picture/occluder_grid.hpp"
#include "render/picture/sphere_instance.hpp"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace frostfill
{

/// What was asked for last of many spheres, of which most are hidden and never asked for.
struct LightsOfSpheres
{
    static constexpr std::uint32_t kNone = 0xffffffffU;
    std::span<const std::uint32_t> slots; ///< [spheres] index of its light, or kNone
    std::span<const SphereLight> lights;

    /// Returns null without ambient occlusion, and full light for a sphere that was never asked
    /// for.
    [[nodiscard]] const SphereLight* of(std::size_t sphere) const
    {
        static const SphereLight kOpen;
        return slots.empty() ? nullptr : slots[sphere] == kNone ? &kOpen : &lights[slots[sphere]];
    }
};

/// What keeps light from spheres: all that are at rest, in a grid. The answer for a sphere depends
/// on which others are there and not on the order in which they came. [unit space]
class SphereOcclusion
{
public:
    /// Neighbours whose surface is further than this from a sphere take no part of the sky from it.
    /// [radius of the sphere that is lit]
    static constexpr float kReach = 1.6F;
    /// Nor of the lamp, when they are further than this in its direction.
    static constexpr float kLampReach = 7;

    /// `towardsLamp` is a unit vector, or 0 if there is no lamp. Spheres that a cut
    /// removes occlude nothing.
    SphereOcclusion(const glm::vec3& towardsLamp, const std::optional<CutPlanes>& cut);

    /// Takes these and no others, which have indices in this order from now on. What is known of
    /// those that were there before is kept where none has gone.
    void start(std::span<const SphereInstance> resting);
    void add(const SphereInstance& sphere);
    /// Takes those from `first` on that came to rest since; 0: starts.
    void follow(std::span<const SphereInstance> resting, std::size_t first);

    /// The neighbours that hide most from a sphere, and what all others let through to it. That of
    /// a sphere at rest is kept until one is added that reaches it.
    SphereLight of(const SphereInstance& sphere);
    const SphereLight& ofResting(std::size_t index);
    /// Asks for that of many at rest; cores share the work.
    void ask(std::span<const std::uint32_t> indices);
    [[nodiscard]] LightsOfSpheres lights() const { return {slots_, lights_}; }
    /// Asks again for those that spheres that were added have reached since, as far as they are
    /// seen. Returns those that have changed, until the next call.
    std::span<const std::uint32_t> refresh(const std::function<bool(std::uint32_t)>& isSeen);

    /// Whether a sphere's light may depend on another one's being there.
    [[nodiscard]] bool reaches(const SphereInstance& from, const SphereInstance& to) const;

private:
    struct Neighbour
    {
        float weight;  ///< how much it hides
        glm::vec3 way; ///< from the sphere's centre, in its radius
        float radius;  ///< in the sphere's
    };

    [[nodiscard]] bool isCutAway(const glm::vec4& ball) const;
    /// Whether the light of one at rest was asked for, and nothing has come since that reaches it.
    [[nodiscard]] bool isKnown(std::size_t index) const;
    /// Where the light of one at rest is kept from now on.
    std::uint32_t slotOf(std::size_t index);
    /// Indices until now; the number of spheres until now for all that were not there, and for all
    /// if one that was there has gone.
    [[nodiscard]] std::vector<std::size_t>
    placesBefore(std::span<const SphereInstance> resting) const;
    void forgetLightAround(const glm::vec4& arrival);
    /// True also for some that just do not. Centres and radii.
    [[nodiscard]] bool mayReach(const glm::vec4& from, const glm::vec4& to) const;
    /// What hides anything from a sphere, that which hides most first.
    [[nodiscard]] std::vector<Neighbour> neighboursOf(const glm::vec4& ball) const;
    [[nodiscard]] SphereLight lightOn(const glm::vec4& ball) const;

    glm::vec3 lamp_;
    std::optional<CutPlanes> cut_;
    OccluderGrid grid_;
    std::vector<std::uint32_t> slots_;   ///< [spheres] see LightsOfSpheres
    std::vector<SphereLight> lights_;    ///< [slots] when last asked for
    std::vector<std::uint8_t> known_;    ///< [slots] 1: none has come since that reaches it
    std::vector<std::uint32_t> reached_; ///< that were known until others came
    std::vector<std::uint32_t> changed_; ///< what refresh has returned
    std::vector<bool> cutAway_;          ///< [spheres] and so keep no light off
};

} // namespace frostfill
