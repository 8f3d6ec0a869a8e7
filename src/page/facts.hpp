// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/framing.hpp"
#include "run/run_head.hpp"
#include "shell/simplified_shell.hpp"

#include <frostfill/run_file.hpp>

#include <nlohmann/json.hpp>

#include <span>
#include <string>

namespace frostfill
{

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
