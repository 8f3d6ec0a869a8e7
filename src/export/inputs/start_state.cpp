// SPDX-License-Identifier: MIT
#include "export/inputs/start_state.hpp"

#include "base/atomic_file.hpp"

#include <frostfill/error.hpp>

#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace frostfill
{
namespace
{

/// Of glass [kg/m^3]. It changes no place: the stiffness goes with it.
constexpr double kDensity = 2500;
/// How far the mean contact at the bottom may sink in under the weight of all above it [r]. The
/// strongest contact of a pile carries some ten times the mean and sinks in 10^(2/3) times as far,
/// which is below 1e-3 r. Larger: a pile sinks visibly while it takes up its load. Smaller: time
/// steps are shorter, by the power 3/4.
constexpr double kSink = 1e-4;
/// (delta / r)^(3/2) E* / pressure of two equal Hertzian spheres: a contact carries
/// F = 4 pi r^2 p / (z phi), with 5 contacts z and a packing fraction phi of 0.6; and
/// F = 4/3 E* sqrt(r/2) delta^(3/2).
constexpr double kPressureToSink = 4.45;
constexpr double kShareOfPile = 0.6;

GrainLaw lawOf(const ExportedRun& run, const StartState& state)
{
    const Scene& scene = run.scene;
    GrainLaw law;
    law.restitution = scene.motion.restitution;
    law.friction = scene.rest.friction;
    law.wallFriction = scene.rest.wallFriction.value_or(law.friction);
    law.rollingFriction = scene.rest.rollingFriction;
    law.gravity = gravityInMeshUnits(scene);
    law.down = -upVector(static_cast<Axis>(run.up));
    law.density = kDensity / std::pow(state.unitsPerMetre, 3);
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const StartSphere& sphere : state.spheres)
    {
        const double height = -law.down.dot(sphere.centre);
        low = std::min(low, height - sphere.radius);
        high = std::max(high, height + sphere.radius);
    }
    const double pressure = kShareOfPile * law.density * law.gravity * (high - low);
    const double effective = kPressureToSink * pressure / std::pow(kSink, 1.5);
    law.young = 2 * (1 - law.poisson * law.poisson) * effective; // of two alike
    return law;
}

class InputExporter : public Exporter
{
public:
    InputExporter(ExportFormat format, WriteInput write, const ExportedRun& run,
                  const std::filesystem::path& folder)
        : write_(write), run_(run)
    {
        for (const std::string& name : exportFiles(format, run))
        {
            files_.push_back(folder / name);
        }
    }
    void add(const ExportedFrame& frame) override { write_(startStateOf(run_, frame), files_); }
    void finish() override {}

private:
    WriteInput write_;
    const ExportedRun& run_;
};

} // namespace

StartState startStateOf(const ExportedRun& run, const ExportedFrame& frame)
{
    StartState state;
    state.frame = frame.number;
    state.time = frame.state.time;
    state.unitsPerMetre = run.scene.object.unitsPerMetre;
    for (std::size_t i = 0; i < frame.state.states.size(); ++i)
    {
        if (!frame.state.waits(i))
        {
            state.spheres.push_back(
                {static_cast<std::uint32_t>(i), frame.centre(i), frame.radii[i]});
        }
    }
    if (state.spheres.empty())
    {
        throw Error(ErrorCode::usage,
                    fmt::format("frame {} has no sphere yet: choose a later one with --frames",
                                frame.number));
    }
    state.smallest = state.largest = state.spheres.front().radius;
    state.walls.triangles = run.mesh.triangles;
    state.walls.triangles.resize(run.mesh.triangles.size() - run.lids);
    state.patches = wallsOf(run);
    for (const Eigen::Vector3d& vertex : run.mesh.vertices)
    {
        state.walls.vertices.push_back(frame.inWorld(vertex));
        state.box.extend(state.walls.vertices.back());
    }
    for (const StartSphere& sphere : state.spheres)
    {
        state.smallest = std::min(state.smallest, sphere.radius);
        state.largest = std::max(state.largest, sphere.radius);
        state.box.extend(sphere.centre - Eigen::Vector3d::Constant(sphere.radius));
        state.box.extend(sphere.centre + Eigen::Vector3d::Constant(sphere.radius));
    }
    state.law = lawOf(run, state);
    return state;
}

std::string headingOf(const StartState& state, const char* mark)
{
    return fmt::format(
        "{0} Written by Frostfill: {1} spheres of frame {2}, at {3} s.\n"
        "{0} Lengths are in the unit of the mesh, {4} in a metre; times in seconds, masses in "
        "kilograms.\n",
        mark, state.spheres.size(), state.frame, state.time, state.unitsPerMetre);
}

std::string scriptVariables(const StartState& state, double restitution)
{
    constexpr const char* kVariables = R"(variable friction index {friction}
variable wallFriction index {wallFriction}
variable rollingFriction index {rollingFriction}
variable restitution index {restitution}
variable density index {density}
variable young index {young:.6g}
variable poisson index {poisson}
variable gravity index {gravity}
# A fifth of the time in which a wave crosses the smallest sphere, and ten times sqrt(r/g)
variable dt equal 0.2*PI*{smallest}*sqrt(2*(1+v_poisson)*v_density/v_young)/(0.1631*v_poisson+0.8766)
variable steps equal ceil(10*sqrt({largest}/v_gravity)/v_dt)
# A line of numbers so often
variable often equal ceil(v_steps/50)
)";
    const GrainLaw& law = state.law;
    return fmt::format(fmt::runtime(kVariables), fmt::arg("friction", law.friction),
                       fmt::arg("wallFriction", law.wallFriction),
                       fmt::arg("rollingFriction", law.rollingFriction),
                       fmt::arg("restitution", restitution), fmt::arg("density", law.density),
                       fmt::arg("young", law.young), fmt::arg("poisson", law.poisson),
                       fmt::arg("gravity", law.gravity), fmt::arg("smallest", state.smallest),
                       fmt::arg("largest", state.largest));
}

std::string directionText(const Eigen::Vector3d& direction, const char* between)
{
    const Eigen::Vector3d d = direction + Eigen::Vector3d::Zero();
    return fmt::format("{:g}{}{:g}{}{:g}", d.x(), between, d.y(), between, d.z());
}

void writeDataFile(const std::filesystem::path& file, const StartState& state, double margin,
                   const std::function<int(const StartSphere&)>& typeOf)
{
    AtomicFile data(file);
    data.write(
        fmt::format("Packing of frame {} at {} s, density {:g}\n\n{} atoms\n2 atom types\n\n",
                    state.frame, state.time, state.law.density, state.spheres.size()));
    const char* axes[] = {"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis)
    {
        data.write(fmt::format("{} {} {}lo {}hi\n", state.box.min()[axis] - margin,
                               state.box.max()[axis] + margin, axes[axis], axes[axis]));
    }
    data.write("\nAtoms\n\n");
    for (const StartSphere& sphere : state.spheres)
    {
        data.write(fmt::format(FMT_COMPILE("{} {} {} {} {} {} {}\n"), sphere.id + 1, typeOf(sphere),
                               2 * sphere.radius, state.law.density, sphere.centre.x(),
                               sphere.centre.y(), sphere.centre.z()));
    }
    data.commit();
}

std::unique_ptr<Exporter> makeInputExporter(ExportFormat format, WriteInput write,
                                            const ExportedRun& run,
                                            const std::filesystem::path& folder)
{
    return std::make_unique<InputExporter>(format, write, run, folder);
}

} // namespace frostfill
