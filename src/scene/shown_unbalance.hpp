// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/scene.hpp>

namespace frostfill
{

/// Whether spheres are coloured by what the judge finds of all of them together. Nothing else that
/// a run draws or keeps depends on the settings of the judge.
[[nodiscard]] inline bool showsUnbalance(const Scene& scene)
{
    return scene.style.colourBy == "unbalance";
}

} // namespace frostfill
