// SPDX-License-Identifier: MIT
#pragma once

namespace frostfill
{

struct Twin
{
    int a = 0;
};

} // namespace frostfill
