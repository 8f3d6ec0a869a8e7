// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/scene.hpp>

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#pragma GCC visibility push(default)
namespace frostfill
{

/// The value of a setting outside of a Scene. monostate leaves the choice to the program.
using OptionValue =
    std::variant<std::monostate, bool, std::int64_t, double, std::string, Eigen::Vector3d>;

enum class OptionType : std::uint8_t
{
    boolean,
    integer,
    number,
    text,
    vector,
    radii ///< a number, or a text that describes several
};

/// The allowed values of a number.
struct OptionRange
{
    double low = -std::numeric_limits<double>::max();
    double high = std::numeric_limits<double>::max();
    bool withoutLow = false; ///< `low` itself is not allowed
};

/// One setting of a scene. Only the table of these settings has their names; scene files, the
/// command line, its help, docs/options.md and summary.json come from it.
struct Option
{
    std::string key = {};               ///< in scene files: "spheres.radius"
    std::string flag = {};              ///< on the command line: "--radius"; empty for --set alone
    std::string group = {};             ///< heading in the help
    std::string help = {};              ///< one line, with the unit
    OptionType type = OptionType::text; ///< of the value, if there is one
    std::string nothing = {}; ///< the word for no value ("auto"); empty if a value is required
    std::string placeholder = "TEXT";      ///< of a text in the help
    std::string form = "text";             ///< description of a text: "a size such as 1280x720"
    std::vector<std::string> choices = {}; ///< of a text; empty: any text
    std::vector<std::pair<std::string, double>> words = {}; ///< words for numbers
    OptionRange range = {};
    std::optional<Preset> preset = {}; ///< the only preset that uses it; empty: both do

    std::function<OptionValue(const Scene&)> get = {};
    /// Takes a value of `get` or one that setOption has checked. Returns false for a text that it
    /// cannot read.
    std::function<bool(Scene&, const OptionValue&)> set = {};
};

/// Every setting, in the order of the files and the help.
[[nodiscard]] std::span<const Option> sceneOptions();
/// Null for a key that is not in the table.
[[nodiscard]] const Option* findOption(std::string_view key);
/// For keys that the program itself names. Throws std::logic_error for one that is not in the
/// table.
[[nodiscard]] const Option& optionOf(std::string_view key);

/// What takes settings. Each takes a part of the table.
enum class OptionUse : std::uint8_t
{
    filling,  ///< all
    pictures, ///< of a run that is over: of frames, picture and camera all but what decides which
              ///< states there are
    loading,  ///< how an open or broken mesh is made whole
    judging, ///< what a mesh is in which spheres lie: loading, the axis up; and how they are judged
};

/// The options of a use, in the order of the table.
[[nodiscard]] std::vector<const Option*> optionsFor(OptionUse use);

/// The allowed values, for messages: "a number from 0 to 1".
[[nodiscard]] std::string describeAllowed(const Option& option);

/// "; did you mean 'grid'?", or nothing if the value is no text that resembles an allowed one.
[[nodiscard]] std::string nearestAllowed(const Option& option, const OptionValue& value);

/// The sentence with which a value is refused: "threads is '-1', but it must be a whole number from
/// 0 to 1024". `name` is what its user calls the option, `text` what was given.
[[nodiscard]] std::string refusalText(const Option& option, std::string_view name,
                                      std::string_view text);

/// Sets the value. Returns false, and leaves the scene unchanged, if it is not allowed.
[[nodiscard]] bool setOption(const Option& option, Scene& scene, OptionValue value);

/// Reads a value from the command line; empty if the text is not of the type of the option.
[[nodiscard]] std::optional<OptionValue> readOptionText(const Option& option,
                                                        std::string_view text);

/// The value as written on the command line.
[[nodiscard]] std::string optionText(const Option& option, const OptionValue& value);

/// The sentence that refuses a flag or a keyword of earlier versions and names what replaces it:
/// "--dt is a key of the scene: --set motion.dt=0.01". `value`: what was given for it; may be
/// empty. Empty for a flag that never was.
[[nodiscard]] std::string formerFlagText(std::string_view flag, std::string_view value);

/// The key that replaces a flag of earlier versions, such as "motion.dt" for "--dt"; empty if none
/// does.
[[nodiscard]] std::string_view formerFlagKey(std::string_view flag);

/// The key of the table that is nearest to a wrong one, as the end of a sentence; may be empty.
[[nodiscard]] std::string didYouMeanKey(std::string_view key);

/// The name with the smallest edit distance from `name`; the first of several. Empty if more than
/// half of `name` would have to change, because that is no typing error.
[[nodiscard]] std::string nearestName(std::string_view name, std::span<const std::string> names);

/// The given options that only the other preset uses. `given`: a map from the options that the user
/// gave, by pointer, so that no key can be asked for that does not exist.
template <class Given>
std::vector<const Option*> ignoredOptions(const Given& given, Preset preset)
{
    std::vector<const Option*> ignored;
    for (const Option& option : sceneOptions())
    {
        if (option.preset && option.preset != preset && given.contains(&option))
        {
            ignored.push_back(&option);
        }
    }
    return ignored;
}

/// Radii or sizes without a count ask to be filled until no sphere fits, whatever count the preset
/// has. `given`: as for ignoredOptions.
template <class Given>
void impliesUntilFull(const Given& given, Scene& scene)
{
    if ((given.contains(&optionOf("spheres.radius")) ||
         given.contains(&optionOf("spheres.sizes"))) &&
        !given.contains(&optionOf("spheres.count")))
    {
        scene.spheres.count.reset();
    }
}

/// Grains and a packing fraction imply that all spheres settle together, unless rest.mode is given,
/// and a fraction implies RestSettings::kHoldsFraction, unless rest.friction is given or nothing
/// has to be held. Returns the sentence that says so, or nothing.
template <class Given>
std::string impliesJointRest(const Given& given, Scene& scene)
{
    RestSettings& rest = scene.rest;
    const bool isGranular = scene.motion.mode == Motion::granular;
    std::string implied;
    if ((isGranular || rest.fraction) && rest.mode != Rest::joint &&
        !given.contains(&optionOf("rest.mode")))
    {
        rest.mode = Rest::joint;
        implied = "--rest joint";
    }
    if (rest.mode == Rest::joint && rest.needsFriction() && rest.friction == 0 &&
        !given.contains(&optionOf("rest.friction")))
    {
        rest.friction = RestSettings::kHoldsFraction;
        implied += implied.empty() ? "--friction " : " and --friction ";
        implied += optionText(optionOf("rest.friction"), rest.friction);
    }
    if (implied.empty())
    {
        return "";
    }
    return (rest.fraction ? "--fraction implies " : "--motion granular implies ") + implied;
}

} // namespace frostfill
#pragma GCC visibility pop
