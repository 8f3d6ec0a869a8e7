// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/scene.hpp>

#include <optional>
#include <string>
#include <vector>

namespace frostfill
{

/// Where the camera is at a time of the video: keyframes, joined by smooth curves. It rests before
/// the first and after the last.
class CameraPath
{
public:
    /// Keyframes TIME:AZIMUTH,ELEVATION or TIME:AZIMUTH,ELEVATION,ZOOM, in seconds of video and
    /// degrees, with spaces or line ends between them; or the name of a file of such lines, in
    /// which # begins a comment. "0:30,20 8:120,45" goes from one view to another in eight seconds.
    /// Throws Error inputMissing for a file that cannot be read, badData for one with a fault, and
    /// usage for keyframes of no sense.
    [[nodiscard]] static CameraPath read(const std::string& textOrFile);
    /// That of a scene, if it has one.
    [[nodiscard]] static std::optional<CameraPath> of(const Scene& scene);

    /// The camera with the path's azimuth, elevation and zoom at a time of the video [s].
    [[nodiscard]] Camera at(double seconds, Camera camera) const;
    /// The keyframes, of which `read` makes the same path.
    [[nodiscard]] std::string text() const;
    /// [s] of video, of the last keyframe
    [[nodiscard]] double duration() const { return keys_.back().time; }

private:
    struct Key
    {
        double time, azimuth, elevation, zoom;
    };
    /// Empty where the text does not have the form.
    static std::optional<Key> readKey(const std::string& word);
    static std::optional<std::vector<Key>> readKeys(const std::string& text);

    std::vector<Key> keys_; ///< ascending in time, at least one
};

} // namespace frostfill
