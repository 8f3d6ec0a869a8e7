// SPDX-License-Identifier: MIT
#include "keywords.hpp"

#include "values.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>

namespace py = pybind11;

namespace frostfill::python
{
namespace
{

/// Given as the parameter of that name.
bool isParameter(const Option& option)
{
    return option.key == "object.mesh";
}

[[noreturn]] void refuseName(const std::string& name, const std::vector<const Option*>& options,
                             const std::string& call)
{
    std::vector<std::string> names;
    for (const Option* option : options)
    {
        if (!isParameter(*option))
        {
            names.push_back(keywordOf(*option));
        }
    }
    std::string flag = "--" + name;
    std::replace(flag.begin(), flag.end(), '_', '-');
    const std::string_view key = formerFlagKey(flag);
    const std::string nearest = key.empty() ? nearestName(name, names) : keywordOf(optionOf(key));
    throw py::type_error(fmt::format("{}() has no keyword '{}'{}", call, name,
                                     nearest.empty()
                                         ? fmt::format("; help(frostfill.{}) lists them", call)
                                         : fmt::format("; did you mean '{}'?", nearest)));
}

const char* typeName(OptionType type)
{
    switch (type)
    {
    case OptionType::boolean:
        return "boolean";
    case OptionType::integer:
        return "integer";
    case OptionType::number:
        return "number";
    case OptionType::vector:
        return "vector";
    case OptionType::radii:
        return "radii";
    case OptionType::text:
        break;
    }
    return "text";
}

/// An option as a dictionary.
py::dict rowOf(const Option& option)
{
    static const Scene kStandard = presetScene(Preset::fast, "torus");
    py::dict row;
    row["keyword"] = keywordOf(option);
    row["key"] = option.key;
    row["group"] = option.group;
    row["help"] = option.help;
    row["type"] = typeName(option.type);
    row["allowed"] = describeAllowed(option);
    row["choices"] = option.choices;
    std::vector<std::string> words;
    for (const auto& [word, number] : option.words)
    {
        words.push_back(word);
    }
    row["words"] = words;
    row["nothing"] = option.nothing;
    row["form"] = option.placeholder;
    row["default"] = optionText(option, option.get(kStandard));
    return row;
}

py::list rowsFor(OptionUse use)
{
    py::list rows;
    for (const Option* option : optionsFor(use))
    {
        if (!isParameter(*option))
        {
            rows.append(rowOf(*option));
        }
    }
    return rows;
}

} // namespace

std::string keywordOf(const Option& option)
{
    std::string name = option.flag.empty() ? option.key : option.flag.substr(2);
    std::replace(name.begin(), name.end(), option.flag.empty() ? '.' : '-', '_');
    return name;
}

GivenKeywords::GivenKeywords(const py::kwargs& keywords, OptionUse use, const std::string& call)
{
    const std::vector<const Option*> options = optionsFor(use);
    for (const auto& [key, value] : keywords)
    {
        const auto name = key.cast<std::string>();
        const auto found =
            std::find_if(options.begin(), options.end(),
                         [&](const Option* option)
                         { return !isParameter(*option) && keywordOf(*option) == name; });
        if (found == options.end())
        {
            refuseName(name, options, call);
        }
        const auto read = valueOf(**found, value);
        if (!read)
        {
            throw Error(ErrorCode::usage, refusalText(**found, name, shown(value)));
        }
        values_[*found] = {*read, shown(value)};
    }
}

void GivenKeywords::applyOne(const Option& option, Scene& scene) const
{
    const auto found = values_.find(&option);
    if (found != values_.end() && !setOption(option, scene, found->second.value))
    {
        throw Error(ErrorCode::usage, refusalText(option, keywordOf(option), found->second.text));
    }
}

void GivenKeywords::apply(Scene& scene) const
{
    // In the table's order: a style comes before the colours that differ.
    for (const auto& [option, given] : values_)
    {
        applyOne(*option, scene);
    }
    (void)impliesJointRest(values_, scene);
}

Scene GivenKeywords::sceneFor(const std::string& mesh) const
{
    Scene chosen;
    applyOne(optionOf("preset"), chosen);
    Scene scene = presetScene(chosen.preset, mesh);
    apply(scene);
    impliesUntilFull(values_, scene);
    return scene;
}

void GivenKeywords::warnOfIgnored(Preset preset) const
{
    for (const Option* option : ignoredOptions(values_, preset))
    {
        const std::string text =
            fmt::format("the preset {} does not use {}", preset == Preset::fast ? "fast" : "paper",
                        keywordOf(*option));
        if (PyErr_WarnEx(PyExc_UserWarning, text.c_str(), 2) != 0)
        {
            throw py::error_already_set();
        }
    }
}

py::dict keywordsOfScene(const Scene& scene)
{
    py::dict result;
    for (const Option& option : sceneOptions())
    {
        result[py::str(isParameter(option) ? "mesh" : keywordOf(option))] =
            pythonValue(option.get(scene));
    }
    return result;
}

void addKeywords(py::module_& module)
{
    module.def(
        "keywords",
        [](const std::string& use)
        {
            return rowsFor(use == "pictures"  ? OptionUse::pictures
                           : use == "loading" ? OptionUse::loading
                           : use == "judging" ? OptionUse::judging
                                              : OptionUse::filling);
        },
        py::arg("use"));
}

} // namespace frostfill::python
