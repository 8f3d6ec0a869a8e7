// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace frostfill::testing_support
{

/// The project's root.
[[nodiscard]] std::filesystem::path sourceFolder();

/// Meshes that a clone may lack; who needs them skips with the reason when they are not there.
[[nodiscard]] std::filesystem::path sharedMeshes();

/// Where tests may write.
[[nodiscard]] std::filesystem::path testOutput();

} // namespace frostfill::testing_support
