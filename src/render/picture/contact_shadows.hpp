// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/triangle_bvh.hpp"
#include "render/framing/framing.hpp"
#include "render/picture/projected_sphere.hpp"
#include "render/picture/sphere_instance.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace frostfill
{

/// A sphere at rest keeps light from the wall that it touches, all around where it does: a disc in
/// the plane of the wall, as large as the sphere. [unit space]
struct ContactShadow
{
    glm::vec3 foot;    ///< the disc's middle
    glm::vec3 across;  ///< away from the lamp along the wall, as long as the sphere's radius
    glm::vec3 inwards; ///< unit vector away from the wall
    float height;      ///< of the sphere's centre above the wall [its radius]
    glm::vec2 lamp;    ///< towards it: along the wall against `across`, and away from the wall
    float strength;    ///< 0..1
    float bend;        ///< sine of the angle by which the wall bends within the disc

    /// In the wall and square to `across`, as long.
    [[nodiscard]] glm::vec3 along() const;
    friend bool operator==(const ContactShadow&, const ContactShadow&) = default;
};

/// All those that spheres at rest throw on the shell, in an order that does not depend on that in
/// which they came, and where those are in the picture whose wall is seen from within.
class ContactShadows
{
public:
    /// Of a sphere's centre from a wall: up to this the shadow is as strong as it can be. [its
    /// radius]
    static constexpr float kTouches = 1.02F;
    static constexpr float kFarthest = 1.25F; ///< here it is gone [its radius]
    /// Shadows fade away as walls turn edge-on: at this cosine they are gone, and so much above
    /// they are as strong as they can be. Where the wall bends a disc would stand out beyond the
    /// outline.
    static constexpr float kEdgeOn = 0.1F;
    static constexpr float kEdgeOnOfBend = 1.5F; ///< more of the former for each bend
    static constexpr float kFade = 0.3F;

    /// `positions` are the mesh's vertices. Spheres of a radius below `smallest` throw none, which
    /// nobody would see. [unit space]
    ContactShadows(const TriangleMesh& mesh, std::span<const glm::vec3> positions,
                   const glm::vec3& towardsLamp, float smallest, bool isCut);

    /// Of one sphere, that on the nearest wall first; it need not be seen.
    [[nodiscard]] std::vector<ContactShadow> of(const SphereInstance& sphere) const;

    /// From the next call of follow on.
    void lookFrom(const Framing& framing, const PictureSize& size, const SphereUniforms& uniforms);
    /// Takes the spheres at rest, of which those from `first` on came since. Returns whether there
    /// are others than before.
    bool follow(std::span<const SphereInstance> resting, std::size_t first);

    /// In the picture, and where.
    struct Seen
    {
        ContactShadow shadow;
        PixelRectangle pixels;
    };
    [[nodiscard]] std::span<const Seen> seen() const { return seen_; }
    /// Where the last call of follow has brought any that are seen.
    [[nodiscard]] std::span<const PixelRectangle> arrived() const { return arrived_; }

private:
    [[nodiscard]] ContactShadow shadowOn(const glm::vec3& foot, const SphereInstance& sphere) const;
    [[nodiscard]] glm::vec3 normalOf(std::uint32_t triangle) const;
    /// Sorted.
    [[nodiscard]] std::vector<ContactShadow>
    findOfAll(std::span<const SphereInstance> spheres) const;
    /// Adds those that are in the picture.
    void place(std::span<const ContactShadow> shadows, std::vector<Seen>& seen) const;

    TriangleMesh mesh_; ///< in unit space
    TriangleBvh triangles_;
    glm::vec3 lamp_;
    float smallest_;
    bool isCut_;                    ///< what lies beside a cut throws none
    std::size_t known_ = 0;         ///< spheres at rest
    std::uint64_t fingerprint_ = 0; ///< of those, in whatever order
    std::vector<ContactShadow> shadows_;
    Framing framing_;
    SphereUniforms uniforms_;
    PictureSize size_;
    bool placed_ = false; ///< for this camera
    std::vector<Seen> seen_;
    std::vector<PixelRectangle> arrived_;
};

/// None but in the studio, and with a shell; `lamp` is the studio's.
[[nodiscard]] std::unique_ptr<ContactShadows> contactShadowsOf(const TriangleMesh& mesh,
                                                               std::span<const glm::vec3> positions,
                                                               const RenderSettings& settings,
                                                               const glm::vec3& lamp);

} // namespace frostfill
