// SPDX-License-Identifier: MIT
#include "app/text/result_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace frostfill
{
namespace
{

constexpr std::size_t kMaxParts = 5;

} // namespace

std::string reachText(const ReachInspection& reach, double radius, double volume)
{
    if (!reach.known)
    {
        return fmt::format(
            "reach of radius {:.5g}: not examined, the object is too large for this radius\n",
            radius);
    }
    if (!reach.fits)
    {
        return fmt::format("reach: no sphere of radius {:.5g} fits; choose a smaller radius\n",
                           radius);
    }
    std::string text =
        fmt::format("reach: at least {:.3g} % of the volume is too narrow for radius "
                    "{:.5g}, {} {} larger than a sphere\n",
                    100 * reach.unreachable / volume, radius, reach.parts.size(),
                    reach.parts.size() == 1 ? "part" : "parts");
    for (std::size_t k = 0; k < std::min(kMaxParts, reach.parts.size()); ++k)
    {
        const UnreachableVolume& part = reach.parts[k];
        const Eigen::Vector3d size = part.box.sizes();
        text += fmt::format("  out of reach: volume {:.4g} about {:.5g} {:.5g} {:.5g}, within "
                            "{:.3g} x {:.3g} x {:.3g}\n",
                            part.volume, part.centre.x(), part.centre.y(), part.centre.z(),
                            size.x(), size.y(), size.z());
    }
    if (reach.parts.size() > kMaxParts)
    {
        text += fmt::format("  and {} more\n", reach.parts.size() - kMaxParts);
    }
    return text;
}

std::string describe(const ShellInFile& shell)
{
    if (shell.triangles == 0 || shell.triangles == shell.meshTriangles)
    {
        return "";
    }
    return fmt::format("; the shell has {} of {} triangles and is within {:.2g} of the mesh "
                       "(--full-mesh keeps all)",
                       shell.triangles, shell.meshTriangles, shell.distance);
}

} // namespace frostfill
