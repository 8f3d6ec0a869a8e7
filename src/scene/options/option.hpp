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

namespace frostfill
{

/// A setting's value outside of a Scene. Nothing means that it is left to the program.
using OptionValue =
    std::variant<std::monostate, bool, std::int64_t, double, std::string, Eigen::Vector3d>;

enum class OptionType : std::uint8_t
{
    boolean,
    integer,
    number,
    text,
    vector,
    radii ///< a number, or a text that tells several
};

/// The values that a number may have.
struct OptionRange
{
    double low = -std::numeric_limits<double>::max();
    double high = std::numeric_limits<double>::max();
    bool withoutLow = false; ///< `low` itself is not allowed
};

/// One setting of a scene. The table of them is the only place that knows its names: scene files,
/// the command line, its help and summary.json are made from it.
struct Option
{
    std::string key = {};   ///< in scene files: "spheres.radius"
    std::string flag = {};  ///< on the command line: "--radius"; empty when there is none
    std::string group = {}; ///< heading in the help
    std::string help = {};  ///< one line, with the unit
    OptionType type = OptionType::text; ///< of the value when there is one
    std::string nothing = {}; ///< the word for no value ("auto"); empty when there must be one
    std::string placeholder = "TEXT";      ///< of a text in the help
    std::string form = "text";             ///< what a text looks like: "a size such as 1280x720"
    std::vector<std::string> choices = {}; ///< of a text; any when empty
    /// The same where parts can be added later (see scene/part_names.hpp).
    const std::vector<std::string>* parts = nullptr;
    std::vector<std::pair<std::string, double>> words = {}; ///< that stand for a number
    OptionRange range = {};
    std::optional<Preset> preset = {}; ///< the only one that uses it; nothing: each does

    std::function<OptionValue(const Scene&)> get = {};
    /// Takes what `get` gives or what `checked` lets pass. Returns false for a text that it cannot
    /// read.
    std::function<bool(Scene&, const OptionValue&)> set = {};

    /// The texts that are allowed now; any when empty.
    [[nodiscard]] const std::vector<std::string>& texts() const { return parts ? *parts : choices; }
};

/// Every setting, in the order of files and help.
[[nodiscard]] std::span<const Option> sceneOptions();
[[nodiscard]] const Option* findOption(std::string_view key);

/// What may be given, for messages: "a number from 0 to 1".
[[nodiscard]] std::string describeAllowed(const Option& option);

/// "; did you mean 'grid'?", or nothing when the value is no text that is nearly an allowed one.
[[nodiscard]] std::string nearestAllowed(const Option& option, const OptionValue& value);

/// Sets the value, or returns false and leaves the scene alone when it is not allowed.
[[nodiscard]] bool setOption(const Option& option, Scene& scene, OptionValue value);

/// Reads a value as it is written on a command line; none when that is not of the option's type.
[[nodiscard]] std::optional<OptionValue> readOptionText(const Option& option,
                                                        std::string_view text);

/// As it is written on a command line.
[[nodiscard]] std::string optionText(const Option& option, const OptionValue& value);

} // namespace frostfill
