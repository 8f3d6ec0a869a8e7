// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/options.hpp>

#include <pybind11/pybind11.h>

#include <map>
#include <string>
#include <string_view>

namespace frostfill::python
{

/// Returns the keyword of an option: color_by for "--color-by", and motion_dt for the key
/// motion.dt, which has no flag.
[[nodiscard]] std::string keywordOf(const Option& option);

/// The values that a call gives by keyword, read while the interpreter is held and set while it
/// need not be.
class GivenKeywords
{
public:
    /// `call` is the function's name, for messages. Throws TypeError for a name that `use` does not
    /// have, with the nearest one, and Error usage for a value of a wrong type.
    GivenKeywords(const pybind11::kwargs& keywords, OptionUse use, const std::string& call);

    /// Throws Error usage for a value that is not allowed.
    void apply(Scene& scene) const;
    /// The scene of a call of fill: the defaults of preset and mesh, and what was given.
    [[nodiscard]] Scene sceneFor(const std::string& mesh) const;
    /// Warns of what the preset does not use.
    void warnOfIgnored(Preset preset) const;
    /// Whether the call gives the option of this key.
    [[nodiscard]] bool contains(std::string_view key) const
    {
        return values_.contains(&optionOf(key));
    }

private:
    void applyOne(const Option& option, Scene& scene) const;

    struct Given
    {
        OptionValue value;
        std::string text; ///< for messages
    };
    std::map<const Option*, Given> values_; ///< in the table's order
};

/// A scene as a dictionary from keywords to values.
[[nodiscard]] pybind11::dict keywordsOfScene(const Scene& scene);

/// Adds the table of keywords, from which Python makes signatures, help and stubs.
void addKeywords(pybind11::module_& module);

} // namespace frostfill::python
