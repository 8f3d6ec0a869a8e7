// SPDX-License-Identifier: MIT
// Room: the table of options, the only place that names the settings of a scene. Command line,
// help, scene files, summary.json and docs/options.md come from it.
#pragma once

#include "scene/options/option_fields.hpp"

namespace frostfill
{

/// Some JSON readers round larger whole numbers, so a run could not be repeated.
inline constexpr double kLargestWhole = 9007199254740992;

/// Collects options. A call such as range() applies to the option that was added last.
class TableBuilder
{
public:
    void heading(const char* group) { group_ = group; }

    template <typename Access>
    TableBuilder& add(const char* key, const char* flag, const char* help, Access access)
    {
        return add(fieldOption({.key = key, .flag = flag, .group = group_, .help = help}, access));
    }
    template <typename Access>
    TableBuilder& add(Option option, Access access)
    {
        return add(fieldOption(std::move(option), access));
    }
    TableBuilder& add(Option option)
    {
        table_.push_back(std::move(option));
        return *this;
    }
    TableBuilder& orUnset(const char* word)
    {
        table_.back().nothing = word;
        return *this;
    }
    TableBuilder& range(double low, double high)
    {
        table_.back().range = {low, high, false};
        return *this;
    }
    TableBuilder& above(double low, double high = std::numeric_limits<double>::max())
    {
        table_.back().range = {low, high, true};
        return *this;
    }
    /// Only this preset uses the option.
    TableBuilder& of(Preset preset)
    {
        table_.back().preset = preset;
        return *this;
    }
    TableBuilder& words(std::vector<std::pair<std::string, double>> words)
    {
        table_.back().words = std::move(words);
        return *this;
    }

    std::vector<Option> take() { return std::move(table_); }
    [[nodiscard]] const std::string& group() const { return group_; }

private:
    std::string group_;
    std::vector<Option> table_;
};

/// The two parts of the table: the simulation, and the pictures.
void addRunOptions(TableBuilder& table);
void addPictureOptions(TableBuilder& table);

} // namespace frostfill

// clang-format off
// Reference to a field of a scene, const or not.
// NOLINTNEXTLINE(bugprone-macro-parentheses)
#define FROSTFILL_FIELD(name) [](auto& scene) -> auto& { return scene.name; }
// clang-format on
