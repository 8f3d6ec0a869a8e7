// SPDX-License-Identifier: MIT
#pragma once

#include "support/temporary_folder.hpp"

#include <cstddef>
#include <filesystem>
#include <string>

namespace frostfill::test
{

/// A script of /bin/sh that can be started by its path.
inline std::string writeProgram(const std::filesystem::path& file, const std::string& script)
{
    writeFile(file, "#!/bin/sh\n" + script);
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    return file.string();
}

/// Whether a process, named by what is in a file, runs: it is there and has not ended.
inline bool runs(const std::filesystem::path& fileOfItsNumber)
{
    std::string number = readFile(fileOfItsNumber);
    number.erase(number.find_last_not_of('\n') + 1);
    const std::string state = readFile("/proc/" + number + "/stat");
    const std::size_t name = state.rfind(") ");
    return name != std::string::npos && state[name + 2] != 'Z' && state[name + 2] != 'X';
}

/// Descriptors of this process that are open.
inline std::size_t openDescriptors()
{
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd"))
    {
        static_cast<void>(entry);
        ++count;
    }
    return count;
}

} // namespace frostfill::test
