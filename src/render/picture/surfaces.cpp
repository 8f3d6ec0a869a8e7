// SPDX-License-Identifier: MIT
#include "render/picture/surfaces.hpp"

#include <frostfill/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace frostfill
{

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
    }
    return spheres;
}

DepthLimits depthLimits(const glm::dmat4& projection, bool orthographic)
{
    const double a = projection[2][2];
    const double b = projection[3][2];
    return orthographic ? DepthLimits{(b + 1) / a, (b - 1) / a}
                        : DepthLimits{b / (a - 1), b / (a + 1)};
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
        image->pixels.resize(3 * count);
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
            pictures.identity.pixels[3 * i + c] =
                static_cast<std::uint8_t>(surfaces.identity[i] >> (8 * c));
        }
    }
}

} // namespace frostfill
