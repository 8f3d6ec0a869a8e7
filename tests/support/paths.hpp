// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace frostfill::testing_support
{

/// The project's root.
[[nodiscard]] std::filesystem::path sourceFolder();

/// Meshes that a clone may lack; who needs them skips with the reason when they are not there.
[[nodiscard]] std::filesystem::path sharedMeshes();

/// Why a test that needs this file is skipped; empty when the file is there.
[[nodiscard]] std::string whyMissing(const std::filesystem::path& file);

/// Where tests may write.
[[nodiscard]] std::filesystem::path testOutput();

} // namespace frostfill::testing_support
