// SPDX-License-Identifier: MIT
#include "page/assemble.hpp"
#include "render/framing/framing.hpp"
#include "render/overlay/colour_scale.hpp"
#include "render/picture/mesh_shading.hpp"
#include "render/picture/painter_settings.hpp"
#include "render/picture/sphere_draw_list.hpp"
#include "run/frame_painter.hpp"

#include <fmt/format.h>

#include <array>
#include <span>
#include <string>

namespace frostfill
{
namespace
{

using Json = nlohmann::ordered_json;

constexpr std::array<std::pair<Look, const char*>, 4> kLooks = {{{Look::clean, "Clean"},
                                                                 {Look::dark, "Dark"},
                                                                 {Look::paper, "Paper"},
                                                                 {Look::studio, "Studio"}}};

/// Which spheres a column says something of, by ColumnOf.
constexpr std::array<const char*, 3> kSpheresOf = {"all", "running", "resting"};

template <class Vector>
Json vectorJson(const Vector& v)
{
    return {v[0], v[1], v[2]};
}

/// Colours and lines of a look, as pictures have them.
Json lookJson(const char* name, const Palette& palette, const PageView& view,
              const TriangleMesh& mesh, Look look)
{
    RenderSettings settings = view.settings;
    settings.style.look = look;
    const ShaderVariant variant = variantOf(settings, mesh);
    return {{"name", name},
            {"background", palette.background},
            {"running", palette.running},
            {"frozen", palette.frozen},
            {"discarded", palette.discarded},
            {"active_polygon", palette.activePolygon},
            {"discarded_polygon", palette.discardedPolygon},
            {"text", palette.text},
            {"active_ink", vectorJson(inkFor(palette.activePolygon, palette.background))},
            {"discarded_ink", vectorJson(inkFor(palette.discardedPolygon, palette.background))},
            {"scale_start", scaleStart(palette.background)},
            {"haze", uniformsOf(view.framing, settings).haze},
            {"outlines", variant.outlines},
            {"fading_lines", variant.fadingLines}};
}

/// All looks, and one with the run's own colours if it has such; `look` is the index of the run's.
void addLooks(const PageView& view, const TriangleMesh& mesh, Json& facts)
{
    const Style& style = view.settings.style;
    facts["looks"] = Json::array();
    for (const auto& [look, name] : kLooks)
    {
        if (look == style.look)
        {
            facts["look"] = facts["looks"].size();
        }
        facts["looks"].push_back(lookJson(name, paletteOf(look), view, mesh, look));
    }
    const auto own = [&](const Palette& palette)
    { return lookJson("The run's own", palette, view, mesh, style.look); };
    if (own(style.palette) != own(paletteOf(style.look)))
    {
        facts["look"] = facts["looks"].size();
        facts["looks"].push_back(own(style.palette));
    }
}

/// What colours mean, and the colours of the scale from 0 to 1. `carried`: columns of the run.
void addColours(const RunHead& head, const PageView& view, std::span<const ColumnValues> carried,
                Json& facts)
{
    facts["colours"] = Json::array();
    for (const std::string& by : colourColumns())
    {
        const Column& column = *findColumn(by);
        if (column.isCarried() && findValues(carried, column) == nullptr)
        {
            continue;
        }
        Scene scene = head.scene;
        scene.style.colourBy = by;
        RenderSettings settings = view.settings;
        settings.style.colourBy = by;
        settings.range = colourRange(scene, head.colours);
        const SphereColours colours(settings, view.vertices);
        facts["colours"].push_back({{"by", by},
                                    {"title", colours.title()},
                                    {"low", colours.range().low},
                                    {"high", colours.range().high},
                                    {"whole", colours.countsWhole()},
                                    {"of", kSpheresOf[static_cast<std::size_t>(column.of)]}});
        if (by == view.settings.style.colourBy)
        {
            facts["colour_by"] = by;
        }
        if (by == "speed")
        {
            Snapshot still;
            still.states = {SphereState::frozen};
            facts["resting"] = colours.of(still, 0);
        }
    }
    facts["scale"] = Json::array();
    for (int i = 0; i < 256; ++i)
    {
        facts["scale"].push_back(scaleColour(i / 255.0, view.settings.style.colourMap));
    }
}

/// Widths of lines are the greater of two: so many pixels, and a share of the picture's edge.
void addStrokes(const PageView& view, const TriangleMesh& mesh, Json& facts)
{
    constexpr int kLarge = 1 << 20;
    RenderSettings settings = view.settings;
    settings.supersample = 1;
    settings.size = {1, 1};
    const MeshStrokes small = strokesFor(settings, mesh.triangles.size());
    settings.size = {kLarge, kLarge};
    const MeshStrokes large = strokesFor(settings, mesh.triangles.size());
    facts["strokes"] = {
        {"line", {small.lineWidth, large.lineWidth / kLarge}},
        {"fade", {large.edgeFade[0] / large.lineWidth, large.edgeFade[1] / large.lineWidth}}};
}

Json cutawayJson(const PageView& view)
{
    const Cutaway& cutaway = view.settings.style.cutaway;
    if (cutaway.kind == Cutaway::Kind::none)
    {
        return nullptr;
    }
    Json planes = Json::array();
    for (const glm::dvec4& plane : cutPlanes(cutaway, view.framing, view.settings.up))
    {
        planes.push_back({plane.x, plane.y, plane.z, plane.w});
    }
    return planes;
}

/// Numbers of `frame`, with which the page looks from anywhere.
Json framingJson(const PageView& view)
{
    return {{"margin", kFramingMargin},
            {"depth_padding", kDepthPadding},
            {"near_share", kNearShare},
            {"back", vectorJson(horizontalDirection(view.settings.up, 0))},
            {"right", vectorJson(horizontalDirection(view.settings.up, 90))},
            {"outline", line_strength::kOutline}};
}

Json cameraJson(const PageView& view)
{
    const Camera& camera = view.settings.camera;
    return {{"azimuth", *camera.azimuth},
            {"elevation", camera.elevation},
            {"field_of_view", camera.fieldOfView},
            {"zoom", camera.zoom},
            {"target", camera.target ? vectorJson(*camera.target) : Json()},
            {"distance", camera.distance ? Json(*camera.distance) : Json()}};
}

} // namespace

PageView pageView(const RunHead& head, const TriangleMesh& mesh)
{
    PageView view;
    view.settings = renderSettings(head.scene, {}, head.poses);
    view.settings.camera.orthographic = false;
    if (!view.settings.camera.azimuth)
    {
        view.settings.camera.azimuth = frontAzimuth(mesh, view.settings.up.normalized());
    }
    view.vertices = verticesInPoses(mesh.vertices, head.poses);
    const PictureSize size = view.settings.size;
    view.framing = frame(view.vertices, view.settings,
                         {0, 0, static_cast<double>(size.width), static_cast<double>(size.height)});
    return view;
}

double fastestColour(const RunHead& head, const PageView& view)
{
    Scene scene = head.scene;
    scene.style.colourBy = "speed";
    RenderSettings settings = view.settings;
    settings.style.colourBy = "speed";
    settings.range = colourRange(scene, head.colours);
    return SphereColours(settings, {}).range().high * settings.unitsPerMetre;
}

Json pageFacts(const RunFileReader& run, const RunHead& head, const PageView& view,
               const SimplifiedShell& shell, std::span<const ColumnValues> carried,
               const std::string& sets)
{
    Json facts;
    facts["version"] = head.version;
    facts["name"] = head.scene.name;
    facts["centre"] = vectorJson(view.framing.centre);
    facts["scale_of_unit"] = view.framing.scale;
    facts["origin"] = vectorJson(boundingBox(run.mesh()).center());
    facts["up"] = vectorJson(view.settings.up);
    facts["stripe_axis"] = vectorJson(stripeAxis());
    facts["foot"] = heightsOf(view.vertices, view.settings.up).low;
    facts["groups_per_set"] = view.settings.groupsPerSet;
    facts["triangles"] = shell.facts.triangles;
    if (!shell.isTrue())
    {
        facts["mesh_triangles"] = shell.facts.meshTriangles;
        facts["shell_distance"] = shell.facts.distance;
    }
    facts["poses"] = Json::array();
    for (const Pose& pose : head.poses)
    {
        facts["poses"].push_back(poseToJson(pose));
    }
    facts["camera"] = cameraJson(view);
    facts["framing"] = framingJson(view);
    facts["cutaway"] = cutawayJson(view);
    facts["shell"] = view.settings.style.shell;
    facts["shell_opacity"] =
        view.settings.style.shellOpacity ? Json(*view.settings.style.shellOpacity) : Json();
    addLooks(view, run.mesh(), facts);
    addColours(head, view, carried, facts);
    addStrokes(view, run.mesh(), facts);
    const double rate = head.interval * head.scene.frames.fps;
    facts["rate"] = rate < 1e30 ? Json(rate) : Json(); // simulated seconds a second of video
    facts["scene"] = Json::parse(run.head()).at("scene");
    facts["summary"] =
        run.summary() ? Json::parse(*run.summary(), nullptr, false) : Json(); // null: not ended
    facts["sets"] = sets;
    return facts;
}

} // namespace frostfill
