// SPDX-License-Identifier: MIT
#include "bed/sphere_shape.hpp"

#include "mesh/geodesic_sphere.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace frostfill
{
namespace
{

constexpr std::uint32_t kFewestCorners = 8;
constexpr std::uint32_t kMostCorners = 96;
/// [edge of the geodesic sphere] from a circle, within which there is no other point. Larger:
/// longer triangles around circles. Smaller: flatter ones.
constexpr double kAround = 0.5;

double angleOf(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

std::uint32_t cornersOfCircle(double wide, std::size_t resolution)
{
    const double around = 2 * std::numbers::pi * std::sin(wide) / geodesicEdge(resolution);
    return std::clamp(static_cast<std::uint32_t>(std::ceil(around)), kFewestCorners, kMostCorners);
}

/// On a unit sphere, about a direction. The second sphere of a bridge sees the corners of the first
/// turning the other way.
Eigen::Vector3d onCircle(const Eigen::Vector3d& direction, const Eigen::Vector3d& axis, double wide,
                         std::uint32_t corner, std::uint32_t corners)
{
    const Eigen::Vector3d e1 = axis.unitOrthogonal();
    const Eigen::Vector3d e2 = axis.cross(e1);
    const double turn = 2 * std::numbers::pi * corner / corners;
    return std::cos(wide) * direction +
           std::sin(wide) * (std::cos(turn) * e1 + std::sin(turn) * e2);
}

} // namespace

std::uint32_t cornersOf(const Bed& bed, const BedLink& link)
{
    const double smaller = std::min(bed.radius(link.first), bed.radius(link.second));
    return cornersOfCircle(std::asin(link.bridge / smaller), bed.settings().resolution);
}

Eigen::Vector3d cornerOf(const Bed& bed, const BedLink& link, std::uint32_t sphere,
                         std::uint32_t corner, std::uint32_t corners)
{
    const Eigen::Vector3d direction =
        sphere == link.first ? link.direction : Eigen::Vector3d(-link.direction);
    return onCircle(direction, link.direction, std::asin(link.bridge / bed.radius(sphere)), corner,
                    corners);
}

Eigen::Vector3f cornerInWorld(const Bed& bed, const BedLink& link, std::uint32_t sphere,
                              std::uint32_t corner, std::uint32_t corners)
{
    return inSinglePrecision(bed.centre(sphere) +
                             bed.radius(sphere) * cornerOf(bed, link, sphere, corner, corners));
}

double SphereShape::wide(std::uint32_t sphere, std::uint32_t link) const
{
    const BedLink& its = links_.links[link];
    return its.bridge > 0 ? std::asin(its.bridge / bed_.radius(sphere))
                          : std::acos(std::min(1.0, cutOf(bed_, its, sphere)));
}

bool SphereShape::hasRoom(std::uint32_t sphere, std::uint32_t link, double own) const
{
    const auto isApart = [&](std::uint32_t other)
    {
        return other == link ||
               own + wide(sphere, other) <
                   0.9 * angleOf(links_.direction(link, sphere), links_.direction(other, sphere));
    };
    const std::vector<std::uint32_t>& others = links_.ofSphere[sphere];
    return std::all_of(others.begin(), others.end(), isApart);
}

void SphereShape::addCircle(std::uint32_t sphere, std::uint32_t link, bool isBridge)
{
    const BedLink& its = links_.links[link];
    const double own = wide(sphere, link);
    const Eigen::Vector3d direction = links_.direction(link, sphere);
    const std::uint32_t corners =
        isBridge ? cornersOf(bed_, its) : cornersOfCircle(own, bed_.settings().resolution);
    const double edge =
        std::min(geodesicEdge(bed_.settings().resolution),
                 4 * std::numbers::pi * std::sin(own) / static_cast<double>(corners));
    for (std::uint32_t corner = 0; corner < corners; ++corner)
    {
        points_.push_back(isBridge ? cornerOf(bed_, its, sphere, corner, corners)
                                   : onCircle(direction, its.direction, own, corner, corners));
        circleOf_.push_back(static_cast<std::uint32_t>(circles_.size()));
    }
    circles_.push_back({direction, std::cos(own + kAround * edge), isBridge ? link : kFlat});
}

/// Finds the circles, the cuts and the points of a sphere.
void SphereShape::look(std::uint32_t sphere)
{
    circles_.clear();
    cuts_.clear();
    points_.clear();
    circleOf_.clear();
    for (const std::uint32_t link : links_.ofSphere[sphere])
    {
        if (links_.links[link].bridge > 0)
        {
            addCircle(sphere, link, true);
        }
        else if (const double cut = cutOf(bed_, links_.links[link], sphere); cut < 1)
        {
            cuts_.push_back({links_.direction(link, sphere), cut});
            if (hasRoom(sphere, link, wide(sphere, link)))
            {
                addCircle(sphere, link, false);
            }
        }
    }
    for (const Eigen::Vector3d& point : geodesic_.vertices)
    {
        const auto isWithin = [&](const Circle& circle)
        { return point.dot(circle.direction) > circle.cosine; };
        if (std::none_of(circles_.begin(), circles_.end(), isWithin))
        {
            points_.push_back(point);
            circleOf_.push_back(kNoCircle);
        }
    }
}

void SphereShape::addPlain(std::uint32_t sphere, std::vector<StlTriangle>& triangles) const
{
    const double radius = bed_.treatedRadius(sphere);
    const auto place = [&](std::uint32_t vertex)
    { return inSinglePrecision(bed_.centre(sphere) + radius * geodesic_.vertices[vertex]); };
    for (const auto& triangle : geodesic_.triangles)
    {
        triangles.push_back({place(triangle[0]), place(triangle[2]), place(triangle[1])});
    }
}

void SphereShape::add(std::uint32_t sphere, std::vector<StlTriangle>& triangles)
{
    if (links_.ofSphere[sphere].empty())
    {
        addPlain(sphere, triangles);
        return;
    }
    look(sphere);
    hull_.build(points_);
    const auto place = [&](std::uint32_t vertex)
    {
        Eigen::Vector3d point = points_[vertex];
        const std::uint32_t circle = circleOf_[vertex];
        if (circle == kNoCircle || circles_[circle].link == kFlat)
        {
            double factor = 1;
            for (const Cut& cut : cuts_)
            {
                const double along = points_[vertex].dot(cut.direction);
                factor = along > cut.distance ? std::min(factor, cut.distance / along) : factor;
            }
            point *= factor;
        }
        return inSinglePrecision(bed_.centre(sphere) + bed_.radius(sphere) * point);
    };
    for (const SphereHull::Face& face : hull_.faces())
    {
        const Eigen::Vector3d& a = points_[face[0]];
        if (a.dot(points_[face[1]].cross(points_[face[2]])) <= 0)
        {
            throw std::logic_error("a sphere does not surround its centre");
        }
        const std::uint32_t circle = circleOf_[face[0]];
        if (circle != kNoCircle && circle == circleOf_[face[1]] && circle == circleOf_[face[2]] &&
            circles_[circle].link != kFlat)
        {
            continue; // a bridge begins there
        }
        triangles.push_back({place(face[0]), place(face[2]), place(face[1])});
    }
}

} // namespace frostfill
