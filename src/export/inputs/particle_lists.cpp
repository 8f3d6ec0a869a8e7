// SPDX-License-Identifier: MIT
// Formats that are a list of spheres and no more: MercuryDPM, MFiX, Lethe.
#include "base/atomic_file.hpp"
#include "export/inputs/start_state.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

namespace frostfill
{
namespace
{

/// Format 14 of MercuryDPM: number, time and box; then of each place, velocity, radius, angles,
/// angular velocity and species.
void writeMercuryDpm(const StartState& state, const std::vector<std::filesystem::path>& files)
{
    AtomicFile data(files[0]);
    const Eigen::Vector3d low = state.box.min();
    const Eigen::Vector3d high = state.box.max();
    data.write(fmt::format("{} {} {} {} {} {} {} {}\n", state.spheres.size(), state.time, low.x(),
                           low.y(), low.z(), high.x(), high.y(), high.z()));
    for (const StartSphere& sphere : state.spheres)
    {
        data.write(fmt::format(FMT_COMPILE("{} {} {} 0 0 0 {} 0 0 0 0 0 0 0\n"), sphere.centre.x(),
                               sphere.centre.y(), sphere.centre.z(), sphere.radius));
    }
    data.commit();
}

/// MFiX skips the first 18 lines, reads numbers behind the first word of the others, and takes
/// spheres from line 35.
constexpr const char* kMfixHead = R"(Dimension:    3
Particles:    {}
========================================================================
Variable      Read(T/F)     Default value (when Read=F)
========================================================================
Coordinates:     T          Must always be T
Phase_ID:        F          1
Diameter:        T          {}
Density:         F          {}
Velocity:        F          0.0 0.0 0.0
Temperature:     F          (Ignored if energy eq. is not solved)
Species:         F          (Ignored if species eq. are not solved)
User_Scalar:     F          (Ignored if no user scalars are defined)
========================================================================
X                     Y                     Z                     Diameter
========================================================================
)";

void writeMfix(const StartState& state, const std::vector<std::filesystem::path>& files)
{
    AtomicFile data(files[0]);
    data.write("Version 2.0\n");
    for (int line = 1; line < 18; ++line)
    {
        data.write("#\n");
    }
    data.write(fmt::format(fmt::runtime(kMfixHead), state.spheres.size(), 2 * state.largest,
                           state.law.density));
    for (const StartSphere& sphere : state.spheres)
    {
        data.write(fmt::format(FMT_COMPILE("{} {} {} {}\n"), sphere.centre.x(), sphere.centre.y(),
                               sphere.centre.z(), 2 * sphere.radius));
    }
    data.commit();
}

/// The list of the insertion method "file" of Lethe.
void writeLethe(const StartState& state, const std::vector<std::filesystem::path>& files)
{
    AtomicFile data(files[0]);
    data.write("p_x; p_y; p_z; v_x; v_y; v_z; w_x; w_y; w_z; diameters;\n");
    for (const StartSphere& sphere : state.spheres)
    {
        data.write(fmt::format(FMT_COMPILE("{}; {}; {}; 0; 0; 0; 0; 0; 0; {};\n"),
                               sphere.centre.x(), sphere.centre.y(), sphere.centre.z(),
                               2 * sphere.radius));
    }
    data.commit();
}

} // namespace

std::unique_ptr<Exporter> makeMercuryDpmExporter(const ExportedRun& run,
                                                 const std::filesystem::path& folder)
{
    return makeInputExporter(ExportFormat::mercuryDpm, writeMercuryDpm, run, folder);
}

std::unique_ptr<Exporter> makeMfixExporter(const ExportedRun& run,
                                           const std::filesystem::path& folder)
{
    return makeInputExporter(ExportFormat::mfix, writeMfix, run, folder);
}

std::unique_ptr<Exporter> makeLetheExporter(const ExportedRun& run,
                                            const std::filesystem::path& folder)
{
    return makeInputExporter(ExportFormat::lethe, writeLethe, run, folder);
}

} // namespace frostfill
