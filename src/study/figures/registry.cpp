// SPDX-License-Identifier: MIT
#include "study/figures/all_figures.hpp"

#include <array>

namespace frostfill
{

std::span<const Figure> allFigures()
{
    static const std::array kFigures = {
        claimFigure(), timesFigure(), operationsFigure(), discardedFigure(), densityFigure(),
    };
    return kFigures;
}

} // namespace frostfill
