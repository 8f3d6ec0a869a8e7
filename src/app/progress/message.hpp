// SPDX-License-Identifier: MIT
// Room: what a command says while it works, and how it is stopped.
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>

namespace frostfill
{

/// Prints on standard error. A failure to print does not end a run.
inline void say(const std::string& text)
{
    std::fputs(text.c_str(), stderr);
}

/// "1 frame", "2 frames".
inline std::string counted(std::size_t count, const char* noun)
{
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

} // namespace frostfill
