// SPDX-License-Identifier: MIT
#include "render/picture/sphere_occlusion.hpp"

#include "render/framing/numbers.hpp"
#include "render/picture/for_all.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>
#include <utility>

namespace frostfill
{

namespace
{

/// So many, and so large a part of all, are looked at one by one before cells are built anew.
constexpr std::size_t kMostInList = 16;
constexpr std::size_t kPartInList = 128;

constexpr double kMostAlong = 1000; ///< cells along an axis

glm::vec4 ballOf(const SphereInstance& sphere)
{
    return {sphere.x, sphere.y, sphere.z, sphere.radius};
}

} // namespace

void OccluderGrid::start(std::span<const SphereInstance> spheres)
{
    spheres_.clear();
    spheres_.reserve(spheres.size());
    std::transform(spheres.begin(), spheres.end(), std::back_inserter(spheres_), ballOf);
    build();
}

void OccluderGrid::add(const SphereInstance& sphere)
{
    spheres_.push_back(ballOf(sphere));
    largest_ = std::max(largest_, sphere.radius);
    const std::size_t inCells = cells_.values().size();
    if (spheres_.size() - inCells > kMostInList + inCells / kPartInList)
    {
        build();
    }
}

void OccluderGrid::build()
{
    Eigen::AlignedBox3d box;
    largest_ = 0;
    for (const glm::vec4& sphere : spheres_)
    {
        box.extend(asEigen(glm::vec3(sphere)));
        largest_ = std::max(largest_, sphere.w);
    }
    if (spheres_.empty())
    {
        box.extend(Eigen::Vector3d::Zero());
    }
    // Not many more cells than spheres.
    const double spheres = std::max(1.0, static_cast<double>(spheres_.size()));
    const double cell = std::max({2.0 * largest_, std::cbrt(box.volume() / spheres),
                                  box.sizes().maxCoeff() / kMostAlong, 1e-6});
    frame_ = GridFrame::cover(box, cell, 0);
    cells_ = Buckets<std::uint32_t>(frame_.size(),
                                    [&](auto enter)
                                    {
                                        for (std::uint32_t i = 0; i < spheres_.size(); ++i)
                                        {
                                            enter(frame_.index(asEigen(glm::vec3(spheres_[i]))), i);
                                        }
                                    });
}

std::size_t OccluderGrid::indexOf(const SphereInstance& sphere) const
{
    std::size_t found = spheres_.size();
    const glm::vec4 ball = ballOf(sphere);
    eachIn(
        glm::vec3(ball), glm::vec3(ball), [](const glm::vec3&, float) { return true; },
        [&](std::uint32_t i) { found = spheres_[i] == ball ? i : found; });
    return found;
}

namespace
{

/// See forAll.
constexpr std::size_t kSurroundedATask = 64;

/// Of the lamp that a neighbour hides, seen from the sphere as a whole. Lengths are in the radius
/// of the sphere that is lit. `ahead`: towards the lamp; `beside`: from the ray through the
/// sphere's centre.
float lampHidden(float ahead, float beside, float radius)
{
    const float spread = 1 + shading::kLampSoftness * ahead;
    return std::clamp((radius + spread - beside) / (2 * spread), 0.0F, 1.0F) *
           std::min(radius * radius / (spread * spread) * 1.5F, 1.0F);
}

/// Where the centres of those may be that keep light from a sphere, or from which it keeps light:
/// close by, or around a ray, in a cone that begins narrower than what is close.
struct Zone
{
    glm::vec3 middle;
    float close;
    glm::vec3 ray;  ///< unit vector
    float farthest; ///< along the ray
    float wide;     ///< where the ray begins

    [[nodiscard]] bool mayHold(const glm::vec3& point, float slack) const
    {
        const glm::vec3 way = point - middle;
        const float squared = glm::dot(way, way);
        const float ahead = glm::dot(way, ray);
        const float beside = wide + shading::kLampSoftness * (ahead + slack) + slack;
        return squared < (close + slack) * (close + slack) ||
               (ahead > -slack && ahead < farthest + slack &&
                squared - ahead * ahead < beside * beside);
    }

    template <typename Visit>
    void each(const OccluderGrid& grid, Visit visit) const
    {
        const glm::vec3 end = middle + farthest * ray;
        const float atEnd = wide + shading::kLampSoftness * farthest;
        grid.eachIn(
            glm::min(middle - close, end - atEnd), glm::max(middle + close, end + atEnd),
            [&](const glm::vec3& point, float slack) { return mayHold(point, slack); }, visit);
    }
};

std::int8_t toByte(float share)
{
    return static_cast<std::int8_t>(std::lround(127 * std::clamp(share, -1.0F, 1.0F)));
}

} // namespace

SphereOcclusion::SphereOcclusion(const glm::vec3& towardsLamp, const std::optional<CutPlanes>& cut)
    : lamp_(towardsLamp), cut_(cut)
{
}

std::vector<std::size_t>
SphereOcclusion::placesBefore(std::span<const SphereInstance> resting) const
{
    std::vector<std::size_t> places;
    const std::size_t count = grid_.size();
    std::vector<bool> isThere(count);
    places.reserve(resting.size());
    for (const SphereInstance& sphere : resting)
    {
        places.push_back(grid_.indexOf(sphere));
        if (places.back() < count)
        {
            isThere[places.back()] = true;
        }
    }
    const bool noneHasGone = std::find(isThere.begin(), isThere.end(), false) == isThere.end();
    return noneHasGone ? places : std::vector(resting.size(), count);
}

void SphereOcclusion::start(std::span<const SphereInstance> resting)
{
    const std::vector<std::size_t> before = placesBefore(resting);
    const std::vector<std::uint32_t> slots = std::exchange(slots_, {});
    grid_.start(resting);
    reached_.clear();
    cutAway_.clear();
    slots_.reserve(resting.size());
    bool anyKept = false;
    for (std::size_t i = 0; i < resting.size(); ++i)
    {
        cutAway_.push_back(isCutAway(grid_[i]));
        slots_.push_back(before[i] < slots.size() ? slots[before[i]] : LightsOfSpheres::kNone);
        anyKept = anyKept || slots_.back() != LightsOfSpheres::kNone;
    }
    if (!anyKept)
    {
        lights_.clear();
        known_.clear();
        return;
    }
    for (std::size_t i = 0; i < resting.size(); ++i)
    {
        if (before[i] == slots.size() && !cutAway_[i])
        {
            forgetLightAround(grid_[i]);
        }
    }
}

void SphereOcclusion::add(const SphereInstance& sphere)
{
    grid_.add(sphere);
    slots_.push_back(LightsOfSpheres::kNone);
    const glm::vec4& ball = grid_[grid_.size() - 1];
    cutAway_.push_back(isCutAway(ball));
    if (!cutAway_.back())
    {
        forgetLightAround(ball);
    }
}

void SphereOcclusion::follow(std::span<const SphereInstance> resting, std::size_t first)
{
    if (first == 0)
    {
        start(resting);
        return;
    }
    for (const SphereInstance& sphere : resting.subspan(first))
    {
        add(sphere);
    }
}

bool SphereOcclusion::isCutAway(const glm::vec4& ball) const
{
    const glm::dvec4 centre(ball.x, ball.y, ball.z, 1);
    return cut_ && glm::dot((*cut_)[0], centre) > 0 && glm::dot((*cut_)[1], centre) > 0;
}

bool SphereOcclusion::isKnown(std::size_t index) const
{
    return slots_[index] != LightsOfSpheres::kNone && known_[slots_[index]] != 0;
}

std::uint32_t SphereOcclusion::slotOf(std::size_t index)
{
    if (slots_[index] == LightsOfSpheres::kNone)
    {
        slots_[index] = static_cast<std::uint32_t>(lights_.size());
        lights_.emplace_back();
        known_.push_back(0);
    }
    return slots_[index];
}

void SphereOcclusion::forgetLightAround(const glm::vec4& arrival)
{
    // The other way round than in neighboursOf: who would find this one there.
    const glm::vec3 centre(arrival);
    const float largest = grid_.largest();
    const Zone zone{centre, (1 + kReach) * largest + arrival.w, -lamp_, kLampReach * largest,
                    largest + arrival.w};
    zone.each(grid_,
              [&](std::uint32_t i)
              {
                  if (isKnown(i) && mayReach(arrival, grid_[i]))
                  {
                      known_[slots_[i]] = 0;
                      reached_.push_back(i);
                  }
              });
}

bool SphereOcclusion::mayReach(const glm::vec4& from, const glm::vec4& to) const
{
    const glm::vec3 way(from - to);
    const float squared = glm::dot(way, way);
    const float near = (1 + kReach) * to.w + from.w;
    if (squared < near * near * 1.0001F)
    {
        return true;
    }
    const float ahead = glm::dot(way, lamp_);
    const float wide = to.w + from.w + shading::kLampSoftness * ahead;
    return ahead > 0 && ahead < kLampReach * to.w * 1.0001F &&
           squared - ahead * ahead < wide * wide * 1.0001F;
}

std::vector<SphereOcclusion::Neighbour> SphereOcclusion::neighboursOf(const glm::vec4& ball) const
{
    std::vector<Neighbour> near;
    const glm::vec3 centre(ball);
    const auto meet = [&](const glm::vec4& other)
    {
        if (!mayReach(other, ball))
        {
            return;
        }
        const glm::vec3 way = (glm::vec3(other) - centre) / ball.w;
        const float radius = other.w / ball.w;
        const float squared = glm::dot(way, way);
        if (!(squared > 1e-6F))
        {
            return; // itself
        }
        const float ahead = glm::dot(way, lamp_);
        const float besideSquared = squared - ahead * ahead;
        float weight = squared < (1 + kReach + radius) * (1 + kReach + radius)
                           ? radius * radius / squared
                           : 0.0F;
        const float wide = 1 + radius + shading::kLampSoftness * std::max(ahead, 0.0F);
        if (ahead > 0 && ahead < kLampReach && besideSquared < wide * wide)
        {
            weight += 0.5F * radius * radius / (1 + ahead);
        }
        if (weight > 0)
        {
            near.push_back({weight, way, radius});
        }
    };
    const Zone zone{centre, (1 + kReach) * ball.w + grid_.largest(), lamp_, kLampReach * ball.w,
                    ball.w + grid_.largest()};
    zone.each(grid_,
              [&](std::uint32_t i)
              {
                  if (!cutAway_[i])
                  {
                      meet(grid_[i]);
                  }
              });
    std::sort(near.begin(), near.end(),
              [](const Neighbour& a, const Neighbour& b)
              {
                  return std::tie(b.weight, a.way.x, a.way.y, a.way.z) <
                         std::tie(a.weight, b.way.x, b.way.y, b.way.z);
              });
    return near;
}

SphereLight SphereOcclusion::lightOn(const glm::vec4& ball) const
{
    SphereLight light;
    const std::vector<Neighbour> neighbours = neighboursOf(ball);
    const std::size_t listed = std::min(neighbours.size(), light.occluders.size());
    for (std::size_t i = 0; i < listed; ++i)
    {
        const Neighbour& near = neighbours[i];
        // What is too large to be told is brought nearer: it hides as much.
        const float size = std::max({std::abs(near.way.x), std::abs(near.way.y),
                                     std::abs(near.way.z), near.radius, shading::kOccluderRange});
        light.occluders[i] = {toByte(near.way.x / size), toByte(near.way.y / size),
                              toByte(near.way.z / size), toByte(near.radius / size)};
    }
    float sky = 1;
    float lamp = 1;
    for (std::size_t i = listed; i < neighbours.size(); ++i)
    {
        const Neighbour& near = neighbours[i];
        const float squared = glm::dot(near.way, near.way);
        const float ahead = glm::dot(near.way, lamp_);
        sky *= 1 - 0.25F * std::min(near.radius * near.radius / squared, 1.0F);
        if (ahead > 0)
        {
            const float beside = std::sqrt(std::max(squared - ahead * ahead, 0.0F));
            lamp *= 1 - lampHidden(ahead, beside, near.radius);
        }
    }
    light.open = {static_cast<std::uint8_t>(std::lround(255 * sky)),
                  static_cast<std::uint8_t>(std::lround(255 * lamp)), 0, 0};
    return light;
}

SphereLight SphereOcclusion::of(const SphereInstance& sphere)
{
    const std::size_t own = grid_.indexOf(sphere);
    return own == grid_.size() ? lightOn({sphere.x, sphere.y, sphere.z, sphere.radius})
                               : ofResting(own);
}

const SphereLight& SphereOcclusion::ofResting(std::size_t index)
{
    const std::uint32_t slot = slotOf(index);
    if (known_[slot] == 0)
    {
        lights_[slot] = lightOn(grid_[index]);
        known_[slot] = 1;
    }
    return lights_[slot];
}

void SphereOcclusion::ask(std::span<const std::uint32_t> indices)
{
    for (const std::uint32_t index : indices)
    {
        slotOf(index);
    }
    forAll(indices.size(), kSurroundedATask, [&](std::size_t i) { ofResting(indices[i]); });
}

std::span<const std::uint32_t>
SphereOcclusion::refresh(const std::function<bool(std::uint32_t)>& isSeen)
{
    changed_.clear();
    for (const std::uint32_t index : reached_)
    {
        if (isSeen(index))
        {
            const SphereLight before = lights_[slots_[index]];
            if (ofResting(index) != before)
            {
                changed_.push_back(index);
            }
        }
    }
    reached_.clear();
    return changed_;
}

bool SphereOcclusion::reaches(const SphereInstance& from, const SphereInstance& to) const
{
    return mayReach(glm::vec4(from.x, from.y, from.z, from.radius),
                    glm::vec4(to.x, to.y, to.z, to.radius));
}

} // namespace frostfill
