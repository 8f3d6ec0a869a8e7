// SPDX-License-Identifier: MIT
#include "render/layer/surroundings.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>

namespace frostfill
{
namespace
{

/// Lengths are in the radius of the sphere that is lit.
/// Neighbours whose surface is further than this from it take no part of the sky from it.
constexpr float kReach = 1.6F;
/// Nor of the lamp, when they are further than this in its direction.
constexpr float kLampReach = 7;

/// By how much the lamp's light spreads on the way: it is as soft as it is large.
constexpr float kSoftness = 0.3F;

/// Of the lamp that a neighbour hides, seen from the sphere as a whole. `ahead`: towards the lamp;
/// `beside`: from the ray through the sphere's centre.
float lampHidden(float ahead, float beside, float radius)
{
    const float spread = 1 + kSoftness * ahead;
    return std::clamp((radius + spread - beside) / (2 * spread), 0.0F, 1.0F) *
           std::min(radius * radius / (spread * spread) * 1.5F, 1.0F);
}

std::int8_t toByte(float share)
{
    return static_cast<std::int8_t>(std::lround(127 * std::clamp(share, -1.0F, 1.0F)));
}

} // namespace

Surroundings::Surroundings(const glm::vec3& towardsLamp, const std::optional<CutPlanes>& cut)
    : lamp_(towardsLamp), cut_(cut)
{
}

glm::ivec3 Surroundings::placeOf(const glm::vec3& point) const
{
    return glm::ivec3(glm::floor(glm::clamp(point / cell_, glm::vec3(-1e6F), glm::vec3(1e6F))));
}

std::uint32_t Surroundings::cellOf(const glm::ivec3& place) const
{
    const std::uint32_t hash = static_cast<std::uint32_t>(place.x) * 73856093U ^
                               static_cast<std::uint32_t>(place.y) * 19349663U ^
                               static_cast<std::uint32_t>(place.z) * 83492791U;
    return hash & static_cast<std::uint32_t>(heads_.size() - 1);
}

void Surroundings::rebuild()
{
    cell_ = std::max(2 * largest_, 1e-6F);
    heads_.assign(std::bit_ceil(std::max<std::size_t>(2 * spheres_.size(), 1024)), 0);
    nexts_.assign(spheres_.size(), 0);
    for (std::size_t i = 0; i < spheres_.size(); ++i)
    {
        const SphereInstance& sphere = spheres_[i];
        std::uint32_t& head = heads_[cellOf(placeOf({sphere.x, sphere.y, sphere.z}))];
        nexts_[i] = head;
        head = static_cast<std::uint32_t>(i + 1);
    }
}

void Surroundings::start(std::span<const SphereInstance> resting)
{
    spheres_.clear();
    heads_.clear();
    nexts_.clear();
    lights_.clear();
    known_.clear();
    cutAway_.clear();
    largest_ = 0;
    for (const SphereInstance& sphere : resting)
    {
        push(sphere);
    }
}

void Surroundings::add(const SphereInstance& sphere)
{
    push(sphere);
    if (!cutAway_.back())
    {
        forgetLightAround(sphere);
    }
}

void Surroundings::push(const SphereInstance& sphere)
{
    const glm::dvec4 centre(sphere.x, sphere.y, sphere.z, 1);
    cutAway_.push_back(cut_ && glm::dot((*cut_)[0], centre) > 0 &&
                       glm::dot((*cut_)[1], centre) > 0);
    spheres_.push_back(sphere);
    lights_.emplace_back();
    known_.push_back(Known::nothing);
    if (sphere.radius > largest_ || spheres_.size() > heads_.size())
    {
        largest_ = std::max(largest_, 1.2F * sphere.radius);
        rebuild();
        return;
    }
    std::uint32_t& head = heads_[cellOf(placeOf(glm::vec3(centre)))];
    nexts_.push_back(head);
    head = static_cast<std::uint32_t>(spheres_.size());
}

template <typename Visit>
void Surroundings::eachIn(const glm::vec3& lowest, const glm::vec3& highest, Visit visit) const
{
    const glm::ivec3 low = placeOf(lowest);
    const glm::ivec3 high = placeOf(highest);
    for (int z = low.z; z <= high.z; ++z)
    {
        for (int y = low.y; y <= high.y; ++y)
        {
            for (int x = low.x; x <= high.x; ++x)
            {
                const glm::ivec3 place(x, y, z);
                for (std::uint32_t i = heads_[cellOf(place)]; i != 0; i = nexts_[i - 1])
                {
                    const SphereInstance& other = spheres_[i - 1];
                    if (placeOf({other.x, other.y, other.z}) == place)
                    {
                        visit(i - 1);
                    }
                }
            }
        }
    }
}

std::size_t Surroundings::indexOf(const SphereInstance& sphere) const
{
    std::size_t found = spheres_.size();
    const glm::vec3 centre(sphere.x, sphere.y, sphere.z);
    const auto look = [&](std::uint32_t i)
    {
        const SphereInstance& other = spheres_[i];
        if (other.x == sphere.x && other.y == sphere.y && other.z == sphere.z &&
            other.radius == sphere.radius)
        {
            found = i;
        }
    };
    if (!spheres_.empty())
    {
        eachIn(centre, centre, look);
    }
    return found;
}

void Surroundings::forgetLightAround(const SphereInstance& arrival)
{
    // The other way round than in collect: who would find this one there.
    const glm::vec3 centre(arrival.x, arrival.y, arrival.z);
    const glm::vec3 reach((1 + kReach) * largest_ + arrival.radius);
    const glm::vec3 along = centre - kLampReach * largest_ * lamp_;
    const glm::vec3 beside((1 + kSoftness * kLampReach) * largest_ + arrival.radius);
    eachIn(glm::min(centre - reach, along - beside), glm::max(centre + reach, along + beside),
           [&](std::uint32_t i)
           {
               if (known_[i] == Known::now && reaches(arrival, spheres_[i]))
               {
                   known_[i] = Known::before;
               }
           });
}

void Surroundings::collect(const SphereInstance& sphere)
{
    near_.clear();
    const glm::vec3 centre(sphere.x, sphere.y, sphere.z);
    const glm::vec3 reach((1 + kReach) * sphere.radius + largest_);
    const glm::vec3 along = centre + kLampReach * sphere.radius * lamp_;
    const glm::vec3 beside((1 + kSoftness * kLampReach) * sphere.radius + largest_);
    const auto meet = [&](const SphereInstance& other)
    {
        const glm::vec3 way = (glm::vec3(other.x, other.y, other.z) - centre) / sphere.radius;
        const float radius = other.radius / sphere.radius;
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
        const float wide = 1 + radius + kSoftness * std::max(ahead, 0.0F);
        if (ahead > 0 && ahead < kLampReach && besideSquared < wide * wide)
        {
            weight += 0.5F * radius * radius / (1 + ahead);
        }
        if (weight > 0)
        {
            near_.push_back({weight, way, radius});
        }
    };
    eachIn(glm::min(centre - reach, along - beside), glm::max(centre + reach, along + beside),
           [&](std::uint32_t i)
           {
               if (!cutAway_[i])
               {
                   meet(spheres_[i]);
               }
           });
    std::sort(near_.begin(), near_.end(),
              [](const Neighbour& a, const Neighbour& b)
              {
                  return std::tie(b.weight, a.way.x, a.way.y, a.way.z) <
                         std::tie(a.weight, b.way.x, b.way.y, b.way.z);
              });
}

SphereLight Surroundings::of(const SphereInstance& sphere)
{
    const std::size_t own = indexOf(sphere);
    return own == spheres_.size() ? lightOn(sphere) : keptLight(own);
}

const SphereLight& Surroundings::keptLight(std::size_t index)
{
    if (known_[index] != Known::now)
    {
        lights_[index] = lightOn(spheres_[index]);
        known_[index] = Known::now;
    }
    return lights_[index];
}

bool Surroundings::hasChanged(const SphereInstance& sphere)
{
    const std::size_t own = indexOf(sphere);
    if (own == spheres_.size() || known_[own] == Known::now)
    {
        return false;
    }
    const bool hadNone = known_[own] == Known::nothing;
    const SphereLight before = lights_[own];
    return keptLight(own) != before || hadNone;
}

SphereLight Surroundings::lightOn(const SphereInstance& sphere)
{
    SphereLight light;
    if (spheres_.empty())
    {
        return light;
    }
    collect(sphere);
    const std::size_t listed = std::min(near_.size(), light.occluders.size());
    for (std::size_t i = 0; i < listed; ++i)
    {
        const Neighbour& near = near_[i];
        // What is too large to be told is brought nearer: it hides as much.
        const float size = std::max({std::abs(near.way.x), std::abs(near.way.y),
                                     std::abs(near.way.z), near.radius, kOccluderRange});
        light.occluders[i] = {toByte(near.way.x / size), toByte(near.way.y / size),
                              toByte(near.way.z / size), toByte(near.radius / size)};
    }
    float sky = 1;
    float lamp = 1;
    for (std::size_t i = listed; i < near_.size(); ++i)
    {
        const Neighbour& near = near_[i];
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

bool Surroundings::reaches(const SphereInstance& from, const SphereInstance& to) const
{
    const glm::vec3 way(from.x - to.x, from.y - to.y, from.z - to.z);
    const float squared = glm::dot(way, way);
    const float near = (1 + kReach) * to.radius + from.radius;
    if (squared < near * near * 1.0001F)
    {
        return true;
    }
    const float ahead = glm::dot(way, lamp_);
    const float wide = to.radius + from.radius + kSoftness * ahead;
    return ahead > 0 && ahead < kLampReach * to.radius * 1.0001F &&
           squared - ahead * ahead < wide * wide * 1.0001F;
}

} // namespace frostfill
