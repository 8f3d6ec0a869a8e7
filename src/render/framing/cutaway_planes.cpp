// SPDX-License-Identifier: MIT
#include "render/framing/cutaway_planes.hpp"

#include <glm/matrix.hpp>

namespace frostfill
{

CutPlanes cutPlanes(const Cutaway& cutaway, const Framing& framing, const Eigen::Vector3d& up)
{
    if (cutaway.kind == Cutaway::Kind::plane)
    {
        const Eigen::Vector3d normal = cutaway.normal.normalized();
        const glm::dvec4 plane(normal.x(), normal.y(), normal.z(), -cutaway.offset * framing.scale);
        return {plane, plane};
    }
    // Away from either face of the wedge, into it. The faces meet in the axis through the origin.
    return {glm::dvec4(horizontalDirection(up, cutaway.from + 90), 0),
            glm::dvec4(horizontalDirection(up, cutaway.to - 90), 0)};
}

std::array<glm::vec4, 2> toEyeSpace(const CutPlanes& planes, const Framing& framing)
{
    const glm::dmat4 fromPlanes = glm::transpose(glm::inverse(framing.view));
    return {glm::vec4(fromPlanes * planes[0]), glm::vec4(fromPlanes * planes[1])};
}

} // namespace frostfill
