// SPDX-License-Identifier: MIT
#pragma once

#include "study/figures/figure.hpp"

namespace frostfill
{

[[nodiscard]] Figure torusFigure();       ///< a picture alone
[[nodiscard]] Figure studioFigure();      ///< a picture alone
[[nodiscard]] Figure volumeFigure();      ///< PAPER, Figure 1
[[nodiscard]] Figure interactionFigure(); ///< PAPER, Figure 2
[[nodiscard]] Figure fillingFigure();     ///< the objects while they fill
[[nodiscard]] Figure cutawaysFigure();    ///< the objects cut open
[[nodiscard]] Figure claimFigure();       ///< cost of a frame against spheres present
[[nodiscard]] Figure timesFigure();       ///< PAPER, Figure 3
[[nodiscard]] Figure operationsFigure();  ///< the lemmas
[[nodiscard]] Figure discardedFigure();   ///< share of what is discarded
[[nodiscard]] Figure closenessFigure();   ///< covered polygons: closeness against escapes
[[nodiscard]] Figure closedFormsFigure(); ///< errors against closed forms
[[nodiscard]] Figure errorFigure();       ///< run time against error
[[nodiscard]] Figure peersFigure();       ///< other engines beside ours
[[nodiscard]] Figure stabilityFigure();   ///< the stress matrix
[[nodiscard]] Figure densityFigure();     ///< density against set size
[[nodiscard]] Figure sizesFigure();       ///< size curves as asked and as achieved
[[nodiscard]] Figure frictionFigure();    ///< packing fraction and contacts against friction
[[nodiscard]] Figure trianglesFigure();   ///< cost against the number of triangles

} // namespace frostfill
