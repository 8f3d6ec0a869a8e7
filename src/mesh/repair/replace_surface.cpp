// SPDX-License-Identifier: MIT
#include "mesh/repair/replace_surface.hpp"

#include "mesh/interior/walls.hpp"
#include "mesh/repair/clean_mesh.hpp"
#include "mesh/skin/wrap_program.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

namespace frostfill
{
namespace
{

/// [1] Volume over area of a skin, over the offset, below which it is about walls only. A skin
/// about a flat sheet has 1; about the Stanford bunny, whose holes it goes through, 2.8; about
/// walls of thickness t 1 + t / (2 offset). Less: hollow shells count as solids. More: thin solids
/// do not.
constexpr double kSheetOfSkin = 3.5;

} // namespace

void wrapMesh(TriangleMesh& mesh, double alpha, std::string_view name,
              std::vector<std::string>& repairs)
{
    alpha = alpha > 0 ? alpha : boundingBox(mesh).diagonal().norm() / 50;
    const double offset = kOffsetOverAlpha * alpha;
    TriangleMesh skin = makeSkin(mesh, alpha, offset, name);
    const double volume = signedVolume(skin);
    if (!(volume > kSheetOfSkin * offset * surfaceArea(skin)))
    {
        throw Error(ErrorCode::badData,
                    fmt::format("'{}' cannot be filled: a skin around it encloses only the mesh's "
                                "own walls (alpha {:.4g}); give --lid too, or a larger --wrap if "
                                "its openings are wider than {:.4g}",
                                name, alpha, 2 * alpha));
    }
    repairs.push_back(fmt::format("put a skin around it: alpha {:.4g}, offset {:.4g}, {} triangles "
                                  "in place of {}",
                                  alpha, offset, skin.triangles.size(), mesh.triangles.size()));
    mesh = std::move(skin);
}

void unite(TriangleMesh& mesh, std::string_view name, std::vector<std::string>& repairs)
{
    if (classifyWalls(mesh).none())
    {
        return;
    }
    const double before = surfaceArea(mesh);
    TriangleMesh whole = makeUnion(mesh, name);
    dropFlatTriangles(whole); // rounding leaves some
    if (!inspectMesh(whole).closed())
    {
        throw Error(ErrorCode::badData,
                    fmt::format("'{}' cannot be united: its parts meet at angles too small for "
                                "double precision; unite them in a mesh editor",
                                name));
    }
    repairs.push_back(fmt::format("removed the walls inside the union: area {:.6g} in place of "
                                  "{:.6g}",
                                  surfaceArea(whole), before));
    mesh = std::move(whole);
}

} // namespace frostfill
