// SPDX-License-Identifier: MIT
#include "render/raster/vector_width.hpp"

#include "render/raster/lanes.hpp"

namespace frostfill::lanes
{

bool& usesAvx2()
{
    static bool uses = FROSTFILL_HAS_AVX2;
    return uses;
}

} // namespace frostfill::lanes
