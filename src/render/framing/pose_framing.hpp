// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/framing.hpp"

#include <frostfill/snapshot.hpp>

#include <vector>

namespace frostfill
{

/// The mesh's vertices in all poses that have to fit into the picture; as they are without poses.
[[nodiscard]] std::vector<Eigen::Vector3d> verticesInPoses(const std::vector<Eigen::Vector3d>& mesh,
                                                           const std::vector<Pose>& poses);

/// What the camera sees when the object has moved into a pose about `origin` [mesh coordinates]:
/// the same as if the camera had moved the other way round it.
[[nodiscard]] Framing posed(const Framing& framing, const Pose& pose,
                            const Eigen::Vector3d& origin);

} // namespace frostfill
