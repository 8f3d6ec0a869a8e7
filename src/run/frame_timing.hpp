// SPDX-License-Identifier: MIT
#pragma once

#include "scene/frame_selection.hpp"

#include <frostfill/mesh.hpp>
#include <frostfill/scene.hpp>
#include <frostfill/simulation.hpp>

#include <cstddef>
#include <functional>
#include <limits>

namespace frostfill
{

/// How long a run lasts: as it was, or by a trial run without pictures.
struct RunLength
{
    double seconds = 0; ///< simulated
    bool exact = false; ///< of the run itself, not of a smaller model of it
    /// The motion leaves out the falls, and it is known where spheres appear; only when exact.
    bool drawsFalls = false;
};

/// Whether spheres are simulated from where they begin to fall.
[[nodiscard]] bool hasFalls(const Scene& scene);

/// Whether a run is short enough to be its own trial, which `simulation` has not begun: then its
/// length is exact.
[[nodiscard]] bool isItsOwnTrial(const Scene& scene, const Simulation& simulation);

/// Makes a trial of the run of `simulation`, which has not begun: a run of up to some ten thousand
/// spheres itself, a larger one by a model of the same object with fewer and larger spheres.
/// Nothing is written, and `simulation` stays as it is. Ends early once `stopRequested` is true; it
/// may be empty. The time is that of a run without pictures, at most a few seconds.
[[nodiscard]] RunLength estimateRunLength(const Scene& scene, const TriangleMesh& mesh,
                                          const Simulation& simulation,
                                          const std::function<bool()>& stopRequested);

/// Which simulated times become pictures: frame i shows the first state at or after i * interval.
struct FrameTiming
{
    double slowMotion = 1; ///< [1] video time over simulated time
    /// [s] simulated, between two frames; the default never comes to a second frame
    double interval = std::numeric_limits<double>::max();
    /// [s] simulated, by which pictures show the run later, so that spheres which appear at their
    /// first contact can be seen falling; see FallingSpheres
    double lag = 0;
};

/// The scene's slow motion, or the one with which a run of so many simulated seconds takes the
/// scene's duration. Without either it is 20 s, or less where a fall through the object would take
/// more than 3 s of video. `falls`: those that the motion leaves out are drawn.
[[nodiscard]] FrameTiming frameTiming(const Scene& scene, const MeshReport& mesh, double seconds,
                                      bool falls = false);

/// Time of a fall through the object's height. [s]
[[nodiscard]] double fallTime(const Scene& scene, const MeshReport& mesh);

/// The pictures of a run, known before it begins.
struct FramePlan
{
    FrameTiming timing;
    std::size_t all = 0;    ///< frames of the whole animation, without what is held
    std::size_t held = 0;   ///< frames for which the last state is held
    std::size_t stride = 1; ///< every stride-th of the selected frames is kept as a picture
    std::size_t kept = 0;   ///< pictures
    double seconds = 0;     ///< [s] of video, of all frames that are selected
    double bytes = 0;       ///< of all pictures, roughly

    /// Pictures per second with which the kept ones play like the video.
    [[nodiscard]] double picturesPerSecond(double fps) const
    {
        return fps / static_cast<double>(stride);
    }
};

/// Nothing is kept without frames. The stride keeps the pictures within the limit; playback speed
/// does not depend on it.
[[nodiscard]] FramePlan planFrames(const Scene& scene, const MeshReport& mesh,
                                   const RunLength& length, double path = 0);

/// The frames of which the scene wants pictures; if it wants a single one, the last.
[[nodiscard]] FrameSelection framesToDraw(const Scene& scene);

/// The smallest stride with which so many frames stay within the limit; 0: no limit. `last`: the
/// last one is kept whatever its number.
[[nodiscard]] std::size_t strideFor(std::size_t frames, std::size_t limit, bool last);

/// Frames for which the last state is held.
[[nodiscard]] std::size_t heldFrames(const Scene& scene);

/// Frames of the camera's path of so many seconds, or else of a whole turn of the turntable.
[[nodiscard]] std::size_t turnFrames(const Scene& scene, double path);

/// The same if only the last state is drawn, and otherwise 0.
[[nodiscard]] std::size_t turnOfLast(const Scene& scene, double path);

} // namespace frostfill
