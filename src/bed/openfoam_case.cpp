// SPDX-License-Identifier: MIT
#include "base/atomic_file.hpp"
#include "bed/bed_files.hpp"
#include "bed/bed_summary.hpp"
#include "bed/stl_file.hpp"
#include "mesh/interior/inside_test.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace frostfill
{
namespace
{

/// Places that are tried for one in the free space.
constexpr int kPlaces = 20000;
/// [m^2/s] of water, and the Reynolds number of a mean sphere.
constexpr double kViscosity = 1e-6;
constexpr double kReynolds = 1;

/// What places of a low-discrepancy sequence [Roberts 2018] tell of the free space.
struct FreeSpace
{
    Eigen::Vector3d place; ///< the farthest from everything; irrational, so on no face of a cell
    double cells = 0;      ///< that snappyHexMesh makes of it, about
};

/// Edge of snappyHexMesh's cells at a distance from the spheres, in edges of the first mesh: a
/// level has nCellsBetweenLevels cells at least, and that of the surface one more.
double edgeAt(double away)
{
    constexpr double kAtSpheres = 0.25; // two levels
    return away < 3 * kAtSpheres ? kAtSpheres : away < 3 * kAtSpheres + 2 * 0.5 ? 0.5 : 1;
}

FreeSpace lookAtFreeSpace(const Bed& bed)
{
    const double cell = bed.settings().cell * bed.meanDiameter();
    FreeSpace space;
    const Eigen::AlignedBox3d& box = bed.surface().box();
    const Eigen::Vector3d steps(0.8191725133961645, 0.6710436067037893, 0.5497004779019703);
    space.place = box.center();
    double clearance = 0;
    for (int k = 1; k <= kPlaces; ++k)
    {
        Eigen::Vector3d share = k * steps;
        share -= Eigen::Vector3d(share.array().floor());
        const Eigen::Vector3d p = box.min() + share.cwiseProduct(box.sizes());
        double gap = std::max(bed.meanDiameter(), 2 * cell);
        bed.levels().forEachNear(
            p, [&](double largest) { return largest + gap; },
            [&](std::uint32_t, const Eigen::Vector3d& centre, double radius)
            { gap = std::min(gap, (centre - p).norm() - radius); });
        if (gap <= 0)
        {
            continue;
        }
        const double wall = nearestDistance(bed.surface(), p, 1e300).value;
        if (wall > 0)
        {
            space.cells += box.volume() / kPlaces / std::pow(cell * edgeAt(gap / cell), 3);
        }
        if (const double free = std::min({gap, wall, bed.meanDiameter()}); free > clearance)
        {
            clearance = free;
            space.place = p;
        }
    }
    if (clearance <= 0)
    {
        throw Error(ErrorCode::badData, "no place in the container is free, which a mesh could "
                                        "begin from");
    }
    return space;
}

class Case
{
public:
    Case(const Bed& bed, std::filesystem::path folder, Files& files)
        : bed_(bed), folder_(std::move(folder)), files_(files)
    {
        for (const char* part : {"system", "constant/triSurface", "0"})
        {
            createDirectory(folder_ / part);
        }
    }

    void writeSurfaces(const BedSurface& surface, double cells)
    {
        for (std::size_t k = 0; k < bed_.patches().size(); ++k)
        {
            files_.push_back(folder_ / "constant/triSurface" / (bed_.patches()[k].name + ".stl"));
            writeStl(surface, {&k, 1}, false, files_.back());
        }
        files_.push_back(folder_ / "bed.json");
        nlohmann::ordered_json summary = surfaceSummary(surface);
        summary["estimated_cells"] = std::llround(cells);
        writeSummary(summary, files_.back());
    }

    void writeBlocks()
    {
        const double cell = bed_.settings().cell * bed_.meanDiameter();
        const Eigen::AlignedBox3d& box = bed_.surface().box();
        const Eigen::Vector3d cells = ((box.sizes().array() + 2 * cell) / cell).ceil();
        const Eigen::Vector3d low = box.center() - cells * cell / 2;
        const Eigen::Vector3d high = box.center() + cells * cell / 2;
        std::string text = "vertices\n(\n";
        for (const double z : {low.z(), high.z()})
        {
            text += fmt::format("    ({0:.9g} {2:.9g} {4:.9g})\n    ({1:.9g} {2:.9g} {4:.9g})\n"
                                "    ({1:.9g} {3:.9g} {4:.9g})\n    ({0:.9g} {3:.9g} {4:.9g})\n",
                                low.x(), high.x(), low.y(), high.y(), z);
        }
        text += fmt::format(
            ");\nblocks ( hex (0 1 2 3 4 5 6 7) ({} {} {}) simpleGrading (1 1 1) );\nedges ();\n"
            "boundary\n(\n    background\n    {{\n        type patch;\n        faces ( (0 3 2 1) "
            "(4 5 6 7) (0 1 5 4) (2 3 7 6) (1 2 6 5) (0 4 7 3) );\n    }}\n);\n",
            cells.x(), cells.y(), cells.z());
        put("system/blockMeshDict", "dictionary", text);
    }

    /// Returns the estimate of its cells.
    double writeSnappy()
    {
        std::string geometry;
        std::string surfaces;
        for (const auto& [kind, name] : bed_.patches())
        {
            geometry += fmt::format("    {0}.stl {{ type triSurfaceMesh; name {0}; }}\n", name);
            surfaces += fmt::format("        {} {{ level ({}); patchInfo {{ type {}; }} }}\n", name,
                                    kind == PatchKind::spheres ? "1 2" : "0 1",
                                    kind < PatchKind::wall ? "patch" : "wall");
        }
        const FreeSpace space = lookAtFreeSpace(bed_);
        put("system/snappyHexMeshDict", "dictionary",
            fmt::format(kSnappy, geometry, surfaces, space.place.x(), space.place.y(),
                        space.place.z()));
        return space.cells;
    }

    void writeFields()
    {
        const double speed = kReynolds * kViscosity / bed_.meanDiameter();
        // Into the space: normals of patches point out of it.
        const std::string inlet =
            fmt::format("type surfaceNormalFixedValue; refValue uniform {:.9g};", -speed);
        std::string velocities = "    background { type slip; }\n";
        std::string pressures = "    background { type zeroGradient; }\n";
        for (const auto& [kind, name] : bed_.patches())
        {
            velocities += fmt::format("    {} {{ {} }}\n", name,
                                      kind == PatchKind::inlet    ? inlet
                                      : kind == PatchKind::outlet ? "type zeroGradient;"
                                                                  : "type noSlip;");
            pressures += fmt::format("    {} {{ {} }}\n", name,
                                     kind == PatchKind::outlet ? "type fixedValue; value uniform 0;"
                                                               : "type zeroGradient;");
        }
        put("0/U", "volVectorField",
            fmt::format("dimensions [0 1 -1 0 0 0 0];\ninternalField uniform (0 0 0);\n"
                        "boundaryField\n{{\n{}}}\n",
                        velocities));
        put("0/p", "volScalarField",
            fmt::format("dimensions [0 2 -2 0 0 0 0];\ninternalField uniform 0;\n"
                        "boundaryField\n{{\n{}}}\n",
                        pressures));
    }

    void writeRest()
    {
        put("system/controlDict", "dictionary", kControl);
        put("system/fvSchemes", "dictionary", kSchemes);
        put("system/fvSolution", "dictionary", kSolution);
        put("constant/transportProperties", "dictionary",
            fmt::format("transportModel Newtonian;\nnu [0 2 -1 0 0 0 0] {:g};\n", kViscosity));
        put("constant/turbulenceProperties", "dictionary", "simulationType laminar;\n");
        putPlain("Allrun", "#!/bin/sh\ncd \"${0%/*}\" || exit 1\nset -e\nblockMesh\n"
                           "snappyHexMesh -overwrite\ncheckMesh\nsimpleFoam\n");
        std::filesystem::permissions(folder_ / "Allrun", std::filesystem::perms::owner_exec,
                                     std::filesystem::perm_options::add);
    }

private:
    void put(const std::string& file, const char* kind, const std::string& text)
    {
        const std::size_t slash = file.rfind('/');
        putPlain(file, fmt::format("FoamFile\n{{\n    version 2.0;\n    format ascii;\n    class "
                                   "{};\n    object {};\n}}\n\n{}",
                                   kind, file.substr(slash + 1), text));
    }
    void putPlain(const std::string& file, const std::string& text)
    {
        files_.push_back(folder_ / file);
        AtomicFile out(files_.back());
        out.write(text);
        out.commit();
    }

    // The settings of OpenFOAM's tutorials for meshes without layers.
    static constexpr const char* kSnappy = R"(castellatedMesh true;
snap true;
addLayers false;

geometry
{{
{}}}

castellatedMeshControls
{{
    maxLocalCells 100000000;
    maxGlobalCells 200000000;
    minRefinementCells 10;
    maxLoadUnbalance 0.10;
    nCellsBetweenLevels 2;
    features ();
    refinementSurfaces
    {{
{}    }}
    resolveFeatureAngle 30;
    refinementRegions {{}}
    locationInMesh ({:.9g} {:.9g} {:.9g});
    allowFreeStandingZoneFaces true;
}}

snapControls
{{
    nSmoothPatch 3;
    tolerance 2.0;
    nSolveIter 30;
    nRelaxIter 5;
    nFeatureSnapIter 10;
    implicitFeatureSnap true;
    explicitFeatureSnap false;
    multiRegionFeatureSnap false;
}}

addLayersControls
{{
    relativeSizes true;
    layers {{}}
    expansionRatio 1.0;
    finalLayerThickness 0.3;
    minThickness 0.1;
    nGrow 0;
    featureAngle 60;
    nRelaxIter 3;
    nSmoothSurfaceNormals 1;
    nSmoothNormals 3;
    nSmoothThickness 10;
    maxFaceThicknessRatio 0.5;
    maxThicknessToMedialRatio 0.3;
    minMedialAxisAngle 90;
    nBufferCellsNoExtrude 0;
    nLayerIter 50;
}}

meshQualityControls
{{
    maxNonOrtho 65;
    maxBoundarySkewness 20;
    maxInternalSkewness 4;
    maxConcave 80;
    minVol 1e-30;
    minTetQuality 1e-15;
    minArea -1;
    minTwist 0.02;
    minDeterminant 0.001;
    minFaceWeight 0.05;
    minVolRatio 0.01;
    minTriangleTwist -1;
    nSmoothScale 4;
    errorReduction 0.75;
}}

mergeTolerance 1e-6;
)";
    static constexpr const char* kControl = R"(application simpleFoam;
startFrom startTime;
startTime 0;
stopAt endTime;
endTime 200;
deltaT 1;
writeControl timeStep;
writeInterval 200;
purgeWrite 0;
writeFormat binary;
writePrecision 8;
timeFormat general;
timePrecision 6;
runTimeModifiable true;
)";
    static constexpr const char* kSchemes = R"(ddtSchemes { default steadyState; }
gradSchemes { default cellLimited Gauss linear 1; }
divSchemes
{
    default none;
    div(phi,U) bounded Gauss upwind;
    div((nuEff*dev2(T(grad(U))))) Gauss linear;
}
laplacianSchemes { default Gauss linear limited 0.5; }
interpolationSchemes { default linear; }
snGradSchemes { default limited 0.5; }
)";
    static constexpr const char* kSolution = R"(solvers
{
    p { solver GAMG; smoother GaussSeidel; tolerance 1e-14; relTol 0.05; }
    U { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-14; relTol 0.1; }
}
SIMPLE
{
    consistent yes;
    nNonOrthogonalCorrectors 1;
    pRefCell 0;
    pRefValue 0;
    residualControl { p 1e-4; U 1e-4; }
}
relaxationFactors { equations { U 0.8; } }
)";

    const Bed& bed_;
    std::filesystem::path folder_;
    Files& files_;
};

} // namespace

double writeOpenFoamCase(const Bed& bed, const std::filesystem::path& folder, Files& files)
{
    const BedSurface surface(bed);
    Case made(bed, folder / "openfoam", files);
    made.writeRest();
    std::swap(files.front(), files.back()); // Allrun is what to begin with
    made.writeBlocks();
    const double cells = made.writeSnappy();
    made.writeFields();
    made.writeSurfaces(surface, cells);
    return cells;
}

} // namespace frostfill
