// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <string>

namespace frostfill
{

/// Prints on standard error. That it cannot be read there is no reason to end a run.
inline void say(const std::string& text)
{
    std::fputs(text.c_str(), stderr);
}

} // namespace frostfill
