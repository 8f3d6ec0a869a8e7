// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>
#include <frostfill/view.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace frostfill
{

enum class Axis : std::uint8_t
{
    x,
    y,
    z
};
// Each enumeration from here to ReleaseRule chooses a part. They are open: a part that a program
// adds (docs/parts.md) has a value after the last one that is built in.
enum class Integrator : std::uint8_t
{
    explicitEuler,
    semiImplicitEuler
};
enum class SphereSearch : std::uint8_t
{
    allPairs,
    grid, ///< frozen spheres by the cells of a uniform grid: same bits as all pairs
};
enum class PolygonSearch : std::uint8_t
{
    loop,
    list,
    quadtree,
    grid, ///< by the cells of a uniform grid
};
enum class DiscardRule : std::uint8_t
{
    none,
    paper, ///< by height and covered vertices: heuristics, of the preset paper
    exact, ///< by reachability: same bits as without, of the preset fast
};
enum class FreezingRule : std::uint8_t
{
    oneByOne, ///< each sphere by itself, as soon as it is calm and carried
    bySet,    ///< a set as a whole, once most of it is calm
};
enum class ReleaseRule : std::uint8_t
{
    ceilings, ///< at random below the object's ceilings, then wherever one still fits
};
enum class Preset : std::uint8_t
{
    fast,  ///< our own engine: exact contacts, each sphere frozen as soon as it is carried
    paper, ///< the paper's method, whole
};
enum class Motion : std::uint8_t
{
    fall,    ///< every moment of the fall, for animations
    skip,    ///< spheres appear at their first contact; only settling is simulated
    descend, ///< no dynamics: each sphere is taken down to a place that carries it
};

/// What is filled.
struct ObjectSettings
{
    std::string mesh = "torus"; ///< a built-in name or a file
    Axis up = Axis::y;          ///< which axis of the mesh points up
    double unitsPerMetre = 1;   ///< mesh units in a metre: 1000 for a CAD file in millimetres
};

/// The radii that spheres are given: one, any between two with equal likelihood, or those of a
/// file.
struct Radii
{
    double smallest = 0; ///< [mesh unit]
    double largest = 0;  ///< [mesh unit]
    /// With a radius [mesh unit] a line; each sphere gets one of them with equal likelihood. The
    /// two numbers do not count then.
    std::string file = {};

    Radii() = default;
    Radii(double radius) : smallest(radius), largest(radius) {} // NOLINT: a number is one radius
    Radii(double low, double high) : smallest(low), largest(high) {}
    [[nodiscard]] static Radii fromFile(std::string path)
    {
        Radii radii;
        radii.file = std::move(path);
        return radii;
    }
    /// All spheres are alike.
    [[nodiscard]] bool equal() const { return file.empty() && smallest == largest; }
    friend bool operator==(const Radii&, const Radii&) = default;
};

/// How many spheres, how large, and how they appear (PAPER: gamma, k).
struct SphereSettings
{
    std::optional<Radii> radius;        ///< [mesh unit]; derived from the count when not given
    std::optional<std::uint64_t> count; ///< stop at this many; until full when not given
    bool untilFull = false;             ///< go on after `count` until no sphere fits
    std::uint32_t groupSize = 0;    ///< gamma: spheres in a group; 0 (fast only): 10, or more in an
                                    ///< object that is large against a sphere
    std::uint32_t groupsPerSet = 2; ///< k: groups that appear together
    ReleaseRule release = ReleaseRule::ceilings; ///< where spheres appear
};

/// How a sphere moves. Lengths in r and times in sqrt(r/g) make defaults independent of units.
struct MotionSettings
{
    double gravity = 9.81;      ///< [m/s^2], along the down axis
    Motion mode = Motion::fall; ///< of the preset fast; the paper's spheres always fall
    Integrator integrator = Integrator::explicitEuler; ///< of the preset paper
    std::optional<double> dt; ///< [s]; chosen so that no fall moves more than r/2 a step
    double restitution = 0.2; ///< [1] 0..1, of every contact
    int sweeps = 16; ///< of the preset fast, over running spheres that meet: at most so many a step
};

/// How the object moves once it is filled and at rest. Angles and amplitude start from zero and end
/// smoothly; the simulation stays in the object's frame, where gravity turns and inertia pulls.
struct MoveSettings
{
    double tilt = 0;                 ///< [degree] in the end, about the horizontal depth axis
    double turn = 0;                 ///< [degree] in the end, about the up axis
    double shake = 0;                ///< [mesh unit] amplitude of shaking to the sides
    std::optional<double> frequency; ///< [1/s] of shaking; reaches half of gravity when not given
    std::optional<double> duration;  ///< [s]; eight falls through the height when not given

    [[nodiscard]] bool any() const { return tilt != 0 || turn != 0 || shake != 0; }
};

/// When moving spheres become immobile for good (PAPER: frozen).
struct FreezingSettings
{
    std::uint32_t everySets = 2; ///< freeze when so many sets have come to rest; 0 never freezes
    double restSpeed = 0.1;      ///< [sqrt(g r)] mean speed over the window below which one rests
    double restWindow = 1;       ///< [sqrt(r/g)] for how long
    double setTimeLimit = 60;    ///< [sqrt(r/g)] after which a set counts as come to rest, plus
                                 ///< twice the time of a fall through the object's height
    bool bySet = false; ///< of the preset fast: a set freezes when all of it is calm, and the next
                        ///< appears then; off: each sphere by itself. Not with Motion::descend
    /// Of the preset fast, not with Motion::descend; what bySet says when not given.
    std::optional<FreezingRule> rule;
};

/// What is not tested any more (PAPER: equation 3 and covered polygons).
struct DiscardSettings
{
    DiscardRule rule = DiscardRule::paper;
    double epsilon = 4;     ///< [r] a group goes when it lies more than this below the last one
    double closeness = 0.3; ///< [r] from a vertex along its normal to a covering sphere
};

struct SearchSettings
{
    SphereSearch spheres = SphereSearch::allPairs;
    PolygonSearch polygons = PolygonSearch::quadtree;
    /// Preset fast: what is near a running sphere is kept until it has moved half a radius [Verlet
    /// 1967]; off: looked up anew each time, as exactly. Where a path is cut depends on it, so the
    /// bits differ.
    bool neighbourLists = true;
};

/// Pictures of other things than colour, beside every frame.
struct Passes
{
    bool depth = false;    ///< distance along the view
    bool normal = false;   ///< where surfaces face
    bool identity = false; ///< which sphere is seen

    [[nodiscard]] bool any() const { return depth || normal || identity; }
};

/// Which moments become pictures. Has no influence on what is simulated.
struct FrameSettings
{
    bool enabled = true;              ///< off: none, whatever is selected
    double fps = 30;                  ///< frames a second of video
    std::optional<double> slowMotion; ///< video time over simulated time; automatic when not given
    std::size_t limit = 1000;         ///< at most so many: every n-th is kept; 0 for no limit
    double hold = 0;                  ///< [s] of video for which the last state is shown
    Passes passes;
    std::string selection = "all"; ///< "last", "0:100:10", "5,7,90:100", ...
};

/// Everything that describes a run; a plain value. Two equal scenes give equal results.
struct Scene
{
    std::string name = "torus";
    Preset preset = Preset::fast;
    std::uint64_t seed = 1;
    std::int32_t threads = 0; ///< of the preset fast; 0: one a core. Changes no bit of the result
    ObjectSettings object;
    SphereSettings spheres;
    MotionSettings motion;
    FreezingSettings freezing;
    MoveSettings move;
    DiscardSettings discard;
    SearchSettings search;
    FrameSettings frames;
    PictureSize size;
    Camera camera;
    Style style;
    int samples = 4;
    int supersample = 1;
    Backend backend = Backend::automatic;
    bool staticLayer = true; ///< off: every picture is drawn from nothing; the same pictures
};

/// The paper's parameters for one of its four objects, or general ones for any other mesh.
[[nodiscard]] Scene presetScene(Preset preset, const std::string& meshNameOrFile);

/// Reads a TOML scene on top of the preset it names. Relative mesh paths are relative to the file.
/// Throws Error inputMissing, or badData with the line and, for an unknown key, the nearest one.
[[nodiscard]] Scene loadScene(const std::filesystem::path& file);
[[nodiscard]] Scene parseScene(std::string_view toml, std::string_view nameForMessages);

/// The whole scene as TOML: parseScene gives it back unchanged.
[[nodiscard]] std::string sceneToToml(const Scene& scene);

/// Throws Error usage for the first value that makes no sense, with its allowed range.
void validateScene(const Scene& scene);

/// Unit vector against gravity, in mesh coordinates.
[[nodiscard]] Eigen::Vector3d upVector(Axis axis);

/// Gravity in mesh units a square second.
[[nodiscard]] double gravityInMeshUnits(const Scene& scene);

/// The largest radius of the run: the scene's own, or the one at which `count` spheres take 90 % of
/// the wall-corrected estimate phi (V - c r S), phi = 0.586, c = 0.38. Throws Error usage when
/// neither radius nor count is given, and what reading a file of radii throws: inputMissing, or
/// badData with the line.
[[nodiscard]] double sphereRadius(const Scene& scene, const MeshReport& mesh);

} // namespace frostfill
