// SPDX-License-Identifier: MIT
#include <frostfill/view.hpp>

namespace frostfill
{
namespace
{

// Outlines show the shapes, so the colours can be light, which suits print.
constexpr Palette kPaper = {.background = {255, 255, 255, 255},
                            .running = {230, 159, 0, 255},
                            .frozen = {64, 140, 196, 255},
                            .discarded = {221, 221, 221, 255},
                            .activePolygon = {130, 140, 150, 34},
                            .discardedPolygon = {204, 121, 167, 120},
                            .text = {0, 0, 0, 255}};

constexpr Palette kDark = {.background = {18, 22, 28, 255},
                           .running = {240, 176, 32, 255},
                           .frozen = {44, 132, 205, 255},
                           .discarded = {118, 124, 132, 255},
                           .activePolygon = {130, 190, 235, 40},
                           .discardedPolygon = {220, 130, 180, 110},
                           .text = {226, 230, 235, 255}};

constexpr Palette kStudio = {.background = {246, 246, 244, 255},
                             .running = {238, 162, 20, 255},
                             .frozen = {24, 122, 190, 255},
                             .discarded = {205, 203, 198, 255},
                             .activePolygon = {86, 160, 205, 30},
                             .discardedPolygon = {204, 121, 167, 60},
                             .text = {40, 40, 40, 255}};

} // namespace

Palette paletteOf(Look look)
{
    switch (look)
    {
    case Look::paper:
        return kPaper;
    case Look::dark:
        return kDark;
    case Look::studio:
        return kStudio;
    case Look::clean:
        break;
    }
    return {};
}

} // namespace frostfill
