// SPDX-License-Identifier: MIT
#include <frostfill/columns.hpp>
#include <frostfill/simulation.hpp>

namespace frostfill
{

std::vector<std::string> askedColumns(const Scene& scene)
{
    std::vector<std::string> asked = {scene.style.colourBy};
    if (scene.rest.orientation)
    {
        asked.emplace_back(kOrientation);
    }
    return asked;
}

} // namespace frostfill
