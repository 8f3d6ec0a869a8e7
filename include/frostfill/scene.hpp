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

#pragma GCC visibility push(default)
namespace frostfill
{

enum class Axis : std::uint8_t
{
    x,
    y,
    z
};
enum class Integrator : std::uint8_t
{
    explicitEuler,
    semiImplicitEuler
};
enum class SphereSearch : std::uint8_t
{
    allPairs,
    grid, ///< frozen spheres in the cells of a uniform grid; same bits as all pairs
};
enum class PolygonSearch : std::uint8_t
{
    loop,
    list,
    quadtree,
    grid, ///< in the cells of a uniform grid
};
enum class DiscardRule : std::uint8_t
{
    none,
    paper, ///< by height and covered vertices: heuristics; preset paper only
    exact, ///< what no sphere can reach, found when asked for; preset fast only
};
enum class FreezingRule : std::uint8_t
{
    oneByOne, ///< each sphere by itself, as soon as it is calm and carried
    bySet,    ///< a set as a whole, once most of it is calm
};
enum class Preset : std::uint8_t
{
    fast,  ///< our own engine: exact contacts; a sphere freezes as soon as it is carried
    paper, ///< the complete method of the paper
};
enum class Motion : std::uint8_t
{
    fall,     ///< the whole fall, for animations
    skip,     ///< spheres appear at their first contact; only settling is simulated
    descend,  ///< drop-and-roll: no dynamics; each sphere moves down to a place that carries it
    granular, ///< all at once, with spin and friction, as grains [Cundall & Strack 1979]
};

enum class Rest : std::uint8_t
{
    each,  ///< every sphere rests on what is at rest, as if nothing could move that
    joint, ///< then all settle together, until forces in all contacts at once hold them
};

/// The object to fill.
struct ObjectSettings
{
    std::string mesh = "torus"; ///< a built-in name or a file
    Axis up = Axis::y;          ///< axis of the mesh that points up
    double unitsPerMetre = 1;   ///< mesh units in a metre: 1000 for a CAD file in millimetres
    LoadMeshOptions load;       ///< how an open or broken mesh is made whole
};

/// The radii of the spheres: one radius, a range with uniform distribution, or the radii of a file.
struct Radii
{
    double smallest = 0; ///< [mesh unit]
    double largest = 0;  ///< [mesh unit]
    /// A file with one radius [mesh unit] per line; each sphere gets one of them with equal
    /// probability. `smallest` and `largest` are then not used.
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
    /// Whether all spheres have the same radius.
    [[nodiscard]] bool equal() const { return file.empty() && smallest == largest; }
    friend bool operator==(const Radii&, const Radii&) = default;
};

/// Of what the shares of a size curve are shares. All spheres have the same density, so mass and
/// volume are the same.
enum class SharesOf : std::uint8_t
{
    number,
    mass,
    volume,
};

/// Sizes as a sieve or a formula gives them, in place of Radii.
struct SizeSettings
{
    /// A CSV file of sizes and shares, or "lognormal:MEAN,SD", "normal:MEAN,SD" or
    /// "weibull:SCALE,SHAPE", each with ",LOW..HIGH" for its ends; radii [mesh unit].
    std::optional<std::string> curve;
    std::optional<SharesOf> by; ///< if not given, the file's header has to say it
    /// [1] Once a size finds no place any more, the run ends before the cumulative curve by mass is
    /// off by more than this. If not given, it goes on until no sphere fits.
    std::optional<double> within = 0.005;
    bool fillGaps = false; ///< largest first; smaller ones then go into the gaps between them

    friend bool operator==(const SizeSettings&, const SizeSettings&) = default;
    friend auto operator<=>(const SizeSettings&, const SizeSettings&) = default;
};

/// A round, level opening through which spheres come into the object.
struct Inlet
{
    Eigen::Vector3d centre = Eigen::Vector3d::Zero(); ///< [mesh unit]
    double radius = 0;                                ///< [mesh unit] of the opening

    friend bool operator==(const Inlet&, const Inlet&) = default;
};

/// Number and size of the spheres, and how they appear (PAPER: gamma, k).
struct SphereSettings
{
    std::optional<Radii> radius;        ///< [mesh unit]; if not given, it follows from the count
    std::optional<std::uint64_t> count; ///< stop at this number; if not given, fill until full
    bool untilFull = false;             ///< continue after `count` until no sphere fits
    std::uint32_t groupSize = 0; ///< gamma: spheres in a group; 0 (fast only): 10, or more if the
                                 ///< object is large, or to pour in the animation's duration
    std::uint32_t groupsPerSet = 2; ///< k: groups that appear together
    /// If there are some, spheres appear in these openings and nowhere else, until the heap below
    /// reaches them.
    std::vector<Inlet> inlets = {};
    SizeSettings sizes = {}; ///< not together with a radius

    /// Whether the radii are given; otherwise they follow from the count.
    [[nodiscard]] bool givesRadii() const { return radius || sizes.curve; }
};

/// How a sphere moves. Lengths in r and times in sqrt(r/g) keep the defaults independent of units.
struct MotionSettings
{
    double gravity = 9.81;      ///< [m/s^2], along the down axis
    Motion mode = Motion::fall; ///< of the preset fast; the paper's spheres always fall
    Integrator integrator = Integrator::explicitEuler; ///< of the preset paper
    std::optional<double> dt; ///< [s]; if not given, no fall moves more than r/2 in a step
    double restitution = 0.2; ///< [1] 0..1, of all contacts
    int sweeps = 16;          ///< of the preset fast: most sweeps of the contact solver in a step
};

/// How the object moves once it is filled and at rest. The movement starts and ends smoothly. The
/// simulation stays in the frame of the object, where gravity turns and inertial forces act.
struct MoveSettings
{
    double tilt = 0;                 ///< [degree] final angle about the horizontal depth axis
    double turn = 0;                 ///< [degree] final angle about the up axis
    double shake = 0;                ///< [mesh unit] amplitude of sideways shaking
    std::optional<double> frequency; ///< [1/s]; if not given, the peak acceleration is g / 2
    std::optional<double> duration;  ///< [s]; if not given, eight falls through the height

    [[nodiscard]] bool any() const { return tilt != 0 || turn != 0 || shake != 0; }
};

/// When running spheres freeze (PAPER: frozen).
struct FreezingSettings
{
    std::uint32_t everySets = 2; ///< freeze after this many sets have come to rest; 0: never
    double restSpeed = 0.1;      ///< [sqrt(g r)] a sphere rests below this mean speed
    double restWindow = 1;       ///< [sqrt(r/g)] time over which the mean is taken
    double setTimeLimit = 60;    ///< [sqrt(r/g)] a set counts as at rest after this time plus
                                 ///< twice the time of a fall through the object
    /// Preset fast, not with Motion::descend.
    FreezingRule rule = FreezingRule::oneByOne;
};

/// What rest is, in the end. Friction acts while all settle together; the motions that fill the
/// object have none, but with a rolling friction spheres roll over what is at rest.
struct RestSettings
{
    Rest mode = Rest::each;
    double friction = 0;                ///< [1] Coulomb's, of two spheres
    std::optional<double> wallFriction; ///< [1] Coulomb's, of a wall; if not given, as of spheres
    /// The ends of what may be asked for as packing fraction. Nothing packs as loosely as the one
    /// or as densely as the other, so they ask for the loosest and the densest that there is:
    /// spheres of one size rest at 0.55 at least, and at 0.64 at most [Onoda & Liniger 1990; Bernal
    /// & Mason 1960].
    static constexpr double kLoosest = 0.5;
    static constexpr double kDensest = 0.7;
    /// The friction of spheres that a fraction implies: it holds all fractions between 0.59 and
    /// 0.64.
    static constexpr double kHoldsFraction = 0.3;
    /// [1] packing fraction of the bulk, beyond four radii from walls, to which all is compacted by
    /// flowing without friction; if not given, as it comes
    std::optional<double> fraction;
    double rollingFriction = 0; ///< [1] moment that resists rolling, over normal force and radius
    bool orientation = false;   ///< keep how spheres have turned, in columns of their own

    /// Whether a fraction is asked for that only friction holds: the densest pile needs none.
    [[nodiscard]] bool needsFriction() const { return fraction && fraction != kDensest; }
};

/// What is no longer tested (PAPER: equation 3 and covered polygons).
struct DiscardSettings
{
    DiscardRule rule = DiscardRule::paper;
    double epsilon = 4;     ///< [r] a group this far below the last frozen one is discarded
    double closeness = 0.3; ///< [r] largest distance of a covering sphere along the vertex normal
};

/// How the spheres at rest are judged. Changes no bit of their state.
struct JudgeSettings
{
    static constexpr double kMostFriction = 8; ///< up to which the least one is looked for

    std::optional<double> friction; ///< [1] of all contacts; if given, whether all that is at rest
                                    ///< stays so together is judged, too
    double unbalance = 0.1; ///< [own weight] that forces may miss on a sphere that is balanced
    /// [1] under which spheres settled that a program judges. A scene has RestSettings for that.
    double settledWith = 0;
    /// [1] Moment that resists rolling in all contacts, over normal force and reduced radius; if
    /// not given, that of RestSettings.
    std::optional<double> rollingFriction = {};
};

struct SearchSettings
{
    SphereSearch spheres = SphereSearch::allPairs;
    PolygonSearch polygons = PolygonSearch::quadtree;
    /// Preset fast: keep a list of the neighbours of each running sphere until it has moved by half
    /// a radius [Verlet 1967]. Off: equally exact, slower. The lists decide where a path is split,
    /// so the bits differ.
    bool neighbourLists = true;
};

/// Pictures of depth, normals and identities for each frame.
struct Passes
{
    bool depth = false;    ///< distance along the view
    bool normal = false;   ///< direction of the surface
    bool identity = false; ///< which sphere is visible

    [[nodiscard]] bool any() const { return depth || normal || identity; }
};

/// Which states become pictures. Only the duration matters to the simulation; see groupSize.
struct FrameSettings
{
    bool enabled = true;              ///< off: no frames, whatever is selected
    double fps = 30;                  ///< frames per second of video
    std::optional<double> slowMotion; ///< video time over simulated time; automatic if not given
    std::optional<double> duration;   ///< [s] of video; if not given, 20 s, or less for few spheres
    std::size_t limit = 1000;         ///< most pictures kept, at equal steps; 0: no limit
    double hold = 0;                  ///< [s] for which the video shows the last state
    Passes passes;
    std::optional<bool> keepRun; ///< in run.frost, every frame; if not given, when frames are drawn
    std::string selection = "all"; ///< "last", "0:100:10", "5,7,90..100", ...
    /// Where the camera is when: keyframes "0:30,20 8:120,45" of seconds of video, azimuth and
    /// elevation [degree] and, if wanted, zoom, or a file of such lines. Not with a turntable
    std::optional<std::string> cameraPath;
};

/// Everything that describes a run: a plain value. Equal scenes give equal results.
struct Scene
{
    std::string name = "torus";
    Preset preset = Preset::fast;
    std::uint64_t seed = 1;
    std::int32_t threads = 0; ///< of the preset fast; 0: one for each core. Changes no bit
    ObjectSettings object;
    SphereSettings spheres;
    MotionSettings motion;
    FreezingSettings freezing;
    RestSettings rest;
    MoveSettings move;
    DiscardSettings discard;
    SearchSettings search;
    JudgeSettings judge;
    FrameSettings frames;
    PictureSize size;
    Camera camera;
    Style style;
    int samples = 4;
    int supersample = 1;
    Backend backend = Backend::automatic;
    bool staticLayer = true; ///< off: draw every picture from scratch; the same pictures
};

/// The default scene for a mesh. The four objects have the parameters of the paper.
[[nodiscard]] Scene presetScene(Preset preset, const std::string& meshNameOrFile);

/// Reads a TOML scene; keys that it lacks have the defaults of its preset. Mesh paths are relative
/// to the scene file. Throws Error inputMissing, or badData with the line and, for an unknown key,
/// the nearest known one.
[[nodiscard]] Scene loadScene(const std::filesystem::path& file);
[[nodiscard]] Scene parseScene(std::string_view toml, std::string_view nameForMessages);

/// The whole scene as TOML. parseScene returns the same scene.
[[nodiscard]] std::string sceneToToml(const Scene& scene);

/// Throws Error usage for the first invalid value, with the allowed range.
void validateScene(const Scene& scene);

/// Unit vector against gravity, in mesh coordinates.
[[nodiscard]] Eigen::Vector3d upVector(Axis axis);

/// Gravity [mesh unit / s^2].
[[nodiscard]] double gravityInMeshUnits(const Scene& scene);

/// The largest radius of the run. It is that of the scene, or the radius at which `count` spheres
/// take 90 % of the wall-corrected estimate phi (V - c r S), phi = 0.586, c = 0.38. It may be too
/// large for thin walls. Throws Error usage if the scene gives neither a radius nor a count. A file
/// of radii can throw inputMissing, or badData with the line.
[[nodiscard]] double sphereRadius(const Scene& scene, const MeshReport& mesh);

/// The same, or a smaller one for an object whose walls are too thin for it: then only the parts
/// count that are thick enough for a sphere. A Simulation uses this one. `report` is that of
/// inspectInterior, `mesh` is closed.
[[nodiscard]] double sphereRadius(const Scene& scene, const MeshReport& report,
                                  const TriangleMesh& mesh);

} // namespace frostfill
#pragma GCC visibility pop
