// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/analysis_input.hpp"

namespace frostfill
{

/// All profiles of porosity by places that fill the box of the object evenly [Halton 1960]. They
/// fill it several times, each time shifted at random, so that the scatter between the times is the
/// error [Cranley & Patterson 1976].
[[nodiscard]] PorosityProfiles samplePorosity(const AnalysisInput& input,
                                              const ProfileFrame& frame);

} // namespace frostfill
