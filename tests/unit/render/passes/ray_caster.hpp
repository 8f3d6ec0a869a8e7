// SPDX-License-Identifier: MIT
// The textbook, in double precision: where a ray meets spheres, or what a cutaway leaves of them.
#pragma once

#include "render/framing/framing.hpp"
#include "render/picture/sphere_instance.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>

namespace frostfill::test
{

/// Pixels whose ray passes an outline this closely may go either way [pixel].
inline constexpr double kEdgeTolerance = 1e-3;

struct Ray
{
    glm::dvec3 origin, direction; ///< in unit space; direction has length 1
};

struct Hit
{
    double distance = std::numeric_limits<double>::infinity();
    double radius = 0;
    std::size_t sphere = 0;  ///< its index
    glm::dvec3 normal{0};    ///< in unit space: out of the sphere or of the cut
    bool onEdge = false;     ///< of any sphere or cut: the pixel proves nothing
    bool isDoubtful = false; ///< another one is as near: which is seen proves nothing

    [[nodiscard]] bool isThere() const { return std::isfinite(distance); }
};

class RayCaster
{
public:
    RayCaster(const Framing& framing, const PictureSize& size,
              const std::optional<CutPlanes>& cut = {})
        : size_(size), toUnit_(glm::inverse(framing.projection * framing.view)),
          pixelScale_(framing.projection[1][1] * size.height / 2 / (framing.orthographic ? 1 : 8)),
          cut_(cut)
    {
    }

    [[nodiscard]] Ray through(double x, double y) const
    {
        const glm::dvec3 near = unproject(x, y, 0);
        return {near, glm::normalize(unproject(x, y, 1) - near)};
    }
    /// Through the middle of a pixel, counted by rows from the top.
    [[nodiscard]] Ray throughPixel(std::size_t i) const
    {
        const auto width = static_cast<std::size_t>(size_.width);
        return through(static_cast<double>(i % width) + 0.5, static_cast<double>(i / width) + 0.5);
    }

    [[nodiscard]] glm::dvec3 unproject(double x, double y, double windowDepth) const
    {
        const glm::dvec4 clip(2 * x / size_.width - 1, 1 - 2 * y / size_.height,
                              2 * windowDepth - 1, 1);
        const glm::dvec4 point = toUnit_ * clip;
        return glm::dvec3(point) / point.w;
    }

    [[nodiscard]] Hit cast(const Ray& ray, std::span<const SphereInstance> spheres) const
    {
        Hit hit;
        const Taken taken = cut_ ? takenFrom(ray) : Taken{};
        for (std::size_t i = 0; i < spheres.size(); ++i)
        {
            const glm::dvec3 centre(spheres[i].x, spheres[i].y, spheres[i].z);
            const double radius = spheres[i].radius;
            const double along = glm::dot(centre - ray.origin, ray.direction);
            const double miss = glm::length(centre - ray.origin - along * ray.direction);
            hit.onEdge = hit.onEdge || isClose(miss, radius);
            if (miss >= radius)
            {
                continue;
            }
            const double half = std::sqrt(radius * radius - miss * miss);
            double distance = along - half;
            glm::dvec3 normal = (ray.origin + distance * ray.direction - centre) / radius;
            hit.onEdge = hit.onEdge || isClose(taken.from, distance) || isClose(taken.to, distance);
            if (taken.from < distance && distance < taken.to)
            {
                distance = taken.to;
                normal = taken.normal;
                hit.onEdge = hit.onEdge || isClose(distance, along + half);
            }
            if (distance >= along + half)
            {
                continue;
            }
            hit.isDoubtful = distance < hit.distance
                                 ? isClose(distance, hit.distance)
                                 : hit.isDoubtful || isClose(distance, hit.distance);
            if (distance < hit.distance)
            {
                hit.distance = distance;
                hit.radius = radius;
                hit.sphere = i;
                hit.normal = normal;
            }
        }
        return hit;
    }

private:
    /// The part of a ray on which everything is taken away, and how the cut faces at its end.
    struct Taken
    {
        double from = std::numeric_limits<double>::infinity();
        double to = -std::numeric_limits<double>::infinity();
        glm::dvec3 normal{0};
    };

    [[nodiscard]] bool isClose(double a, double b) const
    {
        // A length of 1 is at least so many pixels; the eye is some units away.
        return std::abs(a - b) * pixelScale_ < kEdgeTolerance;
    }

    [[nodiscard]] Taken takenFrom(const Ray& ray) const
    {
        Taken taken{-1e9, 1e9, {}};
        for (const glm::dvec4& plane : *cut_)
        {
            const glm::dvec3 normal(plane);
            const double slope = glm::dot(normal, ray.direction);
            const double meets = -(glm::dot(normal, ray.origin) + plane.w) / slope;
            if (slope > 0)
            {
                taken.from = std::max(taken.from, meets);
            }
            else if (meets < taken.to)
            {
                taken.to = meets;
                taken.normal = normal;
            }
        }
        return taken;
    }

    PictureSize size_;
    glm::dmat4 toUnit_;
    double pixelScale_; ///< pixels in a length of 1, at least
    std::optional<CutPlanes> cut_;
};

} // namespace frostfill::test
