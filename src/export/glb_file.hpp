// SPDX-License-Identifier: MIT
#pragma once

#include "export/exporter.hpp"
#include "run_file/bytes.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <filesystem>
#include <span>

namespace frostfill
{

/// A binary glTF 2.0 file under construction: JSON beside one buffer.
class GlbFile
{
public:
    using Json = nlohmann::ordered_json;

    /// Type of an accessor's values, with the number of glTF.
    enum class Kind
    {
        uint32 = 5125,
        float32 = 5126,
    };

    GlbFile();

    /// Appends bytes to the buffer, as a view of it; returns the view's index. `target` is
    /// ARRAY_BUFFER (34962), ELEMENT_ARRAY_BUFFER (34963) or 0.
    std::size_t addView(std::span<const float> values, int target = 0);
    std::size_t addView(std::span<const std::uint32_t> values, int target = 0);
    /// Values of a view; returns the accessor's index. `type` is SCALAR or VEC3.
    std::size_t addAccessor(std::size_t view, std::size_t byteOffset, Kind kind, std::size_t count,
                            const char* type);
    /// The same with bounds, which glTF asks for where it gives positions or times.
    std::size_t addAccessor(std::size_t view, std::size_t byteOffset, Kind kind, std::size_t count,
                            const char* type, const Json& least, const Json& most);

    [[nodiscard]] Json& json() { return json_; }
    void write(const std::filesystem::path& name);

private:
    std::size_t addBytes(const void* bytes, std::size_t size, int target);

    Json json_;
    ByteWriter buffer_;
};

/// Adds a material and a ball of radius 1, the mesh with the number of the state, for each state.
void addBalls(GlbFile& file);

/// Adds the shell, behind the balls, and its node to the children of the object; or nothing, if the
/// run is exported without.
void addShell(GlbFile& file, const ExportedRun& run, const Eigen::Vector3d& origin,
              GlbFile::Json& children);

/// Adds the node of the object, which stands upright in glTF's frame (y up, metres), and the scene.
/// The children of the object are relative to its origin.
std::size_t addObject(GlbFile& file, const ExportedRun& run, const ExportedFrame& frame,
                      const GlbFile::Json& children);

/// The quaternion x, y, z, w of a rotation.
[[nodiscard]] std::array<float, 4> quaternion(const Eigen::Matrix3d& rotation);

} // namespace frostfill
