// SPDX-License-Identifier: MIT
#include "page/assemble.hpp"

#include "page/embedded.hpp"
#include "render/context/embedded.hpp"
#include "render/context/shader.hpp"
#include "render/picture/mesh_shading.hpp"
#include "run_file/bytes.hpp"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <string_view>
#include <utility>
#include <vector>

namespace frostfill
{
namespace
{

using Json = nlohmann::ordered_json;

/// From 7 to 12 pages shrink by 2 % and take ten times as long.
constexpr int kLevel = 7;

std::string deflated(std::string_view bytes)
{
    const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
        libdeflate_alloc_compressor(kLevel), &libdeflate_free_compressor);
    if (!compressor)
    {
        throw std::bad_alloc();
    }
    std::string packed(libdeflate_zlib_compress_bound(compressor.get(), bytes.size()), '\0');
    packed.resize(libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(),
                                           packed.data(), packed.size()));
    return packed;
}

/// JSON that cannot end the element that it stands in.
std::string inScript(const Json& json)
{
    const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    std::string safe;
    safe.reserve(text.size());
    for (const char c : text)
    {
        safe += c == '<' ? std::string("\\u003c") : std::string(1, c);
    }
    return safe;
}

std::string inHtml(std::string_view text)
{
    std::string safe;
    for (const char c : text)
    {
        safe += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
    }
    return safe;
}

/// One script of many files: they share their declarations, which are not global.
std::string scripts()
{
    std::string all;
    for (const std::string_view file :
         {embedded::page_data_js(), embedded::page_film_js(), embedded::page_camera_js(),
          embedded::page_colours_js(), embedded::page_programs_js(), embedded::page_shell_js(),
          embedded::page_picture_js(), embedded::page_timeline_js(), embedded::page_gestures_js(),
          embedded::page_charts_js(), embedded::page_panel_js(), embedded::page_main_js()})
    {
        all += file;
    }
    return all;
}

Json shaders()
{
    return {{"common", commonShaderText()},
            {"sphere_vert", embedded::shader_sphere_vert()},
            {"sphere_frag", embedded::shader_sphere_frag()},
            {"mesh_vert", embedded::shader_mesh_vert()},
            {"mesh_frag", embedded::shader_mesh_frag()}};
}

} // namespace

std::string base64(std::string_view bytes)
{
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3)
    {
        const auto byte = [&](std::size_t k) -> unsigned
        { return i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0; };
        const unsigned three = byte(0) << 16 | byte(1) << 8 | byte(2);
        for (std::size_t digit = 0; digit < 4; ++digit)
        {
            const bool padding = i + digit > bytes.size();
            text += padding ? '=' : kDigits[three >> (18 - 6 * digit) & 63];
        }
    }
    return text;
}

std::string packedText(const Sections& sections)
{
    std::string all;
    for (const auto& [name, bytes] : sections)
    {
        all += bytes;
    }
    return base64(deflated(all));
}

std::string assemblePage(Json facts, const Sections& sections)
{
    facts["sections"] = Json::array();
    for (const auto& [name, bytes] : sections)
    {
        facts["sections"].push_back({name, bytes.size()});
    }
    const std::array<std::pair<std::string_view, std::string>, 6> parts = {
        {{"{{title}}", inHtml(facts["name"].get<std::string>())},
         {"{{style}}", std::string(embedded::page_style_css())},
         {"{{facts}}", inScript(facts)},
         {"{{shaders}}", inScript(shaders())},
         {"{{sections}}", packedText(sections)},
         {"{{script}}", scripts()}}};
    std::string page;
    std::string_view rest = embedded::page_page_html();
    for (std::size_t at = rest.find("{{"); at != std::string_view::npos; at = rest.find("{{"))
    {
        page += rest.substr(0, at);
        rest.remove_prefix(at);
        const auto* const part =
            std::find_if(parts.begin(), parts.end(),
                         [&](const auto& each) { return rest.starts_with(each.first); });
        if (part == parts.end())
        {
            page += rest.substr(0, 2);
            rest.remove_prefix(2);
            continue;
        }
        page += part->second;
        rest.remove_prefix(part->first.size());
    }
    return page += rest;
}

namespace
{

/// For each edge the triangles beside it, in which corners it is not, and how strongly it is drawn
/// where it is no outline.
void addEdges(const ShadedMesh& mesh, Sections& sections)
{
    ByteWriter sides, kinds;
    std::int64_t before = 0;
    for (const ShadedMesh::Edge& edge : mesh.edges)
    {
        const bool paired = edge.triangles[1] != ShadedMesh::Edge::kNone;
        const std::int64_t first = edge.triangles[0];
        const std::int64_t second = paired ? edge.triangles[1] : first; // itself: there is none
        sides.difference(first - before);
        sides.difference(second - first);
        before = first;
        kinds.raw(static_cast<std::uint8_t>(edge.corners[0] + 4 * edge.corners[1]));
        kinds.raw(std::max(edge.stray ? std::uint8_t{0} : edge.crease, line_strength::kPlain));
    }
    sections.emplace_back("edges", std::move(sides.bytes()));
    sections.emplace_back("edgeKinds", std::move(kinds.bytes()));
}

} // namespace

Sections shapeSections(const TriangleMesh& mesh, const Framing& framing)
{
    const ShadedMesh shaded = shadeMesh(mesh, inUnitSpace(mesh, framing));
    ByteWriter points, normals, creases, triangles;
    for (std::size_t i = 0; i < shaded.positions.size(); ++i)
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            points.raw(shaded.positions[i][axis]);
            normals.raw(static_cast<std::int16_t>(std::lround(32767 * shaded.normals[i][axis])));
        }
        const float crease = shaded.creaseDistances.empty() ? 1 : shaded.creaseDistances[i];
        creases.raw(static_cast<std::uint8_t>(std::lround(255 * crease)));
    }
    std::int64_t before = 0;
    for (const auto& corners : shaded.triangles)
    {
        for (const std::int64_t corner : corners)
        {
            triangles.difference(corner - before);
            before = corner;
        }
    }
    Sections sections = {{"points", std::move(points.bytes())},
                         {"normals", std::move(normals.bytes())},
                         {"creases", std::move(creases.bytes())},
                         {"triangles", std::move(triangles.bytes())}};
    addEdges(shaded, sections);
    return sections;
}

} // namespace frostfill
