// SPDX-License-Identifier: MIT
#include "scene/options/option.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

namespace frostfill
{

void validateScene(const Scene& scene)
{
    // A value that the table would not let in again is out of its range.
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
    if (scene.preset == Preset::paper && scene.motion.mode != Motion::fall)
    {
        throw Error(ErrorCode::usage, "the spheres of the preset paper always fall: leave "
                                      "motion.mode (--motion) out, or use the preset fast");
    }
    if (scene.move.any() && (scene.preset == Preset::paper || scene.motion.mode == Motion::descend))
    {
        throw Error(ErrorCode::usage, "an object that moves (--tilt, --turn, --shake) needs the "
                                      "preset fast with --motion fall or skip");
    }
    const DiscardRule foreign =
        scene.preset == Preset::fast ? DiscardRule::paper : DiscardRule::exact;
    if (scene.discard.rule == foreign)
    {
        throw Error(ErrorCode::usage,
                    scene.preset == Preset::fast
                        ? "the paper's discards are not exact: discard.rule (--discard) paper goes "
                          "with the preset paper only"
                        : "discard.rule (--discard) exact goes with the preset fast only");
    }
    if (scene.preset == Preset::paper && scene.spheres.groupSize == 0)
    {
        throw Error(ErrorCode::usage, "spheres.group_size (--group-size) is 0, but with the preset "
                                      "paper it must be at least 1");
    }
    if (!scene.spheres.radius && !scene.spheres.count)
    {
        throw Error(ErrorCode::usage, "neither a radius nor a count of spheres is given; give "
                                      "--radius, --count or both");
    }
}

} // namespace frostfill
