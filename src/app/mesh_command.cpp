// SPDX-License-Identifier: MIT
#include "app/commands.hpp"
#include "app/load_effects.hpp"
#include "app/scene_options.hpp"
#include "app/text/reach_text.hpp"

#include <frostfill/error.hpp>
#include <frostfill/mesh.hpp>

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
)";

struct MeshArguments
{
    std::string mesh;
    std::string repaired;
    GivenOptions load;
    double radius = 0; ///< of spheres whose reach is asked for; 0 for none
};

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
                   "walls inside the object are obstacles, which --unite removes\n",
                   report.crossedTriangles, report.firstCrossing.x(), report.firstCrossing.y(),
                   report.firstCrossing.z());
    }
    if (!report.closed())
    {
        fmt::print("  first at    {:.6g} {:.6g} {:.6g}\n", report.firstDefect.x(),
                   report.firstDefect.y(), report.firstDefect.z());
    }
}

int inspect(const MeshArguments& arguments)
{
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
    const std::string hint = scene.object.load.cavity ? "" : cavityHint(loaded.mesh, loaded.report);
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
    command
        ->add_option("FILE", arguments->mesh,
                     "A mesh file, or torus, sphere, cube, human, cylinder:1,4, ...")
        ->required();
    command
        ->add_option("--radius", arguments->radius,
                     "Show the parts that spheres of this radius cannot reach, and leaks")
        ->check(CLI::Range(1e-12, 1e12))
        ->type_name("R");
    addLoadOptions(*command, arguments->load);
    command->add_option("--repair", arguments->repaired, "Write the repaired mesh to this PLY file")
        ->type_name("OUT");
    return [arguments] { return inspect(*arguments); };
}

} // namespace frostfill
