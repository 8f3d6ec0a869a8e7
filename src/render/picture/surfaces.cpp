// SPDX-License-Identifier: MIT
#include "render/picture/surfaces.hpp"

#include <frostfill/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace frostfill
{

void Surfaces::resize(const PictureSize& size)
{
    width = size.width;
    height = size.height;
    const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    distance.resize(pixels);
    normal.resize(pixels);
    identity.resize(pixels);
}

void Surfaces::set(int x, int y, float inDistance, std::uint32_t withNormal, std::uint32_t ofSphere)
{
    const auto to = static_cast<std::size_t>(height - 1 - y) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(x);
    distance[to] = inDistance;
    normal[to] = {static_cast<std::uint8_t>(withNormal), static_cast<std::uint8_t>(withNormal >> 8),
                  static_cast<std::uint8_t>(withNormal >> 16)};
    identity[to] = ofSphere;
}

std::vector<SphereInstance> placeSpheres(const Snapshot& snapshot, const Framing& framing)
{
    const Eigen::Vector3f offset =
        ((snapshot.origin - framing.centre) * framing.scale).cast<float>();
    const auto scale = static_cast<float>(framing.scale);
    std::vector<SphereInstance> spheres;
    spheres.reserve(snapshot.centres.size());
    for (std::size_t i = 0; i < snapshot.centres.size(); ++i)
    {
        const Eigen::Vector3f centre = snapshot.centres[i] * scale + offset;
        spheres.push_back({centre.x(),
                           centre.y(),
                           centre.z(),
                           snapshot.waits(i) ? 0 : snapshot.radii[i] * scale,
                           static_cast<std::uint32_t>(snapshot.states[i]),
                           {}});
        for (std::size_t c = 0; c < 4; ++c)
        {
            spheres.back().colour[c] = static_cast<std::uint8_t>((i + 1) >> (8 * c));
        }
    }
    return spheres;
}

void makePassPictures(const Surfaces& surfaces, const Framing& framing, PassPictures& pictures)
{
    constexpr double kFurthest = 65534;
    constexpr std::uint32_t kLargestIdentity = 0xffffff;
    const DepthLimits limits = depthLimits(framing.projection, framing.orthographic);
    pictures.nearest = limits.nearest / framing.scale;
    pictures.furthest = limits.furthest / framing.scale;
    const std::size_t count = surfaces.distance.size();
    pictures.depth.width = surfaces.width;
    pictures.depth.height = surfaces.height;
    pictures.depth.channels = 2;
    pictures.depth.pixels.resize(2 * count);
    for (Image* image : {&pictures.normal, &pictures.identity})
    {
        image->width = surfaces.width;
        image->height = surfaces.height;
        image->channels = 3;
        image->pixels.resize(image == &pictures.identity && !pictures.withIdentity ? 0 : 3 * count);
    }
    for (std::size_t i = 0; i < count; ++i)
    {
        if (pictures.withIdentity && surfaces.identity[i] > kLargestIdentity)
        {
            throw Error(ErrorCode::usage,
                        fmt::format("the pass identity tells {} spheres apart, and sphere {} is "
                                    "seen: omit identity from frames.passes",
                                    kLargestIdentity, surfaces.identity[i] - 1));
        }
        const bool seen = surfaces.distance[i] != Surfaces::kNothing;
        const double share =
            (double{surfaces.distance[i]} - limits.nearest) / (limits.furthest - limits.nearest);
        const long depth = seen ? std::lround(kFurthest * std::clamp(share, 0.0, 1.0)) : 65535;
        pictures.depth.pixels[2 * i] = static_cast<std::uint8_t>(depth >> 8);
        pictures.depth.pixels[2 * i + 1] = static_cast<std::uint8_t>(depth & 255);
        for (std::size_t c = 0; c < 3; ++c)
        {
            pictures.normal.pixels[3 * i + c] = seen ? surfaces.normal[i][c] : std::uint8_t{128};
            if (pictures.withIdentity)
            {
                pictures.identity.pixels[3 * i + c] =
                    static_cast<std::uint8_t>(surfaces.identity[i] >> (8 * c));
            }
        }
    }
}

} // namespace frostfill
