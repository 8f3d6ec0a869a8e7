// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/fill.hpp>

#include <optional>
#include <string>

namespace frostfill
{

/// Overlap of two spheres, or of a sphere with a wall, with which a run of preset fast has failed
/// [own radius]. Ours are rounding, 1e-7 at most, so this much is a fault.
inline constexpr double kFaultyOverlap = 1e-6;
/// The most that the packing fraction of the bulk may differ from one that is asked for [1].
inline constexpr double kFaultyFraction = 0.002;
/// Share of the spheres that may hang in the air at the end of a run of preset fast [1]. One sphere
/// may in any run.
inline constexpr double kFaultyHanging = 0.005;

/// What is wrong with the end of a run and what may help, in a sentence; none if nothing is. The
/// paper's preset leaves overlaps and spheres in the air by its nature, so there only numbers and
/// sides are judged. A run that was stopped, or with restitution 1, is not judged for support.
[[nodiscard]] std::optional<std::string> findFault(const Scene& scene, const FillResult& result,
                                                   bool blankPictures);

} // namespace frostfill
