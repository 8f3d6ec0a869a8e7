// SPDX-License-Identifier: MIT
#include "base/atomic_file.hpp"
#include "base/processor_time.hpp"
#include "base/run_program.hpp"
#include "export/inputs/start_state.hpp"
#include "output/stl_text.hpp"
#include "study/peers/peer.hpp"
#include "study/peers/pouring.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <sstream>

namespace frostfill
{
namespace
{

namespace fs = std::filesystem;

constexpr double kPoisson = 0.3;
constexpr double kShareOfRayleigh = 0.2; // as its own manual advises

/// A folder of its own that goes away.
class TemporaryFolder
{
public:
    TemporaryFolder()
        : folder_(fs::temp_directory_path() / fmt::format("frostfill_peer_{}", ::getpid()))
    {
        fs::create_directories(folder_);
    }
    ~TemporaryFolder()
    {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    [[nodiscard]] const fs::path& folder() const { return folder_; }
    void write(const char* name, const std::string& text) const
    {
        AtomicFile file(folder_ / name);
        file.write(text);
        file.commit();
    }

private:
    fs::path folder_;
};

constexpr const char* kScript = R"(atom_style granular
atom_modify map array
boundary f f f
newton off
communicate single vel yes
units si
soft_particles yes
region all block {x0} {x1} {y0} {y1} {z0} {z1} units box
create_box 1 all
neighbor 0.4 bin
neigh_modify delay 0
fix m1 all property/global youngsModulus peratomtype {stiffness}
fix m2 all property/global poissonsRatio peratomtype {poisson}
fix m3 all property/global coefficientRestitution peratomtypepair 1 {restitution}
fix m4 all property/global coefficientFriction peratomtypepair 1 {friction}
pair_style gran model hertz tangential {tangential}
pair_coeff * *
timestep {step}
fix pull all gravity 1 vector 0 -1 0
fix object all mesh/surface file object.stl type 1
fix walls all wall/gran model hertz tangential {tangential} mesh n_meshes 1 meshes object
region band block {bx0} {bx1} {band} {top} {bz0} {bz1} units box
fix kind all particletemplate/sphere 15485863 atom_type 1 density constant 1 radius constant 1
fix kinds all particledistribution/discrete 15485867 1 kind 1.0
fix pour all insert/pack seed 32452843 distributiontemplate kinds maxattempt 50 insert_every {pour} overlapcheck yes all_in yes vel constant 0 0 0 region band volumefraction_region 0.3
fix motion all nve/sphere
variable calm atom "sqrt(vx*vx+vy*vy+vz*vz) < {speed}"
compute share all reduce ave v_calm
thermo_style custom step atoms c_share
thermo {steps}
thermo_modify norm no lost ignore
variable present equal atoms
variable pouring loop {pours}
label pour
run {pour}
if "${{present}} >= {count}" then "jump script.in poured"
next pouring
jump script.in pour
variable pouring index {pours}
label poured
unfix pour
group surplus id > {count}
delete_atoms group surplus compress no
variable window loop {windows}
label next
run {steps}
variable restsNow equal c_share
if "${{restsNow}} >= {share}" then "jump script.in rest"
next window
jump script.in next
print "NOT AT REST"
jump script.in over
label rest
print "AT REST ${{pouring}} ${{window}}"
label over
dump last all custom 1 places.txt id x y z
dump_modify last sort id format "%d %.17g %.17g %.17g"
run 0
)";

/// In units of r, sqrt(r/g) and the spheres' density.
std::string scriptOf(const PeerTask& task, double stiffness, double still)
{
    const double shear = stiffness / (2 * (1 + kPoisson));
    const double rayleigh = std::numbers::pi * std::sqrt(1 / shear) / (0.1631 * kPoisson + 0.8766);
    const double step = kShareOfRayleigh * rayleigh;
    const auto steps = static_cast<long>(std::ceil(kPeerWindow / step));
    const auto pour = static_cast<long>(std::ceil(kPeerPourEvery / step));
    const Eigen::AlignedBox3d box = boxOf(task.mesh);
    return fmt::format(
        kScript, fmt::arg("x0", box.min().x() - 2), fmt::arg("x1", box.max().x() + 2),
        fmt::arg("y0", box.min().y() - 2), fmt::arg("y1", box.max().y() + 2),
        fmt::arg("z0", box.min().z() - 2), fmt::arg("z1", box.max().z() + 2),
        fmt::arg("bx0", box.min().x()), fmt::arg("bx1", box.max().x()),
        fmt::arg("bz0", box.min().z()), fmt::arg("bz1", box.max().z()),
        fmt::arg("band", box.max().y() - kPeerBand - 1), fmt::arg("top", box.max().y()),
        fmt::arg("count", task.count), fmt::arg("pour", pour),
        fmt::arg("pours", static_cast<long>(task.timeLimit / kPeerPourEvery)),
        fmt::arg("stiffness", stiffness), fmt::arg("poisson", kPoisson),
        fmt::arg("restitution", task.restitution), fmt::arg("step", step), fmt::arg("steps", steps),
        fmt::arg("friction", task.friction),
        fmt::arg("tangential", task.friction > 0 ? "history" : "off"),
        fmt::arg("speed", still / kPeerWindow), fmt::arg("share", kPeerStillShare),
        fmt::arg("windows", static_cast<long>(task.timeLimit / kPeerWindow)));
}

std::vector<Eigen::Vector3d> readPlaces(const fs::path& file)
{
    std::ifstream in(file);
    std::string line;
    while (std::getline(in, line) && line.rfind("ITEM: ATOMS", 0) != 0)
    {
    }
    std::vector<Eigen::Vector3d> places;
    long id = 0;
    Eigen::Vector3d p;
    while (in >> id >> p.x() >> p.y() >> p.z())
    {
        places.push_back(p);
    }
    return places;
}

} // namespace

bool hasLiggghts()
{
    const TemporaryFolder workplace;
    workplace.write("empty.in", "print hello\n");
    return runProgram(workplace.folder(), {"liggghts", "-in", "empty.in"}).error == 0;
}

PeerResult runLiggghts(const PeerTask& task, double stiffness, double still)
{
    const TemporaryFolder workplace;
    writeStl(workplace.folder() / "object.stl", task.mesh, "object");
    workplace.write("script.in", scriptOf(task, stiffness, still));
    const double before = processorSecondsOfChildren();
    const auto limit = fmt::format("{:.0f}", task.secondsLimit);
    const ProgramRun run =
        runProgram(workplace.folder(), {"timeout", limit, "liggghts", "-in", "script.in"});
    PeerResult result;
    result.seconds = processorSecondsOfChildren() - before;
    std::ifstream log(workplace.folder() / "log.liggghts");
    const std::string said{std::istreambuf_iterator<char>(log), {}};
    // The commands stand in the log too, with the variable's name where its value is later.
    const std::string answer = "\nAT REST ";
    const std::size_t at = said.rfind(answer);
    result.atRest = at != std::string::npos;
    result.simulated = task.timeLimit;
    if (result.atRest)
    {
        std::istringstream numbers(said.substr(at + answer.size()));
        double pours = 0;
        double windows = 0;
        numbers >> pours >> windows;
        result.simulated = kPeerPourEvery * pours + kPeerWindow * windows;
    }
    result.places = readPlaces(workplace.folder() / "places.txt");
    if (result.places.empty())
    {
        throw Error(
            ErrorCode::missingProgram,
            fmt::format("LIGGGHTS ended with code {} and left no spheres: {}", run.code,
                        said.substr(said.size() - std::min<std::size_t>(said.size(), 300))));
    }
    return result;
}

} // namespace frostfill
