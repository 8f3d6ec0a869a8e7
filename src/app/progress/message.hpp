// SPDX-License-Identifier: MIT
// Room: what a command says while it works, and how it is stopped.
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
