// SPDX-License-Identifier: MIT
#include "study/figures/all_figures.hpp"

#include <array>

namespace frostfill
{

std::span<const Figure> allFigures()
{
    static const std::array kFigures = {
        torusFigure(),       studioFigure(),   volumeFigure(),     interactionFigure(),
        timesFigure(),       claimFigure(),    operationsFigure(), discardedFigure(),
        closenessFigure(),   densityFigure(),  fillingFigure(),    cutawaysFigure(),
        closedFormsFigure(), errorFigure(),    stabilityFigure(),  trianglesFigure(),
        sizesFigure(),       frictionFigure(),
    };
    return kFigures;
}

} // namespace frostfill
