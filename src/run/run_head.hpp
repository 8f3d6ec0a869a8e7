// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/scene.hpp>
#include <frostfill/simulation.hpp>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace frostfill
{

/// From which the meaning of colours follows, over the whole run.
struct ColourFacts
{
    double groups = 1;      ///< that are expected
    double fallSeconds = 0; ///< of a fall through the object
    ColourRange radii = {}; ///< [mesh unit] the smallest and the largest
};

[[nodiscard]] ColourFacts colourFacts(const Scene& scene, const Simulation& simulation);

/// Of what the colours of spheres mean over the whole run, so that a colour never changes its
/// meaning. Sets and groups are counted from 0. [1], for speeds [m/s]
[[nodiscard]] ColourRange colourRange(const Scene& scene, const ColourFacts& facts);

/// What a run file says of its run before the first frame: all that a picture needs beside mesh and
/// states, and all that it takes to resume the run.
struct RunHead
{
    Scene scene;
    std::vector<std::string> repairs; ///< of the mesh
    std::size_t lidTriangles = 0;     ///< the last of the mesh
    std::vector<MeshPatch> patches;   ///< the first of the mesh
    std::string video;                ///< file, absolute; empty for none
    ColourFacts colours;
    double interval = 0;     ///< [s] simulated, between two frames
    std::size_t stride = 1;  ///< every stride-th frame is kept as a picture
    std::vector<Pose> poses; ///< of a moving object, that have to fit into the picture
    std::string version;     ///< of the program
    /// The file of another program that the run was read from; empty for a run of our own.
    std::string importedFrom;
};

/// Returns the rotation row by row, then the offset.
[[nodiscard]] nlohmann::ordered_json poseToJson(const Pose& pose);

/// JSON.
[[nodiscard]] std::string headText(const RunHead& head);
/// Throws Error badData.
[[nodiscard]] RunHead readHead(const std::string& text, const std::string& nameForMessages);

} // namespace frostfill
