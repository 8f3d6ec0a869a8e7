// SPDX-License-Identifier: MIT
#pragma once

#include "study/error/tessellated_spheres.hpp"

#include <filesystem>

namespace frostfill::benchmark
{

/// What one would write first: every sphere an icosphere of 320 triangles with one light, all of
/// them drawn for every picture, and stb_image_write as it comes, in one thread.
class NaivePipeline
{
public:
    NaivePipeline(PictureSize size, int samples);

    /// Draws spheres around the origin that fill a unit cube.
    void draw(const Snapshot& snapshot, Image& image) { spheres_.draw(snapshot, image); }
    static void save(const Image& image, const std::filesystem::path& file);

private:
    TessellatedSpheres spheres_;
};

} // namespace frostfill::benchmark
