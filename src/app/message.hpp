// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <string>

namespace frostfill
{

/// Prints on standard error. A failure to print does not end a run.
inline void say(const std::string& text)
{
    std::fputs(text.c_str(), stderr);
}

} // namespace frostfill
