// SPDX-License-Identifier: MIT
#pragma once

namespace frostfill
{

struct Twin
{
    double b = 0;
};

} // namespace frostfill
