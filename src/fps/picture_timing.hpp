// SPDX-License-Identifier: MIT
#pragma once

#include "fps/fps_study.hpp"

#include <frostfill/mesh.hpp>

#include <memory>
#include <string>

namespace frostfill
{

/// Draws runs of one object in one style. Steps that follow each other in the middle of every set
/// are drawn, as a sequence of pictures is: the first ones bring up what is kept from picture to
/// picture and are not counted.
class PictureTiming
{
public:
    /// Throws Error noOpenGl.
    PictureTiming(const Scene& scene, const TriangleMesh& mesh);
    ~PictureTiming();

    /// Runs a scene of the same style once.
    [[nodiscard]] FpsPictures timeRun(const Scene& scene);
    /// The renderer's.
    [[nodiscard]] const std::string& description() const;

private:
    class Clock;
    const TriangleMesh& mesh_;
    std::unique_ptr<Clock> clock_;
};

} // namespace frostfill
