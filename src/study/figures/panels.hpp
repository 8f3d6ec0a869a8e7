// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/image.hpp>
#include <frostfill/mesh.hpp>
#include <frostfill/scene.hpp>
#include <frostfill/snapshot.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace frostfill
{

/// A state of a run, and how many tests the step that led to it made.
struct FigureState
{
    Snapshot snapshot;
    std::uint64_t sphereTests = 0;
};

/// The run's states when so many spheres (ascending) are present and the newest have been falling
/// for half the time of a fall through the object; the last state where the run ends before.
[[nodiscard]] std::vector<FigureState> statesOf(const Scene& scene, const TriangleMesh& mesh,
                                                std::span<const std::size_t> spheres);

/// The end of a run.
[[nodiscard]] FigureState endOf(const Scene& scene, const TriangleMesh& mesh);

/// Draws one state after another as the scene says.
[[nodiscard]] std::vector<Image> drawStates(const Scene& scene, const TriangleMesh& mesh,
                                            std::span<const FigureState> moments);

/// Puts pictures of one size side by side, row by row, each above a white strip so many pixels
/// high, where a script may write something.
[[nodiscard]] Image joinPanels(std::span<const Image> panels, std::size_t columns, int strip);

/// A scene's pictures as figures have them: square, small, no legend, in the look for print.
void makePanel(Scene& scene, int side);

} // namespace frostfill
