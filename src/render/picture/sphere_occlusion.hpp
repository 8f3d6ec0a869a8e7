// SPDX-License-Identifier: MIT
#pragma once

#include "base/buckets.hpp"
#include "geometry/grid_frame.hpp"
#include "render/framing/framing.hpp"
#include "render/picture/sphere_instance.hpp"

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
        const auto [left, bottom, back] = frame_.coordinates(asEigen(lowest));
        const auto [right, top, front] = frame_.coordinates(asEigen(highest));
        const float halfDiagonal = 0.8661F * static_cast<float>(frame_.cell);
        for (int z = back; z <= front; ++z)
        {
            for (int y = bottom; y <= top; ++y)
            {
                const auto mayHoldAt = [&, y = y, z = z](int x)
                {
                    const Eigen::Vector3f middle = frame_.centre(x, y, z).cast<float>();
                    return mayHold(glm::vec3(middle.x(), middle.y(), middle.z()), halfDiagonal);
                };
                int first = left;
                int last = right;
                for (; first <= last && !mayHoldAt(first); ++first)
                {
                }
                for (; last > first && !mayHoldAt(last); --last)
                {
                }
                for (int x = first; x <= last; ++x)
                {
                    for (const std::uint32_t sphere : cells_[frame_.index(x, y, z)])
                    {
                        visit(sphere);
                    }
                }
            }
        }
        for (std::size_t i = cells_.values().size(); i < spheres_.size(); ++i)
        {
            visit(static_cast<std::uint32_t>(i));
        }
    }

private:
    [[nodiscard]] static Eigen::Vector3d asEigen(const glm::vec3& p) { return {p.x, p.y, p.z}; }
    void build();

    float largest_ = 0;
    std::vector<glm::vec4> spheres_; ///< centre, radius
    GridFrame frame_;
    Buckets<std::uint32_t> cells_{1, [](auto) {}}; ///< indices of spheres
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
