// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/view.hpp>

#include <cstdlib>
#include <string>

namespace frostfill::test
{

/// The way in which a test draws: that of the default, which needs no OpenGL for most styles, or
/// OSMesa where FROSTFILL_TESTED_BACKEND says so. CTest runs each test of pictures in both ways.
inline Backend drawnWith()
{
    const char* name = std::getenv("FROSTFILL_TESTED_BACKEND");
    return name != nullptr && name == std::string("osmesa") ? Backend::osmesa : Backend::automatic;
}

} // namespace frostfill::test
