// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <optional>
#include <string>

namespace frostfill
{

/// What makes it no mesh at all, in words: a vertex that is not finite or too far
/// away to compute with, or a triangle of a vertex
/// that there is not. Numbers in the words count from 1.
[[nodiscard]] std::optional<std::string> findInvalidData(const TriangleMesh& mesh);

} // namespace frostfill
