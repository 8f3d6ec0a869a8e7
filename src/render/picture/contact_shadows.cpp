// SPDX-License-Identifier: MIT
#include "render/picture/contact_shadows.hpp"

#include "geometry/closest_point.hpp"
#include "render/picture/cut_share.hpp"
#include "render/picture/for_all.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <tuple>

namespace frostfill
{
namespace
{

/// What is nearer has gone through the wall. [the sphere's radius]
constexpr float kGoneThrough = 0.5F;

/// Of the cosine of the angle between two walls' normals: what is more alike is one wall.
constexpr float kOneWall = 0.5F;
constexpr std::size_t kMostWalls = 3; ///< as in a corner

/// Smallest spheres that throw any, in a picture that the object fills. [pixel]
constexpr float kSmallest = 3;

/// See forAll: a search takes less than a microsecond, and far from walls nothing.
constexpr std::size_t kSearchesATask = 512;

auto keyOf(const ContactShadow& shadow)
{
    return std::tuple(shadow.foot.x, shadow.foot.y, shadow.foot.z, shadow.inwards.x,
                      shadow.inwards.y, shadow.inwards.z);
}

bool isBefore(const ContactShadow& a, const ContactShadow& b)
{
    return keyOf(a) < keyOf(b);
}

/// The sum for some spheres is the same in any order.
std::uint64_t fingerprintOf(const SphereInstance& sphere)
{
    std::uint64_t mixed = 0;
    for (const float number : {sphere.x, sphere.y, sphere.z, sphere.radius})
    {
        mixed = (mixed ^ std::bit_cast<std::uint32_t>(number)) * 0x9e3779b97f4a7c15U;
        mixed ^= mixed >> 29;
    }
    return mixed;
}

Eigen::Vector3d toEigen(const glm::vec3& v)
{
    return {v.x, v.y, v.z};
}

glm::vec3 toGlm(const Eigen::Vector3d& v)
{
    return glm::vec3(glm::dvec3(v.x(), v.y(), v.z()));
}

} // namespace

glm::vec3 ContactShadow::along() const
{
    return glm::cross(inwards, across);
}

ContactShadows::ContactShadows(const TriangleMesh& mesh, std::span<const glm::vec3> positions,
                               const glm::vec3& towardsLamp, float smallest, bool isCut)
    : lamp_(towardsLamp), smallest_(smallest), isCut_(isCut)
{
    mesh_.triangles = mesh.triangles;
    std::transform(positions.begin(), positions.end(), std::back_inserter(mesh_.vertices), toEigen);
    triangles_ = TriangleBvh(mesh_);
}

void ContactShadows::lookFrom(const Framing& framing, const PictureSize& size,
                              const SphereUniforms& uniforms)
{
    framing_ = framing;
    size_ = size;
    uniforms_ = uniforms;
    placed_ = false;
}

bool ContactShadows::follow(std::span<const SphereInstance> resting, std::size_t first)
{
    arrived_.clear();
    std::uint64_t fingerprint = first == known_ ? fingerprint_ : 0;
    const std::size_t from = first == known_ ? first : 0;
    for (const SphereInstance& sphere : resting.subspan(from))
    {
        fingerprint += sphere.radius < smallest_ ? 0 : fingerprintOf(sphere);
    }
    const bool same = fingerprint == fingerprint_ && resting.size() == known_;
    known_ = resting.size();
    fingerprint_ = fingerprint;
    if (same && placed_)
    {
        return false;
    }
    std::vector<ContactShadow> found;
    if (!same)
    {
        found = findOfAll(resting.subspan(from));
        if (from == 0)
        {
            shadows_.clear();
            placed_ = false;
        }
        const auto middle = static_cast<std::ptrdiff_t>(shadows_.size());
        shadows_.insert(shadows_.end(), found.begin(), found.end());
        std::inplace_merge(shadows_.begin(), shadows_.begin() + middle, shadows_.end(), isBefore);
    }
    if (!placed_)
    {
        seen_.clear();
        place(shadows_, seen_);
        placed_ = true;
        arrived_ = {{0, 0, size_.width, size_.height}};
        return true;
    }
    const auto before = static_cast<std::ptrdiff_t>(seen_.size());
    place(found, seen_);
    std::transform(seen_.begin() + before, seen_.end(), std::back_inserter(arrived_),
                   [](const Seen& seen) { return seen.pixels; });
    std::inplace_merge(seen_.begin(), seen_.begin() + before, seen_.end(),
                       [](const Seen& a, const Seen& b) { return isBefore(a.shadow, b.shadow); });
    return !arrived_.empty();
}

std::vector<ContactShadow> ContactShadows::findOfAll(std::span<const SphereInstance> spheres) const
{
    tbb::enumerable_thread_specific<std::vector<ContactShadow>> parts;
    forAll(spheres.size(), kSearchesATask,
           [&](std::size_t i)
           {
               const std::vector<ContactShadow> own = of(spheres[i]);
               parts.local().insert(parts.local().end(), own.begin(), own.end());
           });
    std::vector<ContactShadow> found;
    for (const std::vector<ContactShadow>& part : parts)
    {
        found.insert(found.end(), part.begin(), part.end());
    }
    std::sort(found.begin(), found.end(), isBefore);
    return found;
}

std::vector<ContactShadow> ContactShadows::of(const SphereInstance& sphere) const
{
    std::vector<ContactShadow> found;
    if (sphere.radius < smallest_)
    {
        return found;
    }
    const glm::vec3 centre(sphere.x, sphere.y, sphere.z);
    const Eigen::Vector3d p = toEigen(centre);
    const double limit = double{kFarthest} * double{sphere.radius};
    struct Near
    {
        double squared; ///< distance
        glm::vec3 point;
        glm::vec3 normal;
    };
    std::vector<Near> near;
    triangles_.forEachTriangleNear(
        p, limit,
        [&](std::uint32_t triangle)
        {
            const auto& [a, b, c] = mesh_.triangles[triangle];
            const Eigen::Vector3d point =
                closestPointOnTriangle(p, mesh_.vertices[a], mesh_.vertices[b], mesh_.vertices[c])
                    .point;
            const double squared = (point - p).squaredNorm();
            if (squared < limit * limit)
            {
                near.push_back({squared, toGlm(point), normalOf(triangle)});
            }
            return limit;
        });
    const auto order = [](const Near& n)
    { return std::tuple(n.squared, n.point.x, n.point.y, n.point.z); };
    std::sort(near.begin(), near.end(),
              [&](const Near& a, const Near& b) { return order(a) < order(b); });
    for (const Near& one : near)
    {
        const ContactShadow shadow = shadowOn(one.point, sphere);
        const auto isOfWall = [&](const ContactShadow& wall)
        { return glm::dot(wall.inwards, shadow.inwards) > kOneWall; };
        auto wall = std::find_if(found.begin(), found.end(), isOfWall);
        if (wall == found.end() && found.size() < kMostWalls && shadow.height > kGoneThrough)
        {
            wall = found.insert(wall, shadow);
        }
        if (wall != found.end())
        {
            const float along = glm::dot(wall->inwards, one.normal);
            wall->bend = std::max(wall->bend, std::sqrt(std::max(1 - along * along, 0.0F)));
        }
    }
    return found;
}

glm::vec3 ContactShadows::normalOf(std::uint32_t triangle) const
{
    const auto& [a, b, c] = mesh_.triangles[triangle];
    const Eigen::Vector3d& corner = mesh_.vertices[a];
    return toGlm((mesh_.vertices[b] - corner).cross(mesh_.vertices[c] - corner).normalized());
}

ContactShadow ContactShadows::shadowOn(const glm::vec3& foot, const SphereInstance& sphere) const
{
    ContactShadow shadow{};
    const glm::vec3 way = glm::vec3(sphere.x, sphere.y, sphere.z) - foot;
    const float distance = glm::length(way);
    shadow.foot = foot;
    shadow.inwards = way / distance;
    shadow.height = distance / sphere.radius;
    const float up = glm::dot(lamp_, shadow.inwards);
    const glm::vec3 level = lamp_ - up * shadow.inwards;
    const glm::vec3 axis =
        std::abs(shadow.inwards.x) < 0.7F ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    shadow.lamp = {glm::length(level), up};
    shadow.across =
        sphere.radius * (shadow.lamp.x > 1e-3F ? level / -shadow.lamp.x
                                               : glm::normalize(glm::cross(shadow.inwards, axis)));
    shadow.strength = 1 - glm::smoothstep(kTouches, kFarthest, shadow.height);
    return shadow;
}

void ContactShadows::place(std::span<const ContactShadow> shadows, std::vector<Seen>& seen) const
{
    const SphereProjector projector(framing_, size_);
    const glm::vec3 eye(framing_.eye);
    for (const ContactShadow& shadow : shadows)
    {
        const glm::vec3 towards = framing_.orthographic ? eye : eye - shadow.foot;
        const SphereInstance around{
            shadow.foot.x, shadow.foot.y, shadow.foot.z, glm::length(shadow.across), 0, {}};
        const float facing = glm::dot(glm::normalize(towards), shadow.inwards);
        if (facing > 0 && (!isCut_ || cutShareOf(around, uniforms_) == CutShare::whole))
        {
            const PixelRectangle pixels = projector.project(around).pixels;
            if (!pixels.empty())
            {
                seen.push_back({shadow, pixels});
                const float edgeOn = kEdgeOn + kEdgeOnOfBend * shadow.bend;
                seen.back().shadow.strength *= glm::smoothstep(edgeOn, edgeOn + kFade, facing);
            }
        }
    }
}

std::unique_ptr<ContactShadows> contactShadowsOf(const TriangleMesh& mesh,
                                                 std::span<const glm::vec3> positions,
                                                 const RenderSettings& settings,
                                                 const glm::vec3& lamp)
{
    if (settings.style.look != Look::studio || !settings.style.shell)
    {
        return nullptr;
    }
    const int rows = settings.size.height / settings.supersample;
    return std::make_unique<ContactShadows>(mesh, positions, lamp,
                                            2 * kSmallest / static_cast<float>(rows),
                                            settings.style.cutaway.kind != Cutaway::Kind::none);
}

} // namespace frostfill
