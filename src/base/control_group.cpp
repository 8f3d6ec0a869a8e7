// SPDX-License-Identifier: MIT
#include "base/control_group.hpp"

#include <fstream>
#include <string>

namespace frostfill
{

std::vector<std::filesystem::path> controlGroups(std::string_view controller,
                                                 const std::filesystem::path& root)
{
    std::vector<std::filesystem::path> folders;
    std::ifstream groups(root / "proc/self/cgroup");
    // "4:memory:/a/b" is version 1, "0::/a/b" version 2.
    for (std::string line; std::getline(groups, line);)
    {
        const std::size_t first = line.find(':');
        const std::size_t second = line.find(":/", first + 1);
        if (first == std::string::npos || second == std::string::npos)
        {
            continue;
        }
        const std::string controllers = line.substr(first + 1, second - first - 1);
        if (!controllers.empty() && controllers != controller)
        {
            continue;
        }
        const std::filesystem::path mounted = root / "sys/fs/cgroup" / controllers;
        for (std::filesystem::path group = line.substr(second + 2);; group = group.parent_path())
        {
            folders.push_back(mounted / group);
            if (group.empty())
            {
                break;
            }
        }
    }
    return folders;
}

} // namespace frostfill
