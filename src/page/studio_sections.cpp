// SPDX-License-Identifier: MIT
#include "page/studio_sections.hpp"

#include "render/framing/numbers.hpp"
#include "render/picture/contact_shadows.hpp"
#include "render/picture/sphere_occlusion.hpp"
#include "render/picture/studio.hpp"
#include "run_file/bytes.hpp"

#include <cmath>

namespace frostfill
{
namespace
{

using Json = nlohmann::ordered_json;

Json vectorJson(const glm::vec3& v)
{
    return {v.x, v.y, v.z};
}

/// Of the grid its corner and edges of a cell, and of each corner how dark it is, 255 for 1.
Json addGround(const GroundShadow& ground, Sections& sections)
{
    const glm::vec3 corner(ground.places.front());
    const auto row = static_cast<std::size_t>(ground.cells) + 1;
    Json facts = {{"cells", ground.cells},
                  {"level", ground.level},
                  {"corner", vectorJson(corner)},
                  {"across", vectorJson(glm::vec3(ground.places[1]) - corner)},
                  {"along", vectorJson(glm::vec3(ground.places[row]) - corner)}};
    ByteWriter dark;
    for (const glm::vec4& place : ground.places)
    {
        dark.raw(static_cast<std::uint8_t>(std::lround(255 * place.w)));
    }
    sections.emplace_back("ground", std::move(dark.bytes()));
    return facts;
}

void addWall(const ContactShadow& wall, ByteWriter& bytes)
{
    for (int axis = 0; axis < 3; ++axis)
    {
        bytes.difference(std::lround(32767 * wall.inwards[axis]));
    }
    bytes.count(static_cast<std::uint64_t>(std::lround(32767 * wall.height)));
    bytes.count(static_cast<std::uint64_t>(std::lround(255 * std::min(wall.bend, 1.0F))));
}

/// Of each sphere at rest that touches walls: its place, so that what touches them somewhere else
/// before has no shadow there, and the walls.
std::string contactsOf(const ContactShadows& shadows, const PageView& view, const LastFrame& last)
{
    ByteWriter bytes;
    std::uint64_t count = 0;
    std::size_t before = 0;
    for (std::size_t id = 0; id < last.centres.size(); ++id)
    {
        if (last.states.states[id] == SphereState::running)
        {
            continue;
        }
        const glm::vec3 centre(view.framing.toUnit(last.centres[id]));
        const auto radius = static_cast<float>(view.framing.scale * last.radii[id]);
        const std::vector<ContactShadow> walls =
            shadows.of({centre.x, centre.y, centre.z, radius, 0, {}});
        if (walls.empty())
        {
            continue;
        }
        ++count;
        bytes.count(id - before);
        before = id;
        const Eigen::Vector3d place = (last.centres[id] - last.origin) / last.step;
        for (int axis = 0; axis < 3; ++axis)
        {
            bytes.difference(std::llround(place[axis]));
        }
        bytes.count(walls.size());
        for (const ContactShadow& wall : walls)
        {
            addWall(wall, bytes);
        }
    }
    ByteWriter all;
    all.count(count);
    return std::move(all.bytes()) + bytes.bytes();
}

} // namespace

Json addStudio(const TriangleMesh& mesh, const TriangleMesh& simplified, const PageView& view,
               const LastFrame& last, Sections& sections)
{
    RenderSettings settings = view.settings;
    settings.style.look = Look::studio;
    settings.style.shell = true;
    const Studio studio =
        *studioOf(simplified, inUnitSpace(simplified, view.framing), settings, view.framing);
    Json facts = {
        {"lamp", vectorJson(studio.lamp)},         {"up", vectorJson(studio.up)},
        {"reach", SphereOcclusion::kReach},        {"lamp_reach", SphereOcclusion::kLampReach},
        {"lamp_softness", shading::kLampSoftness}, {"occluder_range", shading::kOccluderRange},
        {"touches", ContactShadows::kTouches},     {"farthest", ContactShadows::kFarthest},
        {"edge_on", ContactShadows::kEdgeOn},      {"of_bend", ContactShadows::kEdgeOnOfBend},
        {"fade", ContactShadows::kFade},           {"ground", nullptr}};
    if (studio.ground)
    {
        facts["ground"] = addGround(*studio.ground, sections);
    }
    const auto shadows =
        contactShadowsOf(mesh, inUnitSpace(mesh, view.framing), settings, studio.lamp);
    sections.emplace_back("walls", contactsOf(*shadows, view, last));
    return facts;
}

} // namespace frostfill
