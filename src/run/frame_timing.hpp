// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>
#include <frostfill/scene.hpp>

#include <cstddef>

namespace frostfill
{

/// Which simulated times become pictures: frame i shows the first state at or after i * interval.
struct FrameTiming
{
    double slowMotion = 1; ///< [1] video time over simulated time
    double interval = 1;   ///< [s] simulated, between two frames
};

/// The scene's slow motion, or the one at which a fall through the object's height takes 1.5 s of
/// video.
[[nodiscard]] FrameTiming frameTiming(const Scene& scene, const MeshReport& mesh);

/// Time of a fall through the object's height. [s]
[[nodiscard]] double fallTime(const Scene& scene, const MeshReport& mesh);

/// What a run will write, roughly: before it starts nobody knows how long sets take to settle.
struct FrameEstimate
{
    std::size_t frames = 0;
    double bytes = 0; ///< of all frames
};
[[nodiscard]] FrameEstimate estimateFrames(const Scene& scene, const MeshReport& mesh,
                                           std::size_t spheres, double radius);

} // namespace frostfill
