// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/analysis_input.hpp"

namespace frostfill
{

struct SampledPorosity
{
    PorosityProfiles profiles;
    /// [mesh unit] Height up to which the bed fills the object: of the lowest place in the object
    /// that is above the surface.
    double fullBelow = std::numeric_limits<double>::infinity();
};

/// All profiles of porosity by places that fill the box of the bed evenly [Halton 1960]. They fill
/// it several times, each time shifted at random, so that the scatter between the times is the
/// error [Cranley & Patterson 1976].
[[nodiscard]] SampledPorosity samplePorosity(const AnalysisInput& input, const ProfileFrame& frame);

} // namespace frostfill
