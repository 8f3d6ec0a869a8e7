// SPDX-License-Identifier: MIT
#include "app/text/shell_text.hpp"

#include <fmt/format.h>

namespace frostfill
{

std::string describe(const ShellInFile& shell)
{
    if (shell.triangles == 0 || shell.triangles == shell.meshTriangles)
    {
        return "";
    }
    return fmt::format("; the shell has {} of {} triangles and is within {:.2g} of the mesh "
                       "(--full-mesh keeps all)",
                       shell.triangles, shell.meshTriangles, shell.distance);
}

} // namespace frostfill
