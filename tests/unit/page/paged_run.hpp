// SPDX-License-Identifier: MIT
#pragma once

#include "run/run_head.hpp"
#include "unit/export/exported_run.hpp"

#include <frostfill/page.hpp>

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace frostfill::test
{

/// A head as `fill` writes it.
inline std::string headOf(const Scene& scene)
{
    RunHead head;
    head.scene = scene;
    head.interval = 0.1;
    head.version = "test";
    head.colours = {40, 1};
    return headText(head);
}

/// Records a run of which pages can be made, with oracle.json beside it.
inline RecordedRun recordForPage(const std::filesystem::path& folder, bool moved = false)
{
    const Scene scene = fewSpheres(moved);
    return recordWithOracle(scene, folder, headOf(scene));
}

/// A run in which everything happens that can happen to spheres: they appear in any state, wait,
/// run, come to rest, are dropped, wake, give their number away and are withdrawn.
class EventfulRun
{
public:
    explicit EventfulRun(const std::filesystem::path& folder)
        : mesh_(loadMesh("torus").mesh),
          writer_(folder / "run.frost", headOf(fewSpheres()), mesh_, 1)
    {
        snapshot_.columns = carriedColumns();
        snapshot_.origin = boundingBox(mesh_).center();
        snapshot_.polygons.assign(mesh_.triangles.size(), PolygonState::active);
        for (std::size_t frame = 0; frame < 60; ++frame)
        {
            happen();
            if (frame % 7 == 5)
            {
                writer_.repeat(frame);
                continue;
            }
            snapshot_.changed.resize(radii_.size());
            std::iota(snapshot_.changed.begin(), snapshot_.changed.end(), 0U);
            snapshot_.polygonsChanged = true;
            snapshot_.time = 0.1 * static_cast<double>(frame);
            writer_.put(frame, snapshot_,
                        [&](std::uint32_t id)
                        {
                            SphereRecord sphere;
                            sphere.centre = snapshot_.origin + snapshot_.centres[id].cast<double>();
                            sphere.radius = radii_[id];
                            return sphere;
                        });
        }
        writer_.finish(R"({"outcome": "complete"})");
        writeOracle(folder, 1);
    }

private:
    double random(double high) { return std::uniform_real_distribution<>(0, high)(numbers_); }
    bool happens(double share) { return random(1) < share; }

    void happen()
    {
        for (int i = 0; i < 3 && happens(0.7); ++i)
        {
            appear();
        }
        for (std::size_t id = 0; id < radii_.size(); ++id)
        {
            change(id);
        }
        if (radii_.size() > 3 && happens(0.4))
        {
            withdraw(static_cast<std::size_t>(random(static_cast<double>(radii_.size()))));
        }
        for (PolygonState& state : snapshot_.polygons)
        {
            state = happens(0.01) ? PolygonState::discarded : state;
            state = happens(0.002) ? PolygonState::active : state;
        }
        snapshot_.discardedPolygons = static_cast<std::size_t>(std::count(
            snapshot_.polygons.begin(), snapshot_.polygons.end(), PolygonState::discarded));
    }
    void appear()
    {
        radii_.push_back(1 + random(1));
        snapshot_.centres.emplace_back(random(30), random(30), random(30));
        snapshot_.radii.push_back(static_cast<float>(radii_.back()));
        const bool waits = happens(0.3);
        snapshot_.waiting.push_back(waits ? 1 : 0);
        snapshot_.states.push_back(
            waits ? SphereState::running
                  : static_cast<SphereState>(static_cast<std::uint8_t>(random(2.99))));
        snapshot_.groups.push_back(static_cast<std::uint32_t>(random(9)));
        snapshot_.speeds.push_back(0);
        contacts().push_back(0);
        renewSpeed(radii_.size() - 1);
    }
    void change(std::size_t id)
    {
        SphereState& state = snapshot_.states[id];
        snapshot_.waiting[id] = happens(0.4) ? 0 : snapshot_.waiting[id];
        const bool waits = snapshot_.waits(id);
        if (state == SphereState::running && !waits)
        {
            snapshot_.centres[id] += Eigen::Vector3f(0.1F, -0.4F, 0.05F);
            state = happens(0.2) ? SphereState::frozen : state;
        }
        else if (!waits && happens(0.2))
        {
            state = state == SphereState::frozen ? SphereState::discarded : SphereState::frozen;
        }
        else if (!waits && happens(0.1))
        {
            state = SphereState::running;
        }
        renewSpeed(id);
    }
    void renewSpeed(std::size_t id)
    {
        const bool runs = snapshot_.states[id] == SphereState::running;
        snapshot_.speeds[id] = runs ? static_cast<float>(random(12)) : 0;
        contacts()[id] = runs           ? 0
                         : happens(0.3) ? static_cast<std::uint32_t>(random(13))
                                        : contacts()[id];
    }
    std::vector<std::uint32_t>& contacts() { return snapshot_.columns.front().bits; }
    /// The last one takes the number of the one that goes.
    void withdraw(std::size_t id)
    {
        const auto drop = [&](auto& values)
        {
            values[id] = values.back();
            values.pop_back();
        };
        drop(radii_);
        drop(snapshot_.centres);
        drop(snapshot_.radii);
        drop(snapshot_.states);
        drop(snapshot_.groups);
        drop(snapshot_.speeds);
        drop(snapshot_.waiting);
        drop(contacts());
    }

    std::mt19937 numbers_;
    TriangleMesh mesh_;
    RunFileWriter writer_;
    Snapshot snapshot_;
    std::vector<double> radii_;
};

} // namespace frostfill::test
