// SPDX-License-Identifier: MIT
#include "render/raster/lanes/has_avx2.hpp"

#include "render/raster/lanes/lanes.hpp"

namespace frostfill::lanes
{

bool hasAvx2()
{
    return FROSTFILL_HAS_AVX2;
}

} // namespace frostfill::lanes
