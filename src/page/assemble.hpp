// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/framing.hpp"
#include "run/run_head.hpp"
#include "shell/simplified_shell.hpp"

#include <frostfill/mesh.hpp>
#include <frostfill/run_file.hpp>

#include <nlohmann/json.hpp>

#include <span>
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

/// Where the object is in the picture at first: unit space, azimuth. All poses have to fit.
struct PageView
{
    RenderSettings settings;
    std::vector<Eigen::Vector3d> vertices; ///< of the mesh, in all poses
    Framing framing;
};
[[nodiscard]] PageView pageView(const RunHead& head, const TriangleMesh& mesh);

/// What the colour of a sphere at the speed of 255 stands for. [mesh unit/s]
[[nodiscard]] double fastestColour(const RunHead& head, const PageView& view);

/// What a page knows beside shape and states: colours, strokes, camera, summary. `sets` is the
/// text of sets.csv; empty if there is none. `carried`: columns of its spheres.
[[nodiscard]] nlohmann::ordered_json pageFacts(const RunFileReader& run, const RunHead& head,
                                               const PageView& view, const SimplifiedShell& shell,
                                               std::span<const ColumnValues> carried,
                                               const std::string& sets);

} // namespace frostfill
