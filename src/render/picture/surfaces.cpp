// SPDX-License-Identifier: MIT
#include "render/picture/surfaces.hpp"

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

} // namespace frostfill
