// SPDX-License-Identifier: MIT
#pragma once

#include "output/scene_json.hpp"
#include "support/temporary_folder.hpp"
#include "unit/run_file/recorded_run.hpp"

#include <frostfill/export.hpp>
#include <frostfill/run_file.hpp>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace frostfill::test
{

inline Scene fewSpheres(bool moved = false)
{
    Scene scene = presetScene(Preset::fast, "torus");
    scene.spheres.count = 40;
    scene.spheres.groupSize = 5;
    scene.seed = 3; // the last step is no multiple of 20, after which a frame is recorded
    if (moved)
    {
        scene.move.tilt = 30;
        scene.move.turn = 40;
    }
    return scene;
}

/// Writes beside a run file what its frames hold, as JSON: the oracle of the readers. Places are
/// those of the world, with the pose applied anew.
inline void writeOracle(const std::filesystem::path& folder, std::uint32_t groupsPerSet)
{
    RunFileReader reader(folder / "run.frost");
    nlohmann::json frames = nlohmann::json::array();
    for (std::size_t k = 0; k < reader.frames().size(); ++k)
    {
        const Snapshot& state = reader.seek(k);
        const bool moved = !state.pose.rotation.isIdentity(0) || !state.pose.offset.isZero(0);
        nlohmann::json frame;
        frame["number"] = reader.frames()[k];
        frame["time"] = state.time;
        frame["step"] = state.step;
        frame["offset"] = {state.pose.offset.x(), state.pose.offset.y(), state.pose.offset.z()};
        for (int row = 0; row < 3; ++row)
        {
            frame["rotation"].push_back({state.pose.rotation(row, 0), state.pose.rotation(row, 1),
                                         state.pose.rotation(row, 2)});
        }
        for (std::size_t i = 0; i < state.states.size(); ++i)
        {
            const Eigen::Vector3d p = reader.centres()[i];
            const Eigen::Vector3d world =
                moved ? Eigen::Vector3d(state.origin + state.pose.offset +
                                        state.pose.rotation * (p - state.origin))
                      : p;
            frame["centres"].push_back({world.x(), world.y(), world.z()});
            frame["radii"].push_back(reader.radii()[i]);
            frame["waiting"].push_back(state.waits(i));
            frame["states"].push_back(static_cast<int>(state.states[i]));
            frame["groups"].push_back(state.groups[i]);
            frame["speeds"].push_back(state.speeds[i]);
            for (const ColumnValues& values : state.columns)
            {
                frame[values.column().plural].push_back(values.at(i));
            }
        }
        for (const PolygonState polygon : state.polygons)
        {
            frame["polygons"].push_back(static_cast<int>(polygon));
        }
        frames.push_back(frame);
    }
    nlohmann::json all = {{"frames", frames}, {"groups_per_set", groupsPerSet}};
    for (const Eigen::Vector3d& vertex : reader.mesh().vertices)
    {
        all["vertices"].push_back({vertex.x(), vertex.y(), vertex.z()});
    }
    all["triangles"] = reader.mesh().triangles;
    writeFile(folder / "oracle.json", all.dump());
}

/// Records a run with its oracle.
inline RecordedRun recordWithOracle(const Scene& scene, const std::filesystem::path& folder,
                                    const std::string& givenHead = "")
{
    const nlohmann::ordered_json head = {{"scene", sceneToJson(scene)}};
    const RecordedRun run = recordRun(scene, folder / "run.frost", 20, EarlierFile::replace,
                                      givenHead.empty() ? head.dump() : givenHead);
    writeOracle(folder, scene.spheres.groupsPerSet);
    return run;
}

} // namespace frostfill::test
