// SPDX-License-Identifier: MIT
// Room: the simulation as a program uses it: construct, step, capture. Its inner rooms hold the
// world and the parts of the engines.
#pragma once

#include <frostfill/measure.hpp>
#include <frostfill/mesh.hpp>
#include <frostfill/scene.hpp>
#include <frostfill/snapshot.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#pragma GCC visibility push(default)
namespace frostfill
{

/// What happened while a set was the newest.
struct SetRecord
{
    std::uint32_t set = 0;
    std::size_t spheres = 0; ///< that appeared with the set
    std::uint64_t steps = 0;
    double simulatedSeconds = 0;
    double meanSphereSphereMs = 0; ///< per step; fast: of the solver. 0 with Motion::descend
    double p95SphereSphereMs = 0;
    double meanSpherePolygonMs = 0; ///< per step; 0 for preset fast, where it is part of the motion
    double p95SpherePolygonMs = 0;
    StageTimes times;        ///< of the stages of the simulation, in total
    std::size_t running = 0; ///< at the end of the set, or now, after freezing and discarding
    std::size_t frozen = 0;
    /// By the rule exact as far as somebody has asked by then, as pictures do; see capture().
    std::size_t discarded = 0;
    std::size_t discardedPolygons = 0;
    bool timedOut = false; ///< did not come to rest within the time limit
    OperationCounts operations;
};

/// Whether all spheres at rest stay so together, when nothing holds any of them but the others and
/// the walls: whether some forces in all contacts balance all of them at once. Normal forces push,
/// tangential ones are at most the friction times as large, and contacts transmit no moment. A
/// sphere is unbalanced when more than JudgeSettings::unbalance is missing: of its weight, or of a
/// torque of its weight times its radius.
struct EquilibriumReport
{
    double friction = 0;        ///< [1] under which it was judged
    std::size_t spheres = 0;    ///< at rest
    std::size_t unbalanced = 0; ///< of them
    double largest = 0;         ///< [own weight] that is missing on a sphere
    bool settled = false;       ///< false: forces were still changing when they were taken
    /// [1] With it all but one in a hundred are balanced, with a hundredth less they are not;
    /// infinite if no friction up to JudgeSettings::kMostFriction will do.
    double leastFriction = 0;
};

/// How all spheres have settled together: see Rest::joint.
struct SettlingReport
{
    static constexpr double kOverlap = 1e-8;       ///< [r] allowed
    static constexpr double kMissing = 0.1;        ///< [own weight] allowed on any sphere
    static constexpr double kMissingOnMost = 0.02; ///< [own weight] allowed on all but `mayMove`

    std::size_t rounds = 0; ///< times that all have settled; the object is filled up in between
    bool settled = false;   ///< false: some still moved when they were frozen the last time
    double missing = 0;     ///< [own weight] that forces miss on a sphere in the end, at most
    double overlap = 0;     ///< [r] that was left, at most
    std::size_t moving = 0; ///< spheres on which more than kMissingOnMost was missing
    std::size_t mayMove = 0;
    /// [1] packing fraction of the bulk, if RestSettings asks for one and there is some bulk
    std::optional<double> fraction = {};
};

/// The heap below an inlet.
struct HeapReport
{
    std::size_t spheres = 0; ///< at rest, nearest to this inlet
    /// [degree] of its free surface: the angle of repose, where friction holds it and no wall does;
    /// none for a heap of a few radii
    std::optional<double> slope = {};
};

/// The quality of a state. Overlaps are penetration depths over the radius, the smaller one of two.
struct QualityReport
{
    double maxOverlap = 0;          ///< [r] between two spheres
    double meanOverlap = 0;         ///< [r] over all pairs that touch or overlap
    double maxWallOverlap = 0;      ///< [r] between a sphere and the mesh
    std::size_t centresOutside = 0; ///< by winding number
    std::size_t notFinite = 0;
    /// Spheres at rest whose contacts cannot carry their weight if nothing gives way: without
    /// friction, or with the one under which all settled or are judged.
    std::size_t unsupported = 0;
    double energyGain = 0;     ///< largest growth of the total energy in one step, relative to the
                               ///< energy of a fall through the height of the object
    double energyExcess = 0;   ///< largest excess of the energy over its start plus the work done,
                               ///< relative to the same
    double meshVolume = 0;     ///< [unit^3]
    double sphereVolume = 0;   ///< [unit^3] of all spheres
    double volumeEstimate = 0; ///< [unit^3] N v / phi + c r S; NaN unless full of equal spheres
    /// [unit^3] uncertainty: largest error over the calibration shapes, and scatter of packings
    double volumeEstimateError = 0;
    std::optional<EquilibriumReport> equilibrium; ///< if it is asked for: JudgeSettings::friction
    std::optional<SettlingReport> settling;       ///< of a run with Rest::joint
    std::vector<HeapReport> heaps;                ///< below the scene's inlets
};

/// A point of a size curve: what share of all spheres is no larger, of their mass and their number.
struct SizePoint
{
    double radius = 0;         ///< [mesh unit]
    double asked = 0;          ///< [1] of the mass
    double achieved = 0;       ///< [1]
    double askedNumber = 0;    ///< [1] of the number
    double achievedNumber = 0; ///< [1]
};

/// The size curve of a run beside the one that was asked for: see SizeSettings.
struct SizeReport
{
    std::vector<SizePoint> points; ///< ascending: the rows of the file, or even steps of a formula
    double deviation = 0;          ///< [1] of the mass, the largest at any of the points
    double at = 0;                 ///< [mesh unit] the radius of that point
};

/// What is wrong with a sphere that is where none can be.
enum class StrayKind
{
    outside,   ///< its centre is outside the object
    tooFast,   ///< faster than any fall in the object explains
    notFinite, ///< its position or velocity is no number
};

/// The sphere for which a run was stopped, in the step in which it was found.
struct StraySphere
{
    StrayKind kind = StrayKind::outside;
    std::size_t sphere = 0;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero(); ///< [unit] in the frame of the mesh
    double time = 0;                                  ///< [s]
};

/// A connected part of an object that no sphere of the radius covers.
struct UnreachableVolume
{
    double volume = 0;      ///< [unit^3]
    Eigen::Vector3d centre; ///< centre of mass; may lie outside a bent part
    Eigen::AlignedBox3d box;
};

/// The places that spheres of a radius can reach in an empty mesh. A sphere may be released
/// wherever it fits, so only a part that is itself too narrow counts as out of reach.
struct ReachInspection
{
    /// False if the mesh is too large for this radius and memory.
    bool known = false;
    bool fits = false;      ///< at least one sphere fits
    double unreachable = 0; ///< [unit^3] that no sphere covers, edges included; a lower bound
    double resolution = 0;  ///< [unit] of the inspection
    /// The parts larger than one sphere, largest first.
    std::vector<UnreachableVolume> parts;
};

/// `mesh` is closed and wound outwards. `bytes` limits the memory.
[[nodiscard]] ReachInspection inspectReach(const TriangleMesh& mesh, double radius,
                                           std::size_t bytes = std::size_t{256} << 20);

/// The columns on request that a scene asks for: see carriedColumns().
[[nodiscard]] std::vector<std::string> askedColumns(const Scene& scene);

/// Fills one mesh as a scene describes. PAPER: Algorithm 1 and the schedule of sets around it.
class Simulation
{
public:
    /// `mesh` is closed and wound outwards (see loadMesh). Throws Error usage for an invalid scene
    /// and badData for a mesh into which no sphere fits.
    Simulation(const Scene& scene, const TriangleMesh& mesh);
    /// The same, of a mesh as loadMesh or repairMesh returned it: its report spares an inspection.
    Simulation(const Scene& scene, const LoadedMesh& mesh);
    /// Another run in the same object, which is not prepared again: under other rules, say. Throws
    /// Error usage unless the scenes agree in the object, its axis, units and movement, in radii
    /// and count, and in gravity. Neither run knows of the other.
    Simulation(const Scene& scene, const Simulation& sameObject);
    ~Simulation();
    Simulation(Simulation&&) noexcept;
    Simulation& operator=(Simulation&&) noexcept;

    /// Advances by one time step, and releases and freezes when due.
    /// Returns false when the run is over; what nothing can touch any more is then discarded, and
    /// nothing moves.
    bool step();

    /// Asks this in the course of every step that takes long; once it is true the step ends early,
    /// with fewer spheres. To be called again and again, so it should take no time.
    void stopWhen(std::function<bool()> requested);

    /// Updates `snapshot`; see Snapshot for the cost.
    void capture(Snapshot& snapshot) const;
    /// All carried columns of the state as it is now, see columns.hpp.
    [[nodiscard]] std::vector<ColumnValues> columns() const;

    [[nodiscard]] bool finished() const;
    /// The sphere for which the run was stopped: a fault of the mesh or of ours. Preset fast only;
    /// with the paper's preset spheres may leave the object, and its judge counts them.
    [[nodiscard]] const std::optional<StraySphere>& stray() const;
    [[nodiscard]] bool full() const;          ///< the run is over because no sphere fits
    [[nodiscard]] bool inletsReached() const; ///< the run is over because the inlets are blocked
    [[nodiscard]] bool settles() const; ///< with Rest::joint: all run at once, and settle together
    [[nodiscard]] double time() const;  ///< [s] simulated
    [[nodiscard]] double timeStep() const;       ///< [s]
    [[nodiscard]] double radius() const;         ///< [mesh unit] the largest of the scene
    [[nodiscard]] double smallestRadius() const; ///< [mesh unit] the smallest of the scene
    [[nodiscard]] std::uint64_t steps() const;
    /// Grows whenever something changes that a snapshot shows: with every step, and when the end of
    /// a run discards more.
    [[nodiscard]] std::uint64_t revision() const;
    [[nodiscard]] std::size_t sphereCount() const;
    [[nodiscard]] std::size_t restingCount() const; ///< frozen and discarded
    [[nodiscard]] std::size_t groupSize() const;    ///< spheres in a group
    /// The target of the run: the count, or an estimate if it fills until full.
    [[nodiscard]] std::size_t expectedSpheres() const;

    /// [mesh unit] A largest radius with which so many spheres are expected to fit, several radii
    /// alike. Once the object is full, what did fit corrects the estimate.
    [[nodiscard]] double radiusThatFits(std::size_t count) const;

    /// The poses of a moving object from first to last; empty if the object does not move.
    [[nodiscard]] std::vector<Pose> poses() const;

    /// The object's report, see inspectInterior.
    [[nodiscard]] const MeshReport& object() const;
    [[nodiscard]] SphereRecord sphere(std::size_t id) const;
    /// [mesh unit] The same sphere's, without finding out what is discarded.
    [[nodiscard]] double radius(std::size_t id) const;
    [[nodiscard]] std::vector<PolygonState> polygonStates() const;
    [[nodiscard]] const OperationCounts& operations() const;
    [[nodiscard]] const StageTimes& times() const;
    [[nodiscard]] const std::vector<SetRecord>& sets() const;
    [[nodiscard]] QualityReport quality() const;
    /// The size curve as it is now; empty for a scene without one.
    [[nodiscard]] std::optional<SizeReport> sizes() const;
    /// Inspects the empty object with the smallest radius; see frostfill::inspectReach.
    [[nodiscard]] ReachInspection inspectReach(std::size_t bytes) const;

    /// Hash of the bits of all positions, and of which spheres are at rest, as 16 hex digits.
    [[nodiscard]] std::string stateHash() const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace frostfill
#pragma GCC visibility pop
