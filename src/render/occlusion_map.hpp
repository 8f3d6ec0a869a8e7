// SPDX-License-Identifier: MIT
#pragma once

#include "projected_sphere.hpp"

#include <vector>

namespace frostfill
{

/// The furthest depth in each small block of a picture. What is further in all the blocks that it
/// can be seen in is hidden, and stays so for as long as nothing is taken away and the camera is
/// still.
class OcclusionMap
{
public:
    OcclusionMap(int width, int height);

    /// From now on nothing is hidden.
    void clear() { known_ = false; }
    /// `depth` is [height x width], bottom row first.
    void build(const std::vector<float>& depth);
    [[nodiscard]] bool hides(const ProjectedSphere& sphere) const;

private:
    int width_;
    int height_;
    int columns_;
    bool known_ = false;
    std::vector<float> furthest_; ///< [rows x columns]
};

} // namespace frostfill
