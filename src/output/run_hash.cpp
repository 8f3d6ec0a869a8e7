// SPDX-License-Identifier: MIT
#include "output/run_hash.hpp"

#include "base/random.hpp"
#include "output/scene_json.hpp"
#include "scene/read_sizes.hpp"
#include "scene/shown_unbalance.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace frostfill
{
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
