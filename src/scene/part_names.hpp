// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/error.hpp>
#include <frostfill/scene.hpp>

#include <algorithm>
#include <concepts>
#include <string>
#include <vector>

namespace frostfill
{

/// The built-in parts of one kind by name, in the order of the enumeration that chooses among them.
template <typename Enum>
struct BuiltInParts;
template <>
struct BuiltInParts<Integrator>
{
    static constexpr const char* kNames[] = {"explicit", "semi-implicit"};
};
template <>
struct BuiltInParts<SphereSearch>
{
    static constexpr const char* kNames[] = {"all-pairs", "grid"};
};
template <>
struct BuiltInParts<PolygonSearch>
{
    static constexpr const char* kNames[] = {"loop", "list", "quadtree", "grid"};
};
template <>
struct BuiltInParts<DiscardRule>
{
    static constexpr const char* kNames[] = {"none", "paper", "exact"};
};
template <>
struct BuiltInParts<FreezingRule>
{
    static constexpr const char* kNames[] = {"one-by-one", "by-set"};
};
template <>
struct BuiltInParts<ReleaseRule>
{
    static constexpr const char* kNames[] = {"ceilings"};
};

/// An enumeration that chooses a part.
template <typename Enum>
concept PartChoice = requires
{
    BuiltInParts<Enum>::kNames;
};

/// The names of all parts of a kind: those built in, then those added. A name's index is its value
/// of the enumeration.
template <PartChoice Enum>
std::vector<std::string>& partNames()
{
    static std::vector<std::string> names(std::begin(BuiltInParts<Enum>::kNames),
                                          std::end(BuiltInParts<Enum>::kNames));
    return names;
}

/// Makes scenes accept one more name, and returns the value that stands for it. Throws Error usage
/// for a name that is taken. Not to be called while another thread reads a scene.
template <PartChoice Enum>
Enum addPartName(const std::string& name)
{
    std::vector<std::string>& names = partNames<Enum>();
    if (std::find(names.begin(), names.end(), name) != names.end())
    {
        throw Error(ErrorCode::usage, "there is a part with the name '" + name + "' already");
    }
    names.push_back(name);
    return static_cast<Enum>(names.size() - 1);
}

} // namespace frostfill
