// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/framing.hpp"

#include <frostfill/mesh.hpp>

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace frostfill
{

/// The bulk data of a page, beside its facts: named byte sequences, which page/data.js separates.
using Sections = std::vector<std::pair<std::string, std::string>>;

/// All bytes of the sections one after another, as one zlib stream in base64.
[[nodiscard]] std::string packedText(const Sections& sections);

[[nodiscard]] std::string base64(std::string_view bytes);

/// The whole page: the files of page/ and the shaders, what is to be shown, and its facts. Adds to
/// the facts where each section begins.
[[nodiscard]] std::string assemblePage(nlohmann::ordered_json facts, const Sections& sections);

/// The shell as pictures draw it: corners with normals, triangles, and edges with what they are.
/// page/shell.js draws it.
[[nodiscard]] Sections shapeSections(const TriangleMesh& mesh, const Framing& framing);

} // namespace frostfill
