// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace frostfill
{

/// A name of letters, digits and _, as programs take it for a patch; it does not begin with a digit
/// and is none that exports give to something else.
[[nodiscard]] std::string wordOfPatch(std::string_view name);

/// Finds the patches of a mesh again after its repair: sorts the triangles of `loaded`, but for its
/// lids, by the patch of the triangle as it was read that is nearest to their middle. `read` is the
/// mesh as it was read, in `patches`, which may have the same name.
void findPatchesAgain(LoadedMesh& loaded, const TriangleMesh& read,
                      const std::vector<MeshPatch>& patches);

} // namespace frostfill
