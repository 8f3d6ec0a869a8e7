// SPDX-License-Identifier: MIT
#include "base/random.hpp"
#include "scene/options/file_values.hpp"

#include <frostfill/error.hpp>
#include <frostfill/options.hpp>
#include <frostfill/sweep_file.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace frostfill
{
namespace
{

constexpr std::size_t kMaxRuns = 1000000;
constexpr std::size_t kLongestName = 200; // file systems take 255 bytes, and parts get endings

/// A key of scenes with the values that it takes in turn.
struct SweptKey
{
    const Option* option;
    FileValue values;
};

[[noreturn]] void refuseSweep(std::string_view file, std::uint32_t line, const std::string& what)
{
    throw Error(ErrorCode::badData, fmt::format("{}, line {}: {}", file, line, what));
}

/// The values whose keys begin with `table.`, without that.
FileValues valuesIn(const std::string& table, const FileValues& values)
{
    FileValues inside;
    for (const auto& [key, value] : values)
    {
        if (key.starts_with(table + "."))
        {
            inside[key.substr(table.size() + 1)] = value;
        }
    }
    return inside;
}

void refuseOtherTables(const FileValues& values, std::string_view file)
{
    for (const auto& [key, value] : values)
    {
        if (!key.starts_with("scene.") && !key.starts_with("sweep."))
        {
            refuseSweep(
                file, value.line,
                fmt::format("'{}' is in neither table of a sweep: put the settings of all runs "
                            "in [scene] and lists of values in [sweep]",
                            key));
        }
    }
}

/// In the order of the table of options, whatever that of the file.
std::vector<SweptKey> axesOf(const FileValues& swept, std::string_view file)
{
    std::vector<SweptKey> axes;
    for (const Option& option : sceneOptions())
    {
        if (const auto found = swept.find(option.key); found != swept.end())
        {
            if (found->second.list.empty())
            {
                refuseSweep(
                    file, found->second.line,
                    fmt::format("'{0}' must be a list of values, such as {0} = [ ... ]; put a "
                                "single value in [scene]",
                                option.key));
            }
            axes.push_back({&option, found->second});
        }
    }
    return axes;
}

/// The last part of the key, or all of it where several options have the same: both do not depend
/// on what else is swept.
std::string shortKey(const std::string& key)
{
    const auto lastPart = [](const std::string& whole)
    {
        const std::size_t dot = whole.rfind('.');
        return dot == std::string::npos ? whole : whole.substr(dot + 1);
    };
    const auto options = sceneOptions();
    const auto same =
        std::count_if(options.begin(), options.end(),
                      [&](const Option& option) { return lastPart(option.key) == lastPart(key); });
    return same > 1 ? key : lastPart(key);
}

/// Fit for a file name: "../parts/bunny.stl" becomes "parts-bunny.stl".
std::string inName(const std::string& text)
{
    std::string name;
    for (const char letter : text)
    {
        const bool plain = std::isalnum(static_cast<unsigned char>(letter)) != 0 ||
                           std::string_view("._+-").find(letter) != std::string_view::npos;
        name += plain ? letter : '-';
    }
    while (name.starts_with("..-") || name.starts_with(".-"))
    {
        name.erase(0, name.find('-') + 1);
    }
    return name;
}

/// A hash stands for what does not fit into a name.
std::string shortened(const std::string& name)
{
    if (name.size() <= kLongestName)
    {
        return name;
    }
    FnvHash hash;
    hash.add(name);
    return fmt::format("{}-{:016x}", name.substr(0, kLongestName - 17), hash.value());
}

/// The run whose value on each axis has this place in its list.
SweepRun runAt(const std::vector<std::size_t>& places, const std::vector<SweptKey>& axes,
               const FileValues& base, std::string_view file)
{
    FileValues values = base;
    for (std::size_t i = 0; i < axes.size(); ++i)
    {
        values[axes[i].option->key] = axes[i].values.list[places[i]];
    }
    SweepRun run;
    run.scene = sceneFromValues(values, file);
    for (const SweptKey& axis : axes)
    {
        const std::string text = optionText(*axis.option, axis.option->get(run.scene));
        run.swept.emplace_back(axis.option->key, text);
        run.name += fmt::format("{}{}={}", run.name.empty() ? "" : ",", shortKey(axis.option->key),
                                inName(text));
    }
    run.name = shortened(run.name);
    return run;
}

/// The next combination, the last axis first. Returns false after the last one.
bool nextPlaces(std::vector<std::size_t>& places, const std::vector<SweptKey>& axes)
{
    for (std::size_t i = axes.size(); i-- > 0;)
    {
        if (++places[i] < axes[i].values.list.size())
        {
            return true;
        }
        places[i] = 0;
    }
    return false;
}

} // namespace

std::vector<SweepRun> parseSweep(std::string_view toml, std::string_view nameForMessages)
{
    const FileValues values = readTomlValues(toml, nameForMessages);
    refuseOtherTables(values, nameForMessages);
    const FileValues base = valuesIn("scene", values);
    const FileValues swept = valuesIn("sweep", values);
    (void)sceneFromValues(base, nameForMessages); // for what is wrong in [scene] alone
    FileValues both = base;
    std::size_t count = 1;
    for (const auto& [key, value] : swept)
    {
        if (base.contains(key))
        {
            refuseSweep(nameForMessages, value.line,
                        fmt::format("'{}' is in [scene] and in [sweep]: omit one of them", key));
        }
        both[key] = value.list.empty() ? value : value.list.front();
        count *= std::max<std::size_t>(1, value.list.size());
        if (count > kMaxRuns)
        {
            refuseSweep(nameForMessages, value.line,
                        fmt::format("the sweep has more than {} runs", kMaxRuns));
        }
    }
    (void)sceneFromValues(both, nameForMessages); // for keys that no scene has
    const std::vector<SweptKey> axes = axesOf(swept, nameForMessages);
    if (axes.empty())
    {
        throw Error(ErrorCode::badData,
                    fmt::format("{} sweeps nothing: give lists of values in a table [sweep], such "
                                "as seed = [1, 2, 3]",
                                nameForMessages));
    }
    std::vector<SweepRun> runs;
    std::set<std::string> names;
    std::vector<std::size_t> places(axes.size(), 0);
    do
    {
        runs.push_back(runAt(places, axes, base, nameForMessages));
        if (!names.insert(runs.back().name).second)
        {
            refuseSweep(
                nameForMessages, axes.front().values.line,
                fmt::format("two runs have the name '{}': a list has a value twice, or two that "
                            "differ only in characters that a file name cannot have",
                            runs.back().name));
        }
    } while (nextPlaces(places, axes));
    return runs;
}

std::vector<SweepRun> loadSweep(const std::filesystem::path& file)
{
    std::vector<SweepRun> runs = parseSweep(readSceneFile(file), file.string());
    for (SweepRun& run : runs)
    {
        // Whole paths: the same sweep is the same from whichever folder it is started.
        resolvePaths(run.scene, std::filesystem::absolute(file).lexically_normal().parent_path());
    }
    return runs;
}

} // namespace frostfill
