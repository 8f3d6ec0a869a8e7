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

std::string whyMissing(const std::filesystem::path& file)
{
    return std::filesystem::exists(file)
               ? std::string()
               : "a clone has no " + file.filename().string() + ": the mesh is not ours to give";
}

std::filesystem::path testOutput()
{
    return FROSTFILL_TEST_OUTPUT;
}

} // namespace frostfill::testing_support
