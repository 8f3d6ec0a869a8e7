// SPDX-License-Identifier: MIT
#include "support/paths.hpp"

namespace frostfill::testing_support
{

std::filesystem::path sourceFolder()
{
    return FROSTFILL_SOURCE_DIR;
}

std::filesystem::path sharedMeshes()
{
    return FROSTFILL_SHARED_MESHES;
}

std::filesystem::path testOutput()
{
    return FROSTFILL_TEST_OUTPUT;
}

} // namespace frostfill::testing_support
