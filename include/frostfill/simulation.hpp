// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/measure.hpp>
#include <frostfill/mesh.hpp>
#include <frostfill/scene.hpp>
#include <frostfill/snapshot.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace frostfill
{

/// What happened while one set was the newest.
struct SetRecord
{
    std::uint32_t set = 0;
    std::size_t spheres = 0; ///< that appeared with it
    std::uint64_t steps = 0;
    double simulatedSeconds = 0;
    double meanSphereSphereMs = 0; ///< a step
    double p95SphereSphereMs = 0;
    double meanSpherePolygonMs = 0;
    double p95SpherePolygonMs = 0;
    StageTimes times;        ///< of the simulation's stages, in all
    std::size_t running = 0; ///< counts at the set's end, after freezing and discarding
    std::size_t frozen = 0;
    std::size_t discarded = 0;
    std::size_t discardedPolygons = 0;
    bool timedOut = false; ///< did not come to rest within the limit
    OperationCounts operations;
};

/// How good the state is. Overlaps are penetration depths over the radius, of two the smaller.
struct QualityReport
{
    double maxOverlap = 0;          ///< [r] between two spheres
    double meanOverlap = 0;         ///< [r] over the pairs that touch or overlap
    double maxWallOverlap = 0;      ///< [r] between a sphere and the mesh
    std::size_t centresOutside = 0; ///< by winding number
    std::size_t notFinite = 0;
    std::size_t unsupported = 0; ///< at rest, but gravity leaves the cone of its contacts
    double energyGain = 0;   ///< largest growth of total energy in a step over the run, relative to
                             ///< the energy of a fall through the object's height
    double energyExcess = 0; ///< by how much it was at most above its start plus the work done on
                             ///< it, relative to the same
    std::size_t restoredDiscards = 0; ///< times that a guard brought back all that was discarded
    double meshVolume = 0;            ///< [unit^3]
    double sphereVolume = 0;          ///< [unit^3] of all spheres
    double volumeEstimate = 0; ///< [unit^3] N v / phi + c r S; NaN unless full of equal spheres
    /// [unit^3] uncertainty: largest error over the calibration's shapes, and scatter of packings
    double volumeEstimateError = 0;
};

/// A connected part of an object that no sphere of a radius covers any of.
struct UnreachableVolume
{
    double volume = 0;      ///< [unit^3]
    Eigen::Vector3d centre; ///< of mass; may lie outside a bent part
    Eigen::AlignedBox3d box;
};

/// Where spheres of a radius can be in a mesh, before any is there. A sphere may be released
/// wherever it fits, so a part counts as out of reach only when it is too narrow itself.
struct ReachInspection
{
    /// False when the mesh is too large against the radius to be looked at within the memory.
    bool known = false;
    /// A point in a hole through which such a sphere gets out; the rest says nothing then.
    std::optional<Eigen::Vector3d> leak;
    bool fits = false;      ///< at least one sphere does
    double unreachable = 0; ///< [unit^3] that no sphere covers, narrow edges included; at least
    double resolution = 0;  ///< [unit] to which that is known
    /// Those larger than one sphere, largest first.
    std::vector<UnreachableVolume> parts;
};

/// `mesh` may have holes. `bytes`: memory that may be used.
[[nodiscard]] ReachInspection inspectReach(const TriangleMesh& mesh, double radius,
                                           std::size_t bytes = std::size_t{256} << 20);

/// Fills one mesh according to one scene. PAPER: Algorithm 1 and the schedule of sets around it.
class Simulation
{
public:
    /// `mesh` is closed and outward (see loadMesh). Throws Error usage for a scene that makes no
    /// sense and badData for a mesh into which not one sphere fits.
    Simulation(const Scene& scene, const TriangleMesh& mesh);
    ~Simulation();
    Simulation(Simulation&&) noexcept;
    Simulation& operator=(Simulation&&) noexcept;

    /// Advances by one time step; releases, freezes and discards when it is time to.
    /// Returns false when the run is over (and then changes nothing).
    bool step();

    /// Brings `snapshot` up to date; see Snapshot for what that costs.
    void capture(Snapshot& snapshot) const;

    [[nodiscard]] bool finished() const;
    [[nodiscard]] bool full() const;       ///< the run is over because no sphere fits any more
    [[nodiscard]] double time() const;     ///< [s] simulated
    [[nodiscard]] double timeStep() const; ///< [s]
    [[nodiscard]] double radius() const;   ///< [mesh unit] the largest that the scene asks for
    [[nodiscard]] double smallestRadius() const; ///< [mesh unit] that the scene asks for
    [[nodiscard]] std::uint64_t steps() const;
    [[nodiscard]] std::size_t sphereCount() const;
    [[nodiscard]] std::size_t restingCount() const; ///< frozen and discarded
    [[nodiscard]] std::size_t groupSize() const;    ///< spheres that form a group
    /// Spheres that the run aims at: the count, or an estimate when it fills until full.
    [[nodiscard]] std::size_t expectedSpheres() const;

    /// How an object that moves will stand, from the first to the last; none when it does not.
    [[nodiscard]] std::vector<Pose> poses() const;

    [[nodiscard]] SphereRecord sphere(std::size_t id) const;
    [[nodiscard]] std::vector<PolygonState> polygonStates() const;
    [[nodiscard]] const OperationCounts& operations() const;
    [[nodiscard]] const StageTimes& times() const;
    [[nodiscard]] const std::vector<SetRecord>& sets() const;
    [[nodiscard]] QualityReport quality() const;
    /// Of the empty object, for the smallest radius; see frostfill::inspectReach.
    [[nodiscard]] ReachInspection inspectReach(std::size_t bytes) const;

    /// Hash of all positions, bit for bit, and of which spheres are at rest, as 16 hex digits.
    [[nodiscard]] std::string stateHash() const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace frostfill
