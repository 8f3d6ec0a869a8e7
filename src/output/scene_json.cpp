// SPDX-License-Identifier: MIT
#include "output/scene_json.hpp"

#include "base/random.hpp"
#include "scene/read_sizes.hpp"
#include "scene/shown_unbalance.hpp"

#include <frostfill/error.hpp>
#include <frostfill/options.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace frostfill
{
namespace
{

using Json = nlohmann::ordered_json;

Json::json_pointer pointerTo(const std::string& key)
{
    std::string path = "/" + key;
    std::replace(path.begin(), path.end(), '.', '/');
    return Json::json_pointer(path);
}

Json valueToJson(const OptionValue& value)
{
    const auto json = [](const auto& known) -> Json
    {
        using Value = std::decay_t<decltype(known)>;
        if constexpr (std::is_same_v<Value, std::monostate>)
        {
            return nullptr;
        }
        else if constexpr (std::is_same_v<Value, Eigen::Vector3d>)
        {
            return {known.x(), known.y(), known.z()};
        }
        else
        {
            return known;
        }
    };
    return std::visit(json, value);
}

/// A value of an unexpected kind becomes an empty text, which only names accept.
OptionValue valueFromJson(const Json& json)
{
    if (json.is_null())
    {
        return std::monostate{};
    }
    if (json.is_boolean())
    {
        return json.get<bool>();
    }
    if (json.is_number_integer())
    {
        return json.get<std::int64_t>();
    }
    if (json.is_number())
    {
        return json.get<double>();
    }
    if (json.is_array() && json.size() == 3 && json[0].is_number() && json[1].is_number() &&
        json[2].is_number())
    {
        return Eigen::Vector3d(json[0], json[1], json[2]);
    }
    return json.is_string() ? json.get<std::string>() : std::string();
}

/// The values below `json`; a vector is one.
std::size_t keysIn(const Json& json)
{
    if (!json.is_object())
    {
        return 1;
    }
    std::size_t keys = 0;
    for (const Json& value : json)
    {
        keys += keysIn(value);
    }
    return keys;
}

} // namespace

Json sceneToJson(const Scene& scene)
{
    Json json;
    for (const Option& option : sceneOptions())
    {
        json[pointerTo(option.key)] = valueToJson(option.get(scene));
    }
    return json;
}

Scene sceneFromJson(const Json& json, std::string_view nameForMessages)
{
    Scene scene;
    std::size_t known = 0;
    for (const Option& option : sceneOptions())
    {
        const auto pointer = pointerTo(option.key);
        if (!json.contains(pointer))
        {
            continue;
        }
        if (!setOption(option, scene, valueFromJson(json[pointer])))
        {
            throw Error(ErrorCode::badData,
                        fmt::format("{}: 'scene.{}' must be {}", nameForMessages, option.key,
                                    describeAllowed(option)));
        }
        ++known;
    }
    if (known == 0 || known != keysIn(json))
    {
        throw Error(ErrorCode::badData,
                    fmt::format("{}: 'scene' has {}, so another version wrote it: use that one",
                                nameForMessages,
                                known == 0 ? "no key that is known" : "keys that are not known"));
    }
    return scene;
}

namespace
{

template <class Value>
void addAll(const std::vector<Value>& values, FnvHash& hash)
{
    hash.add({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)});
}

} // namespace

std::string runHash(const Scene& scene, const TriangleMesh& mesh)
{
    // How many threads there are, which frames are drawn, and what is kept how, changes neither a
    // result nor a picture.
    Scene same = scene;
    same.frames.enabled = true;
    same.frames.selection = FrameSettings{}.selection;
    same.frames.limit = FrameSettings{}.limit;
    same.frames.hold = FrameSettings{}.hold;
    same.frames.passes = {};
    same.frames.cameraPath.reset(); // pictures tell it themselves
    same.threads = 0;
    same.staticLayer = true;
    same.backend = Backend::automatic;
    FnvHash hash;
    nlohmann::ordered_json json = sceneToJson(same);
    json["frames"].erase("keep_run");
    if (!showsUnbalance(same))
    {
        json.erase("judge");
    }
    if (!same.rest.fraction)
    {
        json["rest"].erase("fraction");
    }
    if (!same.rest.orientation)
    {
        json["rest"].erase("orientation");
    }
    if (same.rest.mode == Rest::each)
    {
        json.erase("rest");
    }
    if (same.spheres.inlets.empty())
    {
        json["spheres"].erase("inlets"); // as before there were any
    }
    const SizeSettings& sizes = same.spheres.sizes;
    if (!sizes.curve)
    {
        for (const char* key : {"sizes", "by", "curve_within", "fill_gaps"})
        {
            json["spheres"].erase(key);
        }
    }
    else if (!isNamedSizes(*sizes.curve))
    {
        std::ifstream in(*sizes.curve, std::ios::binary); // what it says now, and not its name
        hash.add(std::string(std::istreambuf_iterator<char>(in), {}));
        json["spheres"].erase("sizes");
    }
    hash.add(json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    addAll(mesh.vertices, hash);
    addAll(mesh.triangles, hash);
    return fmt::format("{:016x}", hash.value());
}

} // namespace frostfill
