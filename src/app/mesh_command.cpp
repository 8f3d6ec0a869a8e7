// SPDX-License-Identifier: MIT
#include "app/commands.hpp"
#include "app/scene_options.hpp"
#include "app/text/result_text.hpp"

#include <frostfill/error.hpp>
#include <frostfill/mesh.hpp>
#include <frostfill/volume_estimate.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>

namespace frostfill
{
namespace
{

constexpr const char* kMeshExamples = R"(Examples:
  frostfill mesh torus
  frostfill mesh human --radius 0.05           parts that such spheres cannot reach
  frostfill mesh bunny.obj --repair bunny.ply
  frostfill mesh bust.stl --lid --repair bust.ply
  frostfill mesh bunny.obj --estimate-volume   by filling it, beside that of the triangles
)";

struct MeshArguments
{
    std::string mesh;
    std::string repaired;
    GivenOptions load;
    double radius = 0; ///< of spheres whose reach is asked for; 0 for none
    bool estimateVolume = false;
};

/// Fills the mesh with spheres, and with spheres half as large.
int printVolume(const MeshArguments& arguments)
{
    Scene scene = presetScene(Preset::fast, arguments.mesh);
    applyGivenOptions(arguments.load, scene);
    scene.motion.mode = Motion::descend; // the fastest, as no frames are drawn
    if (arguments.radius > 0)
    {
        scene.spheres.radius = arguments.radius;
    }
    const VolumeEstimate estimate = estimateVolume(scene);
    fmt::print(
        "volume {:.5g} +- {:.2g}, from {} spheres of radius {:.5g} and {} of half that radius\n",
        estimate.volume, estimate.error, estimate.coarse, estimate.radius, estimate.fine);
    fmt::print("the mesh has {:.5g}; the estimate differs by {:+.2f} %\n", estimate.meshVolume,
               100 * (estimate.volume / estimate.meshVolume - 1));
    return 0;
}

void printReport(const std::string& name, const MeshReport& report)
{
    const Eigen::Vector3d size = report.box.sizes();
    fmt::print("{}: {} triangles, {} vertices, {} {}\n", name, report.triangles, report.vertices,
               report.components, report.components == 1 ? "piece" : "pieces");
    if (report.triangles == 0)
    {
        return;
    }
    fmt::print("  size        {:.6g} x {:.6g} x {:.6g}\n", size.x(), size.y(), size.z());
    fmt::print("  area        {:.6g}\n", report.area);
    fmt::print("  closed      {}\n", report.closed() ? "yes" : "no");
    if (report.closed())
    {
        fmt::print("  volume      {:.6g}\n  genus       {}\n", report.volume, report.genus);
    }

    const auto defect = [](const char* what, std::size_t count)
    {
        if (count > 0)
        {
            fmt::print("  defect      {}: {}\n", what, count);
        }
    };
    defect("edges at a hole", report.boundaryEdges);
    defect("edges with more than two triangles", report.unbalancedEdges);
    defect("edges whose triangles are wound against each other", report.inconsistentEdges);
    defect("triangles without area", report.degenerateTriangles);
    defect("duplicate triangles", report.duplicateTriangles);
    defect("unused vertices", report.unusedVertices);
    if (report.crossedTriangles > 0)
    {
        fmt::print("  crossings   {} triangles meet others, the first near {:.6g} {:.6g} {:.6g}; "
                   "walls inside the object are obstacles, which --set object.unite=true "
                   "removes\n",
                   report.crossedTriangles, report.firstCrossing.x(), report.firstCrossing.y(),
                   report.firstCrossing.z());
    }
    if (!report.closed())
    {
        fmt::print("  first at    {:.6g} {:.6g} {:.6g}\n", report.firstDefect.x(),
                   report.firstDefect.y(), report.firstDefect.z());
    }
}

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

/// A line each for --lid, --wrap and object.unite: what it would make of a mesh, in volume and
/// surface. Empty for a mesh that is closed and does not meet itself. `asRead` is its inspection.
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
    { text += open || what != kMissing ? fmt::format("  with {:<31}{}\n", option, what) : ""; };
    add("--lid", open ? effect(mesh, name, {.lid = true}) : "changes nothing: nothing is open");
    add("--wrap auto", effect(mesh, name, {.wrap = 0.0}));
    add(open ? "--lid --set object.unite=true" : "--set object.unite=true",
        effect(mesh, name, {.lid = open, .unite = true}));
    return text;
}

int inspect(const MeshArguments& arguments)
{
    if (arguments.estimateVolume)
    {
        return printVolume(arguments);
    }
    std::vector<std::string> remarks;
    TriangleMesh mesh = isBuiltInMesh(arguments.mesh) ? builtInMesh(arguments.mesh)
                                                      : readMeshSandboxed(arguments.mesh, &remarks);
    MeshReport asRead = inspectMesh(mesh);
    if (asRead.closed())
    {
        asRead = inspectInterior(mesh, asRead);
    }
    printReport(arguments.mesh, asRead);
    for (const std::string& remark : remarks)
    {
        fmt::print("  reading     {}\n", remark);
    }
    if (arguments.radius > 0 && !asRead.closed() && asRead.triangles > 0)
    {
        fmt::print("before repair, {}", reachText(inspectReach(mesh, arguments.radius),
                                                  arguments.radius, asRead.volume));
    }
    Scene scene;
    applyGivenOptions(arguments.load, scene);
    if (arguments.load.empty())
    {
        fmt::print("{}", loadEffectsText(mesh, asRead, arguments.mesh));
    }
    // Throws with the reason when the mesh cannot be filled.
    const LoadedMesh loaded = repairMesh(std::move(mesh), arguments.mesh, scene.object.load);
    for (const std::string& repair : loaded.repairs)
    {
        fmt::print("  repair      {}\n", repair);
    }
    if (!loaded.repairs.empty())
    {
        printReport("after repair", inspectInterior(loaded.mesh, loaded.report));
    }
    fmt::print("can be filled\n");
    const std::string hint = cavityHint(arguments.mesh, scene.object.load, loaded);
    fmt::print("{}{}", hint, hint.empty() ? "" : "\n");
    if (arguments.radius > 0)
    {
        fmt::print("{}", reachText(inspectReach(loaded.mesh, arguments.radius), arguments.radius,
                                   loaded.report.volume));
    }
    if (!arguments.repaired.empty())
    {
        savePly(loaded.mesh, arguments.repaired);
        fmt::print("written to {}\n", arguments.repaired);
    }
    return 0;
}

} // namespace

Command addMeshCommand(CLI::App& program)
{
    const auto arguments = std::make_shared<MeshArguments>();
    CLI::App* command = program.add_subcommand(
        "mesh", "Inspect a mesh: whether it can be filled, and what is repaired");
    command->footer(kMeshExamples);
    addMeshArgument(
        *command, "FILE", arguments->mesh,
        "A mesh file, several or a folder with its patches, or torus, cylinder:1,4, ...")
        ->required();
    command
        ->add_option("--radius", arguments->radius,
                     "Show the parts that spheres of this radius cannot reach")
        ->check(CLI::Range(1e-12, 1e12))
        ->type_name("R");
    addSceneOptions(*command, arguments->load);
    command->add_flag("--estimate-volume", arguments->estimateVolume,
                      "Estimate the volume by filling the mesh with spheres (of --radius)");
    command->add_option("--repair", arguments->repaired, "Write the repaired mesh to this PLY file")
        ->type_name("OUT");
    return [arguments] { return inspect(*arguments); };
}

} // namespace frostfill
