// SPDX-License-Identifier: MIT
// Room: frames per second, measured as the paper does. Its tables show the figures of the paper
// beside ours.
#pragma once

#include "fps/repeats.hpp"

#include <frostfill/renderer.hpp>
#include <frostfill/scene.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace frostfill
{

/// How colliding pairs are found. The first four are the paper's method with the same result to the
/// last bit; the last is our own engine.
enum class FpsMethod : std::uint8_t
{
    loop, ///< PAPER: every polygon, every sphere
    list, ///< PAPER: polygons in a linked list
    tree, ///< PAPER: the quarter of the polygons ("Quad Tree")
    grid, ///< polygons and frozen spheres by the cells of uniform grids
    fast, ///< the preset fast
};
inline constexpr FpsMethod kFpsMethods[] = {FpsMethod::loop, FpsMethod::list, FpsMethod::tree,
                                            FpsMethod::grid, FpsMethod::fast};
[[nodiscard]] const char* methodName(FpsMethod method);

/// The scene as that method runs it.
[[nodiscard]] Scene sceneFor(const Scene& scene, FpsMethod method);

struct FpsRequest
{
    std::vector<Scene> scenes; ///< their preset is not looked at
    std::vector<FpsMethod> methods = {std::begin(kFpsMethods), std::end(kFpsMethods)};
    std::size_t repeats = 5;
    std::size_t warmUpSteps = 20; ///< at the start of every run, not counted
    bool pictures = true;
};

/// Milliseconds that a picture of a sequence takes, each of which shows the step after the one
/// before.
struct PictureMs
{
    double spheres = 0; ///< of drawing, without the shell and with one sample a pixel
    double samples = 0; ///< the same with all samples
    double render = 0;  ///< and with the shell: all there is to draw
    double readback = 0;
    double encode = 0; ///< as PNG, where only what has changed is compressed
    double osmesa = 0; ///< of drawing and reading back all of it with OSMesa; 0 where that is not

    PictureMs& operator+=(const PictureMs& other);
    [[nodiscard]] PictureMs over(double count) const;
};

/// The pictures of a run.
struct FpsPictures
{
    std::vector<PictureMs> sets; ///< in the middle of each set; empty when nothing was drawn
    PictureMs mean;              ///< of them
    double running = 0;          ///< spheres in them, on average
    double apart = 0;          ///< from those of OSMesa: the largest root of a mean square [of 255]
    std::string withoutOsmesa; ///< why there are none of OSMesa; empty if there are
};

/// One set of one method, over all repeats. Milliseconds a frame; a frame is one time step.
struct FpsSet
{
    std::uint32_t set = 0;
    std::uint32_t place = 1; ///< among the sets since the last freezing, from 1
    Distribution sphereSphere;
    Distribution spherePolygon;
    Distribution step; ///< all of the simulation's work
    // While it was the newest:
    std::size_t running = 0;
    std::size_t frozen = 0;
    std::size_t discarded = 0;
    std::size_t discardedPolygons = 0;
};

/// All sets at the same place between two freezings: what the paper reports.
struct FpsPlace
{
    std::uint32_t place = 1;
    std::size_t running = 0; ///< spheres, when it is full
    RepeatedMean spherePolygon;
    RepeatedMean sphereSphere;
};

struct FpsMethodResult
{
    FpsMethod method = FpsMethod::loop;
    Distribution sphereSphere; ///< [ms] over all frames that count
    Distribution spherePolygon;
    Distribution step;
    RepeatedMean sphereSphereMean; ///< [ms] of the runs' means
    RepeatedMean spherePolygonMean;
    RepeatedMean stepMean;
    std::vector<FpsPlace> places; ///< empty for FpsMethod::fast, which freezes one by one
    std::vector<FpsSet> sets;
    std::size_t frozen = 0; ///< at the end
    std::size_t discarded = 0;
    std::size_t discardedPolygons = 0;
    std::string stateHash;
};

struct FpsObject
{
    Scene scene;
    std::size_t triangles = 0;
    std::size_t spheres = 0;
    double radius = 0; ///< [mesh unit]
    std::vector<FpsMethodResult> methods;
    FpsPictures paperPictures; ///< of the paper's method, which are the same for all its searches
    FpsPictures fastPictures;
    /// Of that method; null when nothing was drawn.
    [[nodiscard]] const FpsPictures* picturesOf(FpsMethod method) const;
};

struct FpsResult
{
    FpsRequest request;
    std::vector<FpsObject> objects;
    std::string renderer; ///< empty when nothing was drawn
};

/// Frames a second of the simulation alone and with ever more of what makes a picture file.
struct FramesPerSecond
{
    double simulation = 0;
    double drawing = 0;
    double readback = 0;
    double png = 0;
};
/// The last three are 0 without a picture.
[[nodiscard]] FramesPerSecond framesPerSecond(double stepMs, const PictureMs* picture);

/// Runs everything; `say` hears what is being done. Throws Error.
[[nodiscard]] FpsResult measureFps(const FpsRequest& request,
                                   const std::function<void(const std::string&)>& say);

} // namespace frostfill
