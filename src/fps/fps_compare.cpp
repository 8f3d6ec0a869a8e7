// SPDX-License-Identifier: MIT
#include "fps/fps_compare.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace frostfill
{
namespace
{

using Json = nlohmann::ordered_json;

constexpr const char* kQuantities[] = {"step_ms_of_runs", "sphere_polygon_ms_of_runs"};

/// The member of `list` whose `key` is `value`, or null.
const Json* findBy(const Json& list, const char* key, const Json& value)
{
    const auto found = std::find_if(list.begin(), list.end(),
                                    [&](const Json& member) { return member.at(key) == value; });
    return found == list.end() ? nullptr : &*found;
}

void compareObject(const Json& before, const Json& now, double threshold,
                   std::vector<FpsChange>& changes)
{
    for (const Json& search : now.at("searches"))
    {
        const Json* older = findBy(before.at("searches"), "search", search.at("search"));
        if (!older)
        {
            continue;
        }
        for (const char* quantity : kQuantities)
        {
            if (!search.contains(quantity) || !older->contains(quantity))
            {
                continue;
            }
            FpsChange change;
            change.object = now.at("object").get<std::string>();
            change.search = search.at("search").get<std::string>();
            change.quantity = quantity;
            change.before = older->at(quantity).at("fastest_run").get<double>();
            change.now = search.at(quantity).at("fastest_run").get<double>();
            change.regressed = change.now > change.before * (1 + threshold / 100);
            changes.push_back(change);
        }
    }
}

/// Times of different work cannot be compared.
bool sameWork(const Json& before, const Json& now)
{
    constexpr const char* kKeys[] = {"triangles",  "spheres",        "radius",
                                     "group_size", "groups_per_set", "freeze_every"};
    return std::all_of(std::begin(kKeys), std::end(kKeys),
                       [&](const char* key) { return before.at(key) == now.at(key); });
}

} // namespace

bool FpsComparison::regressed() const
{
    return std::any_of(changes.begin(), changes.end(),
                       [](const FpsChange& change) { return change.regressed; });
}

FpsComparison compareFps(const Json& before, const Json& now, double threshold,
                         const std::string& name)
{
    if (!before.is_object() || before.value("format", "") != now.value("format", ""))
    {
        throw Error(ErrorCode::badData,
                    fmt::format("{} was not written by frostfill fps --json", name));
    }
    FpsComparison comparison;
    try
    {
        for (const Json& object : now.at("objects"))
        {
            if (const Json* older = findBy(before.at("objects"), "object", object.at("object"));
                older && sameWork(*older, object))
            {
                compareObject(*older, object, threshold, comparison.changes);
            }
        }
        comparison.sameMachine = before.at("machine").at("cpu") == now.at("machine").at("cpu") &&
                                 before.at("machine").at("cores") == now.at("machine").at("cores");
    }
    catch (const Json::exception& error)
    {
        throw Error(ErrorCode::badData, fmt::format("{} is damaged: {}", name, error.what()));
    }
    if (comparison.changes.empty())
    {
        throw Error(ErrorCode::badData,
                    fmt::format("{} has no object in common with this measurement, with the same "
                                "spheres and groups",
                                name));
    }
    return comparison;
}

} // namespace frostfill
