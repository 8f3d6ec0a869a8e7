// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/pixel_rectangle.hpp"

#include <span>
#include <vector>

namespace frostfill
{

/// The parts of a picture that have to be renewed: a few disjoint rectangles that cover all that
/// were added. Each costs calls of OpenGL, so that near ones are joined, at the price of pixels
/// between them that are renewed for nothing.
class DirtyRectangles
{
public:
    /// Takes the part of it that lies within the picture.
    DirtyRectangles(int width, int height) : picture_{0, 0, width, height} {}

    void clear() { rectangles_.clear(); }
    void add(const PixelRectangle& rectangle);
    void add(std::span<const PixelRectangle> rectangles);
    void addAll();

    /// Joins until the rectangles are disjoint and few, and returns them.
    [[nodiscard]] const std::vector<PixelRectangle>& joined();
    [[nodiscard]] bool empty() const { return rectangles_.empty(); }

private:
    PixelRectangle picture_;
    std::vector<PixelRectangle> rectangles_;
};

} // namespace frostfill
