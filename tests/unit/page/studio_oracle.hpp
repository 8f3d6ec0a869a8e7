// SPDX-License-Identifier: MIT
#pragma once

#include "page/facts.hpp"
#include "render/picture/contact_shadows.hpp"
#include "render/picture/painter_settings.hpp"
#include "render/picture/sphere_occlusion.hpp"
#include "render/picture/studio.hpp"

#include <frostfill/run_file.hpp>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <random>
#include <vector>

namespace frostfill::test
{

/// Spheres anywhere, some of which run and some of which a cut takes away, and what light pictures
/// have them keep from each other.
inline nlohmann::json lightOracle()
{
    std::mt19937 numbers(5);
    const auto random = [&] { return std::uniform_real_distribution<float>(0, 1)(numbers); };
    const glm::vec3 lamp = glm::normalize(glm::vec3(-0.5F, 0.9F, 0.6F));
    constexpr float kCutFrom = 0.35F;
    const glm::dvec4 plane(1, 0, 0, -kCutFrom);
    std::vector<SphereInstance> spheres, resting;
    for (int i = 0; i < 500; ++i)
    {
        const glm::vec3 centre = 1.2F * glm::vec3(random(), random(), random()) - 0.6F;
        const float radius = 0.03F + 0.07F * random();
        const bool runs = random() < 0.2F;
        spheres.push_back({centre.x, centre.y, centre.z, radius, runs ? 0U : 1U, {}});
        if (!runs)
        {
            resting.push_back(spheres.back());
        }
    }
    SphereOcclusion occlusion(lamp, CutPlanes{plane, plane});
    occlusion.start(resting);
    nlohmann::json oracle = {{"lamp", {lamp.x, lamp.y, lamp.z}}, {"cut_from", kCutFrom}};
    for (const SphereInstance& sphere : spheres)
    {
        const SphereLight light = occlusion.of(sphere);
        oracle["spheres"].push_back({sphere.x, sphere.y, sphere.z, sphere.radius});
        oracle["states"].push_back(sphere.state);
        oracle["lights"].push_back({light.occluders, light.open});
    }
    return oracle;
}

/// Where spheres of a run darken walls in some of its frames, seen from the run's camera.
inline nlohmann::json contactOracle(const std::filesystem::path& folder)
{
    RunFileReader reader(folder / "run.frost");
    const RunHead head = readHead(reader.head(), "run.frost");
    const PageView view = pageView(head, reader.mesh());
    RenderSettings settings = view.settings;
    settings.style.look = Look::studio;
    settings.style.shell = true;
    const std::vector<glm::vec3> positions = inUnitSpace(reader.mesh(), view.framing);
    const Studio studio = *studioOf(reader.mesh(), positions, settings, view.framing);
    const glm::dvec3& eye = view.framing.eye;
    nlohmann::json oracle = {{"eye", {eye.x, eye.y, eye.z}}};
    const std::size_t last = reader.frames().size() - 1;
    for (const std::size_t frame : {2 * last / 3, last})
    {
        const Snapshot& state = reader.seek(frame);
        std::vector<SphereInstance> resting;
        for (std::size_t id = 0; id < state.states.size(); ++id)
        {
            if (state.states[id] != SphereState::running)
            {
                const glm::vec3 centre(view.framing.toUnit(reader.centres()[id]));
                const double radius = view.framing.scale * reader.radii()[id];
                resting.push_back(
                    {centre.x, centre.y, centre.z, static_cast<float>(radius), 1, {}});
            }
        }
        const auto shadows = contactShadowsOf(reader.mesh(), positions, settings, studio.lamp);
        shadows->lookFrom(view.framing, settings.size, uniformsOf(view.framing, settings));
        shadows->follow(resting, 0);
        nlohmann::json seen = nlohmann::json::array();
        for (const auto& [shadow, pixels] : shadows->seen())
        {
            seen.push_back({shadow.foot.x, shadow.foot.y, shadow.foot.z, shadow.across.x,
                            shadow.across.y, shadow.across.z, shadow.height, shadow.lamp.x,
                            shadow.lamp.y, shadow.strength});
        }
        oracle["frames"].push_back({{"index", frame}, {"shadows", seen}});
    }
    return oracle;
}

} // namespace frostfill::test
