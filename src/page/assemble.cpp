// SPDX-License-Identifier: MIT
#include "page/assemble.hpp"

#include "page/embedded.hpp"
#include "render/context/embedded.hpp"
#include "render/context/shader.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace frostfill
{
namespace
{

using Json = nlohmann::ordered_json;

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
          embedded::page_charts_js(), embedded::page_sizes_js(), embedded::page_panel_js(),
          embedded::page_main_js()})
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

} // namespace frostfill
