// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/framing.hpp"
#include "render/picture/sphere_instance.hpp"

#include <glm/ext/vector_int3.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace frostfill
{

/// Spheres that are found by their places; they have indices in the order in which they were added.
/// Those that were there when the grid was last built lie in cells, row by row, so that neighbours
/// are read one after another; those that have come since are few, and in a list.
class OccluderGrid
{
public:
    void start(std::span<const SphereInstance> spheres);
    void add(const SphereInstance& sphere);

    [[nodiscard]] std::size_t size() const { return spheres_.size(); }
    /// Centre and radius.
    [[nodiscard]] const glm::vec4& operator[](std::size_t sphere) const { return spheres_[sphere]; }
    /// No sphere has a larger radius.
    [[nodiscard]] float largest() const { return largest_; }
    /// Index of one of the same place and size; the number of spheres if there is none.
    [[nodiscard]] std::size_t indexOf(const SphereInstance& sphere) const;
    /// Calls visit(index) for the spheres whose centres are in cells that a box touches and that
    /// mayHold(middle, half diagonal) does not rule out; and for others nearby.
    template <typename MayHold, typename Visit>
    void eachIn(const glm::vec3& lowest, const glm::vec3& highest, MayHold mayHold,
                Visit visit) const
    {
        const glm::ivec3 low = placeOf(lowest);
        const glm::ivec3 high = placeOf(highest);
        const float halfDiagonal = 0.8661F * cell_;
        for (int z = low.z; z <= high.z; ++z)
        {
            for (int y = low.y; y <= high.y; ++y)
            {
                const auto mayHoldAt = [&](int x)
                {
                    const glm::vec3 middle = corner_ + (glm::vec3(x, y, z) + 0.5F) * cell_;
                    return mayHold(middle, halfDiagonal);
                };
                int first = low.x;
                int last = high.x;
                for (; first <= last && !mayHoldAt(first); ++first)
                {
                }
                for (; last > first && !mayHoldAt(last); --last)
                {
                }
                const std::size_t row = rowOf(y, z);
                for (std::uint32_t k = begins_[row + static_cast<std::size_t>(first)];
                     first <= last && k < begins_[row + static_cast<std::size_t>(last) + 1]; ++k)
                {
                    visit(inCells_[k]);
                }
            }
        }
        for (std::size_t i = inCells_.size(); i < spheres_.size(); ++i)
        {
            visit(static_cast<std::uint32_t>(i));
        }
    }

private:
    /// The cell of a point, or the one nearest to it. [cells]
    [[nodiscard]] glm::ivec3 placeOf(const glm::vec3& point) const;
    [[nodiscard]] std::size_t rowOf(int y, int z) const;
    [[nodiscard]] std::size_t cellOf(std::size_t sphere) const;
    void build();

    float largest_ = 0;
    glm::vec3 corner_{0};
    float cell_ = 1;                          ///< edge of the cells
    glm::ivec3 cells_{1};                     ///< along each axis
    std::vector<glm::vec4> spheres_;          ///< centre, radius
    std::vector<std::uint32_t> begins_{0, 0}; ///< [cells + 1] in inCells_
    std::vector<std::uint32_t> inCells_;      ///< indices of spheres by cells
};

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
