// SPDX-License-Identifier: MIT
// Room: what there is (the object, the spheres, the grids), how far the run has come, and what was
// counted. Engines change it; all other code only reads it.
#pragma once

#include "base/resources.hpp"
#include "mesh/interior/inside_test.hpp"
#include "mesh/interior/triangle_grid.hpp"
#include "scene/radius_distribution.hpp"
#include "simulation/world/frame_of_run.hpp"
#include "simulation/world/run_counts.hpp"
#include "simulation/world/spheres.hpp"

#include <frostfill/mesh.hpp>
#include <frostfill/scene.hpp>
#include <frostfill/simulation.hpp>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace frostfill
{

/// What a run knows of its object before the first sphere. It never changes, so runs that differ in
/// their rules only share it.
struct ObjectOfRun
{
    /// `known` is what inspectMesh says of the mesh, if that is known.
    ObjectOfRun(const Scene& scene, const TriangleMesh& mesh, const MeshReport* known = nullptr);
    ObjectOfRun(const ObjectOfRun&) = delete; // inside and triangles point to the surface
    ObjectOfRun& operator=(const ObjectOfRun&) = delete;

    Walls walls;              ///< of the mesh as given
    MeshReport report;        ///< of the mesh as given, with the volume of its interior
    RadiusDistribution radii; ///< in mesh units
    FrameOfRun frame;
    Surface surface;
    TriangleGrid triangles; ///< within reach 1.5 of each cell
    InsideTest inside;

private:
    ObjectOfRun(const Scene& scene, const TriangleMesh& mesh, const MeshReport* known,
                MeshIndex index);
};

/// The object and the spheres, in coordinates of the run; and by name what is none of both: the
/// clock, the counts and who may stop the run. An Engine changes it, all other code only reads it.
struct World
{
    World(const Scene& sceneOfRun, const TriangleMesh& mesh);
    /// Of a mesh that has been inspected.
    World(const Scene& sceneOfRun, const LoadedMesh& mesh);
    /// Of an object that a scene with the same object, radii, gravity and motion of the object
    /// made.
    World(const Scene& sceneOfRun, std::shared_ptr<const ObjectOfRun> sharedObject);
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    // The object.
    Scene scene;
    std::shared_ptr<const ObjectOfRun> object;
    const MeshReport& report; // these are the object's
    const FrameOfRun& frame;
    const Surface& surface;
    const TriangleGrid& triangles;
    const InsideTest& inside;
    RadiusDistribution radii; ///< in the largest radius, which is the run's unit of length
    double height = 0;        ///< of the object [r]
    ObjectMotion motion;      ///< of the object, from motionStart on
    double motionStart = std::numeric_limits<double>::infinity();
    Pull pull; ///< at this time

    // What is in it.
    Spheres spheres;
    /// By id, how each has turned since it appeared, in run coordinates; those beyond the end have
    /// not. Only if the scene asks for it.
    std::vector<Eigen::Quaterniond> orientations;
    std::vector<PolygonState> polygons;
    std::size_t discardedPolygons = 0;
    std::size_t targetCount = 0; ///< spheres after which no set appears any more; 0: until full

    RunClock clock;
    RunCounts counts;
    StopRequest stop;

    void discardPolygon(std::uint32_t polygon);
};

/// Spheres that the run aims at: the count, or the wall-corrected estimate of how many fit.
[[nodiscard]] std::size_t expectedCount(const World& world);

/// PAPER: gamma. Spheres in a group: the scene's, or, when that is 0, 10 or as many as make a set
/// cover a tenth of the object's mean cross-section, or pour into it in the scene's duration.
[[nodiscard]] std::size_t groupSize(const World& world);

/// Of a set of this size, how many spheres are to appear: no more than the count still lacks.
[[nodiscard]] std::size_t wantedOfSet(const World& world, std::size_t size);

/// Spheres side by side that cover the object's mean cross-section.
[[nodiscard]] double spheresInLayer(const World& world);

/// Throws Error badData: not one sphere of the run's smallest radius fits into the object. Names a
/// radius that does.
[[noreturn]] void refuseTooLarge(const World& world);

/// A sphere that appears where it is told to. Units of the run.
struct PlacedSphere
{
    Eigen::Vector3d place;
    double radius = 1;
};

/// Throws Error badData, naming the first, when a centre is not inside the object.
void requireInside(const World& world, std::span<const PlacedSphere> spheres);
/// Throws Error badData: there is no room for the sphere near its place.
[[noreturn]] void refuseOverlap(const World& world, const PlacedSphere& sphere);

/// Moves a world. One time step of the paper's method, or of ours.
class Engine
{
public:
    virtual ~Engine() = default;
    /// Before the first step: one set of spheres that appear where they are told to, whatever is
    /// there. Throws Error badData for a centre that is not inside the object.
    virtual void releaseAt(std::span<const PlacedSphere> spheres) = 0;
    /// See Simulation::step.
    virtual bool step() = 0;
};

/// See Simulation::radiusThatFits. [mesh unit]
[[nodiscard]] double radiusThatFits(const World& world, std::size_t count);

/// Of an object, in radii of its spheres.
struct ObjectSize
{
    explicit ObjectSize(const TriangleMesh& inRadii)
        : box(boundingBox(inRadii).sizes()), volume(std::abs(signedVolume(inRadii))),
          area(surfaceArea(inRadii))
    {
    }
    ObjectSize(const MeshReport& object, double radius)
        : box(object.box.sizes() / radius),
          volume(std::abs(object.volume) / (radius * radius * radius)),
          area(object.area / (radius * radius))
    {
    }
    /// Cells of a radius that its grids have: inside and within reach of the walls, at most all of
    /// the box.
    [[nodiscard]] double cells() const;
    /// Those within reach of the walls.
    [[nodiscard]] double wallCells() const;

    Eigen::Vector3d box;
    double volume;
    double area;
};

/// A lower bound of what so many spheres and the grids of their object take [bytes].
[[nodiscard]] double memoryNeed(const ObjectSize& object, double spheres);

/// Throws Error outOfMemory, before anything is set aside, when a run surely takes more than
/// the memory at hand, and names a radius that does not. `radius` is the largest of the run,
/// `spheres` how many it aims at.
void requireMemory(const Scene& scene, const MeshReport& object, double radius, double spheres,
                   const MemoryAtHand& memory);

} // namespace frostfill
