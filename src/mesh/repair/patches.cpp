// SPDX-License-Identifier: MIT
#include "mesh/interior/triangle_bvh.hpp"
#include "mesh/repair/repair_steps.hpp"
#include "mesh/triangle_shape.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace frostfill
{

std::string wordOfPatch(std::string_view name)
{
    std::string word;
    for (const char c : name)
    {
        const bool isKept =
            (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        word += isKept ? c : '_';
    }
    constexpr std::array<std::string_view, 3> kTaken = {"spheres", "background", "lids"};
    if (word.empty() || (word[0] >= '0' && word[0] <= '9') ||
        std::find(kTaken.begin(), kTaken.end(), word) != kTaken.end())
    {
        word = "patch_" + word;
    }
    return word;
}

void findPatchesAgain(LoadedMesh& loaded, const TriangleMesh& read,
                      const std::vector<MeshPatch>& patches)
{
    std::vector<std::size_t> patchOf; // of the triangles as read
    loaded.patches.clear();
    for (const MeshPatch& patch : patches)
    {
        const std::string name = wordOfPatch(patch.name);
        const auto known = std::find_if(loaded.patches.begin(), loaded.patches.end(),
                                        [&](const MeshPatch& other) { return other.name == name; });
        const auto number = static_cast<std::size_t>(known - loaded.patches.begin());
        if (known == loaded.patches.end())
        {
            loaded.patches.push_back({name, 0});
        }
        patchOf.resize(std::min(patchOf.size() + patch.triangles, read.triangles.size()), number);
    }
    if (loaded.patches.size() < 2 || patchOf.size() != read.triangles.size())
    {
        loaded.patches.clear();
        return;
    }
    const TriangleBvh tree(read);
    std::vector<std::vector<Triangle>> sorted(loaded.patches.size());
    std::vector<Triangle>& triangles = loaded.mesh.triangles;
    const std::size_t walls = triangles.size() - loaded.lidTriangles;
    for (std::size_t t = 0; t < walls; ++t)
    {
        const auto [a, b, c] = cornersOf(loaded.mesh, t);
        const auto place =
            nearestPoint(read, tree, (a + b + c) / 3, std::numeric_limits<double>::infinity());
        sorted[place ? patchOf[place->triangle] : 0].push_back(triangles[t]);
    }
    auto to = triangles.begin();
    for (std::size_t k = 0; k < sorted.size(); ++k)
    {
        loaded.patches[k].triangles = sorted[k].size();
        to = std::copy(sorted[k].begin(), sorted[k].end(), to);
    }
    std::erase_if(loaded.patches, [](const MeshPatch& patch) { return patch.triangles == 0; });
}

} // namespace frostfill
