// SPDX-License-Identifier: MIT
#include "base/read_number.hpp"
#include "scene/options/file_values.hpp"
#include "scene/read_sizes.hpp"

#include <frostfill/error.hpp>
#include <frostfill/options.hpp>

#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <fstream>
#include <map>
#include <sstream>

namespace frostfill
{
namespace
{

[[noreturn]] void refuse(std::string_view file, std::uint32_t line, const std::string& what)
{
    throw Error(ErrorCode::badData, fmt::format("{}, line {}: {}", file, line, what));
}

FileValue readNode(const toml::node& node)
{
    FileValue read{{}, node.source().begin.line, true, {}};
    if (const auto* boolean = node.as_boolean())
    {
        read.value = boolean->get();
    }
    else if (const auto* whole = node.as_integer())
    {
        read.value = whole->get();
    }
    else if (const auto* number = node.as_floating_point())
    {
        read.value = number->get();
    }
    else if (const auto* text = node.as_string())
    {
        read.value = text->get();
    }
    else if (const auto* array = node.as_array())
    {
        Eigen::Vector3d vector = Eigen::Vector3d::Zero();
        read.readable = array->size() == 3;
        for (const toml::node& element : *array)
        {
            read.list.push_back(readNode(element));
        }
        for (int i = 0; read.readable && i < 3; ++i)
        {
            const auto element = (*array)[static_cast<std::size_t>(i)].value<double>();
            read.readable = read.readable && element.has_value();
            vector[i] = element.value_or(0);
        }
        read.value = vector;
    }
    else
    {
        read.readable = false;
    }
    return read;
}

void collect(const toml::table& table, const std::string& prefix, FileValues& values)
{
    for (const auto& [key, node] : table)
    {
        const std::string name = prefix + std::string(key.str());
        if (const auto* inner = node.as_table())
        {
            collect(*inner, name + ".", values);
        }
        else
        {
            values[name] = readNode(node);
        }
    }
}

using KnownValues = std::map<const Option*, const FileValue*>;

KnownValues knownValues(const FileValues& values, std::string_view file)
{
    KnownValues known;
    for (const auto& [key, value] : values)
    {
        if (const Option* option = findOption(key))
        {
            known[option] = &value;
            continue;
        }
        refuse(file, value.line, fmt::format("unknown key '{}'{}", key, didYouMeanKey(key)));
    }
    return known;
}

void apply(const Option& option, const KnownValues& values, Scene& scene, std::string_view file)
{
    const auto found = values.find(&option);
    if (found == values.end())
    {
        return;
    }
    const FileValue& given = *found->second;
    if (!given.readable || !setOption(option, scene, given.value))
    {
        refuse(file, given.line,
               fmt::format("'{}' must be {}{}", option.key, describeAllowed(option),
                           nearestAllowed(option, given.value)));
    }
}

std::string tomlText(const std::string& text)
{
    std::ostringstream out;
    out << toml::toml_formatter(toml::value<std::string>(text),
                                toml::toml_formatter::default_flags &
                                    ~toml::format_flags::allow_literal_strings);
    return out.str();
}

/// The fewest digits that give the same number, with a mark that distinguishes it from an integer.
std::string tomlNumber(double number)
{
    std::string digits = fmt::format("{}", number);
    if (digits.find_first_of(".en") == std::string::npos)
    {
        digits += ".0";
    }
    return digits;
}

std::string tomlValue(const Option& option, const OptionValue& value)
{
    if (const auto* number = std::get_if<double>(&value))
    {
        return tomlNumber(*number);
    }
    if (const auto* vector = std::get_if<Eigen::Vector3d>(&value))
    {
        return fmt::format("[{}, {}, {}]", tomlNumber(vector->x()), tomlNumber(vector->y()),
                           tomlNumber(vector->z()));
    }
    const std::string text = optionText(option, value);
    const bool quoted =
        std::holds_alternative<std::string>(value) || std::holds_alternative<std::monostate>(value);
    return quoted ? tomlText(text) : text;
}

/// The line of a key of more parts than any scene has, from 1; 0 if there is none. The parser calls
/// itself for each part, and the stack ends.
std::uint32_t lineOfEndlessKey(std::string_view toml)
{
    constexpr std::size_t kMaxParts = 256;
    std::uint32_t line = 1;
    std::size_t dots = 0;
    for (const char c : toml)
    {
        line += c == '\n' ? 1 : 0;
        if (c == '.')
        {
            ++dots;
        }
        else if (std::string_view("=,[]{}#\n").find(c) != std::string_view::npos)
        {
            dots = 0; // not within a key
        }
        if (dots > kMaxParts)
        {
            return line;
        }
    }
    return 0;
}

} // namespace

FileValues readTomlValues(std::string_view toml, std::string_view nameForMessages)
{
    if (const std::uint32_t line = lineOfEndlessKey(toml))
    {
        refuse(nameForMessages, line, "a key of more than 256 parts");
    }
    FileValues values;
    try
    {
        collect(toml::parse(toml), "", values);
    }
    catch (const toml::parse_error& error)
    {
        refuse(nameForMessages, error.source().begin.line, std::string(error.description()));
    }
    return values;
}

Scene sceneFromValues(const FileValues& values, std::string_view file)
{
    const KnownValues known = knownValues(values, file);
    Scene named;
    apply(optionOf("preset"), known, named, file);
    apply(optionOf("object.mesh"), known, named, file);

    Scene scene = presetScene(named.preset, named.object.mesh);
    for (const Option& option : sceneOptions())
    {
        apply(option, known, scene, file);
    }
    impliesUntilFull(known, scene);
    (void)impliesJointRest(known, scene);
    return scene;
}

Scene parseScene(std::string_view toml, std::string_view nameForMessages)
{
    return sceneFromValues(readTomlValues(toml, nameForMessages), nameForMessages);
}

namespace
{

/// A mesh, or several files, by its path or theirs from a folder.
std::string meshIn(const std::filesystem::path& folder, const std::string& mesh)
{
    const std::string whole = (folder / mesh).string();
    if (mesh.find('+') == std::string::npos || std::filesystem::exists(whole))
    {
        return whole;
    }
    std::vector<std::string> parts;
    for (const std::string_view part : partsOf(mesh, '+'))
    {
        parts.push_back((folder / part).string());
    }
    return fmt::format("{}", fmt::join(parts, "+"));
}

} // namespace

void resolvePaths(Scene& scene, const std::filesystem::path& folder)
{
    if (!isBuiltInMesh(scene.object.mesh))
    {
        scene.object.mesh = meshIn(folder, scene.object.mesh);
    }
    if (scene.spheres.radius && !scene.spheres.radius->file.empty() &&
        std::filesystem::path(scene.spheres.radius->file).is_relative())
    {
        scene.spheres.radius->file = (folder / scene.spheres.radius->file).string();
    }
    std::optional<std::string>& curve = scene.spheres.sizes.curve;
    if (curve && !isNamedSizes(*curve) && std::filesystem::path(*curve).is_relative())
    {
        curve = (folder / *curve).string();
    }
    std::optional<std::string>& path = scene.frames.cameraPath;
    if (path && path->find(':') == std::string::npos && std::filesystem::path(*path).is_relative())
    {
        path = (folder / *path).string();
    }
}

std::string readSceneFile(const std::filesystem::path& file)
{
    std::ifstream in(file, std::ios::binary);
    if (!std::filesystem::is_regular_file(file) || !in)
    {
        throw Error(ErrorCode::inputMissing,
                    fmt::format("cannot read the scene {}: it does not exist or is not readable",
                                file.string()));
    }
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

Scene loadScene(const std::filesystem::path& file)
{
    Scene scene = parseScene(readSceneFile(file), file.string());
    resolvePaths(scene, file.parent_path());
    return scene;
}

std::string sceneToToml(const Scene& scene)
{
    // Keys without a table come first; after a heading they would belong to that table.
    std::map<std::string, std::string> tables;
    std::vector<std::string> order;
    for (const Option& option : sceneOptions())
    {
        const std::size_t dot = option.key.find('.');
        const bool inTable = dot != std::string::npos;
        const std::string table = inTable ? option.key.substr(0, dot) : "";
        if (inTable && !tables.contains(table))
        {
            order.push_back(table);
        }
        tables[table] += fmt::format("{} = {}\n", inTable ? option.key.substr(dot + 1) : option.key,
                                     tomlValue(option, option.get(scene)));
    }
    std::string text = tables[""];
    for (const std::string& table : order)
    {
        text += fmt::format("\n[{}]\n{}", table, tables[table]);
    }
    return text;
}

} // namespace frostfill
