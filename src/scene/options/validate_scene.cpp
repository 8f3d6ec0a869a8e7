// SPDX-License-Identifier: MIT
#include "scene/read_sizes.hpp"
#include "scene/shown_unbalance.hpp"

#include <frostfill/error.hpp>
#include <frostfill/options.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace frostfill
{

namespace
{

void refuseIf(bool isWrong, const char* why)
{
    if (isWrong)
    {
        throw Error(ErrorCode::usage, why);
    }
}

void validateRest(const Scene& scene)
{
    const RestSettings& rest = scene.rest;
    if (rest.mode == Rest::each)
    {
        refuseIf(scene.motion.mode == Motion::granular,
                 "grains rest together, or not at all: motion.mode "
                 "(--motion) granular requires rest.mode (--rest) joint");
        refuseIf(rest.friction != 0 || rest.wallFriction || rest.rollingFriction != 0,
                 "friction (--friction, rest.wall_friction, rest.rolling_friction) acts while all "
                 "spheres settle together: give rest.mode (--rest) joint");
        refuseIf(rest.orientation, "spheres turn only while all settle together: "
                                   "rest.orientation requires rest.mode "
                                   "(--rest) joint");
        refuseIf(rest.fraction.has_value(), "a packing fraction (rest.fraction, --fraction) is "
                                            "reached while all spheres settle together: give "
                                            "rest.mode (--rest) joint");
        return;
    }
    refuseIf(rest.fraction == RestSettings::kLoosest && scene.motion.mode != Motion::granular,
             "only grains come in as loosely as friction lets them "
             "(rest.fraction, --fraction loosest): give motion.mode "
             "(--motion) granular");
    refuseIf(rest.needsFriction() && rest.friction == 0,
             "only friction holds spheres at a packing fraction "
             "(rest.fraction, --fraction) that is asked for: give "
             "rest.friction (--friction), such as 0.3");
    refuseIf(scene.preset == Preset::paper,
             "the preset paper lets no spheres settle together: omit "
             "rest.mode (--rest), or use the preset fast");
    refuseIf(scene.move.any(), "spheres settle together (rest.mode, --rest joint) in an "
                               "object that stands still: omit move.tilt, move.turn and "
                               "move.shake");
}

void validateSizes(const Scene& scene)
{
    const SizeSettings& sizes = scene.spheres.sizes;
    const SizeSettings usual;
    if (!sizes.curve)
    {
        refuseIf(sizes != usual, "spheres.by (--by), spheres.curve_within and spheres.fill_gaps "
                                 "say how a size curve is kept: give "
                                 "spheres.sizes (--sizes)");
        return;
    }
    refuseIf(scene.spheres.radius.has_value(),
             "radii come from a size curve (spheres.sizes, --sizes) or "
             "from spheres.radius (--radius), not both");
    refuseIf(scene.preset == Preset::paper,
             "the preset paper keeps no size curve: omit spheres.sizes "
             "(--sizes), or use the preset fast");
    refuseIf(sizes.fillGaps && !scene.spheres.inlets.empty(),
             "what comes through an inlet fills no gaps: omit "
             "spheres.fill_gaps or spheres.inlets "
             "(--inlet)");
    refuseIf(sizes.fillGaps && scene.move.any(),
             "gaps are filled in an object that stands still: omit "
             "spheres.fill_gaps, or move.tilt, move.turn and move.shake");
    if (isNamedSizes(*sizes.curve))
    {
        (void)readSizeCurve(sizes); // its text is all there is
    }
}

} // namespace

void validateScene(const Scene& scene)
{
    // A value that the table refuses is out of range.
    Scene copy = scene;
    for (const Option& option : sceneOptions())
    {
        const OptionValue value = option.get(scene);
        if (!setOption(option, copy, value))
        {
            throw Error(ErrorCode::usage,
                        fmt::format("{}{} is {}, but it must be {}", option.key,
                                    option.flag.empty() ? "" : fmt::format(" ({})", option.flag),
                                    optionText(option, value), describeAllowed(option)));
        }
    }
    refuseIf(scene.preset == Preset::paper && scene.motion.mode != Motion::fall,
             "the preset paper always simulates the whole fall: omit "
             "motion.mode (--motion), or use the preset fast");
    refuseIf(scene.move.any() &&
                 (scene.preset == Preset::paper || scene.motion.mode == Motion::descend),
             "moving the object (move.tilt, move.turn, move.shake) requires the "
             "preset fast with --motion fall or skip");
    const DiscardRule foreign =
        scene.preset == Preset::fast ? DiscardRule::paper : DiscardRule::exact;
    if (scene.discard.rule == foreign)
    {
        throw Error(ErrorCode::usage,
                    scene.preset == Preset::fast
                        ? "the paper's discards are not exact: discard.rule paper requires "
                          "the preset paper"
                        : "discard.rule exact requires the preset fast");
    }
    refuseIf(scene.preset == Preset::paper && scene.spheres.groupSize == 0,
             "spheres.group_size is 0, but with the preset "
             "paper it must be at least 1");
    if (scene.judge.unbalance != JudgeSettings{}.unbalance && !scene.judge.friction &&
        !showsUnbalance(scene))
    {
        throw Error(ErrorCode::usage, "judge.unbalance needs a friction: give judge.friction");
    }
    refuseIf(scene.camera.turntable && scene.frames.cameraPath,
             "camera.path and camera.turntable (--turntable) both move the camera: omit one of "
             "them");
    validateRest(scene);
    validateSizes(scene);
    refuseIf(!scene.spheres.givesRadii() && !scene.spheres.count,
             "no radius and no number of spheres; give --radius, "
             "--count or both");
}

} // namespace frostfill
