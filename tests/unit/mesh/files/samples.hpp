// SPDX-License-Identifier: MIT
#pragma once

#include "unit/mesh/files/mesh_texts.hpp"

#include <fstream>
#include <iterator>

namespace frostfill::test
{

/// A file of the folder samples.
inline std::string sample(const std::string& name)
{
    std::ifstream file(testing_support::sourceFolder() / "tests/unit/mesh/files/samples" / name,
                       std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

inline std::vector<std::string> vtkSamples()
{
    return {"appended.vtp", "raw.vtp",      "inline.vtp",   "strips.vtp",
            "grid.vtu",     "version4.vtk", "version5.vtk", "grid.vtk"};
}

} // namespace frostfill::test
