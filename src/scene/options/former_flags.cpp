// SPDX-License-Identifier: MIT
#include <frostfill/options.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace frostfill
{
namespace
{

/// A flag of earlier versions, and a key of the scene, a key with its value, or what to type.
struct FormerFlag
{
    std::string_view flag;
    std::string_view now;
};

constexpr FormerFlag kFormerFlags[] = {
    {"--ambient-occlusion", "picture.ambient_occlusion"},
    {"--backend", "picture.backend"},
    {"--camera-path", "camera.path"},
    {"--contact-sheet", "gone: ffmpeg -i DIR/frames/frame_%05d.png -vf tile=4x3 sheet.png"},
    {"--curve-within", "spheres.curve_within"},
    {"--discard", "discard.rule"},
    {"--discard-closeness", "discard.closeness"},
    {"--discard-epsilon", "discard.epsilon"},
    {"--distance", "camera.distance"},
    {"--dt", "motion.dt"},
    {"--edges", "picture.edges"},
    {"--estimate-volume", "now of the command mesh: frostfill mesh FILE --estimate-volume"},
    {"--export", "now a command of its own: frostfill export RUN --to FORMAT"},
    {"--field-of-view", "camera.field_of_view"},
    {"--fill-gaps", "spheres.fill_gaps"},
    {"--fps", "frames.fps"},
    {"--freeze-by-set", "freezing.rule=by-set"},
    {"--freeze-every", "freezing.every_sets"},
    {"--full-mesh", "picture.full_mesh"},
    {"--gravity", "motion.gravity"},
    {"--ground", "picture.ground"},
    {"--group-size", "spheres.group_size"},
    {"--groups-per-set", "spheres.groups_per_set"},
    {"--hold", "frames.hold"},
    {"--integrator", "motion.integrator"},
    {"--json-progress", "gone: progress is on standard error, and --json prints the result"},
    {"--judge-friction", "judge.friction"},
    {"--judge-rolling-friction", "judge.rolling_friction"},
    {"--judge-unbalance", "judge.unbalance"},
    {"--keep-run", "frames.keep_run"},
    {"--max-frames", "frames.limit"},
    {"--move-for", "move.duration"},
    {"--neighbour-lists", "search.neighbour_lists"},
    {"--no-freeze-by-set", "freezing.rule=one-by-one"},
    {"--orientation", "rest.orientation"},
    {"--orthographic", "camera.orthographic"},
    {"--output", "now --out"},
    {"--passes", "frames.passes"},
    {"--polygon-search", "search.polygons"},
    {"--rest-speed", "freezing.rest_speed"},
    {"--rest-window", "freezing.rest_window"},
    {"--restitution", "motion.restitution"},
    {"--rolling-friction", "rest.rolling_friction"},
    {"--samples", "picture.samples"},
    {"--scene", "not needed: give the scene in place of MESH, as in frostfill fill scene.toml"},
    {"--set-time-limit", "freezing.set_time_limit"},
    {"--shake", "move.shake"},
    {"--shake-frequency", "move.frequency"},
    {"--shell-opacity", "picture.shell_opacity"},
    {"--slow-motion", "frames.slow_motion"},
    {"--sphere-search", "search.spheres"},
    {"--static-layer", "picture.static_layer"},
    {"--supersample", "picture.supersample"},
    {"--sweeps", "motion.sweeps"},
    {"--target", "camera.target"},
    {"--threads", "threads"},
    {"--tilt", "move.tilt"},
    {"--turn", "move.turn"},
    {"--unite", "object.unite"},
    {"--until-full", "spheres.until_full"},
    {"--view", "now an ending: --out FILE.html, or afterwards frostfill view RUN"},
    {"--wall-friction", "rest.wall_friction"},
};

const FormerFlag* findFormer(std::string_view flag)
{
    const auto* found = std::find_if(std::begin(kFormerFlags), std::end(kFormerFlags),
                                     [&](const FormerFlag& each) { return each.flag == flag; });
    return found == std::end(kFormerFlags) ? nullptr : found;
}

} // namespace

std::string_view formerFlagKey(std::string_view flag)
{
    const FormerFlag* former = findFormer(flag);
    const std::string_view key = former ? former->now.substr(0, former->now.find('=')) : "";
    return findOption(key) != nullptr ? key : "";
}

std::string formerFlagText(std::string_view flag, std::string_view value)
{
    const FormerFlag* former = findFormer(flag);
    const bool isNegative = former == nullptr && flag.starts_with("--no-");
    former = isNegative ? findFormer(fmt::format("--{}", flag.substr(5))) : former;
    if (former == nullptr)
    {
        return "";
    }
    if (formerFlagKey(former->flag).empty())
    {
        return fmt::format("{} is {}", flag, former->now);
    }
    const Option* option = findOption(former->now);
    std::string setting(former->now);
    if (option != nullptr)
    {
        const bool isBoolean = option->type == OptionType::boolean && option->nothing.empty();
        setting += isBoolean ? (isNegative ? "=false" : "=true")
                             : fmt::format("={}", value.empty() ? "VALUE" : value);
    }
    return fmt::format("{} is a key of the scene: --set {}", flag, setting);
}

} // namespace frostfill
