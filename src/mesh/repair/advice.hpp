// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <string>
#include <string_view>

namespace frostfill
{

/// Whether the interior of a closed mesh has a volume. `report` is that of inspectMesh.
[[nodiscard]] bool hasVolume(const TriangleMesh& mesh, const MeshReport& report);

/// Which options would make a mesh, as far as it is repaired, one that can be filled, with the
/// command to type: "give --lid (frostfill fill tub.obj --lid), or ". Empty if none would. Those
/// that are given already are not named.
[[nodiscard]] std::string optionsThatHelp(const TriangleMesh& mesh, std::string_view name,
                                          const LoadMeshOptions& given);

} // namespace frostfill
