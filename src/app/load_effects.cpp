// SPDX-License-Identifier: MIT
#include "app/load_effects.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

namespace frostfill
{
namespace
{

constexpr const char* kMissing = "the program frostfill-wrap is missing (docs/meshes.md)";

/// Of what comes out; or why nothing does.
std::string effect(const TriangleMesh& mesh, const std::string& name,
                   const LoadMeshOptions& options)
{
    try
    {
        const LoadedMesh loaded = repairMesh(mesh, name, options);
        const MeshReport report = inspectInterior(loaded.mesh, loaded.report);
        return fmt::format("volume {:.6g}, area {:.6g}", report.volume, report.area);
    }
    catch (const Error& error)
    {
        if (error.code() == ErrorCode::missingProgram)
        {
            return kMissing;
        }
        return fmt::format("refused: {}", error.what());
    }
}

} // namespace

std::string loadEffectsText(const TriangleMesh& mesh, const MeshReport& asRead,
                            const std::string& name)
{
    if (asRead.triangles == 0 || (asRead.closed() && asRead.crossedTriangles == 0))
    {
        return "";
    }
    const bool open = !asRead.closed();
    std::string text;
    // A closed mesh can be filled without the program.
    const auto add = [&](const char* option, const std::string& what)
    { text += open || what != kMissing ? fmt::format("  with {:<14}{}\n", option, what) : ""; };
    add("--lid", open ? effect(mesh, name, {.lid = true}) : "changes nothing: nothing is open");
    add("--wrap", effect(mesh, name, {.wrap = 0.0}));
    add(open ? "--lid --unite" : "--unite", effect(mesh, name, {.lid = open, .unite = true}));
    return text;
}

} // namespace frostfill
