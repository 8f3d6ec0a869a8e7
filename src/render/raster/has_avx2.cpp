// SPDX-License-Identifier: MIT
#include "render/raster/has_avx2.hpp"

#include "render/raster/lanes.hpp"

namespace frostfill::lanes
{

bool hasAvx2()
{
    return FROSTFILL_HAS_AVX2;
}

} // namespace frostfill::lanes
