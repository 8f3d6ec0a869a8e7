// SPDX-License-Identifier: MIT
#include "run/camera_path.hpp"

#include "base/read_number.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace frostfill
{
namespace
{

std::string withoutComments(std::istream& lines)
{
    std::string text;
    for (std::string line; std::getline(lines, line);)
    {
        text += line.substr(0, line.find('#')) + '\n';
    }
    return text;
}

/// [Catmull & Rom 1974] on keys at unequal times: slopes at the ends are 0, those between are of
/// the neighbours.
double blend(double share, double from, double to, double slopeFrom, double slopeTo)
{
    const double s = share;
    const double t = 1 - share;
    return from * t * t * (1 + 2 * s) + to * s * s * (1 + 2 * t) + s * t * t * slopeFrom -
           s * s * t * slopeTo;
}

} // namespace

std::optional<CameraPath::Key> CameraPath::readKey(const std::string& word)
{
    const auto parts = partsOf(word, ':');
    const auto time = readNumber<double>(parts[0]);
    const auto numbers = parts.size() == 2 ? readNumbers(parts[1]) : std::nullopt;
    if (!time || !numbers || numbers->size() < 2 || numbers->size() > 3)
    {
        return std::nullopt;
    }
    const Key key = {*time, (*numbers)[0], (*numbers)[1],
                     numbers->size() > 2 ? (*numbers)[2] : 1.0};
    const bool isSound = std::isfinite(key.time) && key.time >= 0 && std::abs(key.azimuth) <= 1e6 &&
                         std::abs(key.elevation) <= 90 && key.zoom >= 1e-4 && key.zoom <= 1e4;
    return isSound ? std::optional(key) : std::nullopt;
}

std::optional<std::vector<CameraPath::Key>> CameraPath::readKeys(const std::string& text)
{
    std::vector<Key> keys;
    std::istringstream words(text);
    for (std::string word; words >> word;)
    {
        const auto key = readKey(word);
        if (!key || (!keys.empty() && key->time <= keys.back().time))
        {
            return std::nullopt;
        }
        keys.push_back(*key);
    }
    return keys.empty() ? std::nullopt : std::optional(keys);
}

CameraPath CameraPath::read(const std::string& textOrFile)
{
    constexpr const char* kForm = "keyframes are TIME:AZIMUTH,ELEVATION[,ZOOM] with ascending "
                                  "times, as in \"0:30,20 8:120,45\"";
    CameraPath path;
    if (textOrFile.find(':') != std::string::npos)
    {
        const auto keys = readKeys(textOrFile);
        if (!keys)
        {
            throw Error(ErrorCode::usage, fmt::format("camera.path {}: {}", textOrFile, kForm));
        }
        path.keys_ = *keys;
        return path;
    }
    std::ifstream file(textOrFile);
    if (!file)
    {
        throw Error(ErrorCode::inputMissing,
                    fmt::format("cannot read the camera path {}", textOrFile));
    }
    const auto keys = readKeys(withoutComments(file));
    if (!keys)
    {
        throw Error(ErrorCode::badData, fmt::format("camera path {}: {}", textOrFile, kForm));
    }
    path.keys_ = *keys;
    return path;
}

std::optional<CameraPath> CameraPath::of(const Scene& scene)
{
    const std::optional<std::string>& path = scene.frames.cameraPath;
    return path ? std::optional(read(*path)) : std::nullopt;
}

std::string CameraPath::text() const
{
    std::string text;
    for (const Key& key : keys_)
    {
        text += fmt::format("{}{}:{},{},{}", text.empty() ? "" : " ", key.time, key.azimuth,
                            key.elevation, key.zoom);
    }
    return text;
}

Camera CameraPath::at(double seconds, Camera camera) const
{
    const auto later = [](double t, const Key& key) { return t < key.time; };
    const auto next = std::upper_bound(keys_.begin(), keys_.end(), seconds, later);
    const Key& from = next == keys_.begin() ? *next : *(next - 1);
    const Key& to = next == keys_.end() ? from : *next;
    const double span = to.time - from.time;
    const double share = span > 0 ? std::clamp((seconds - from.time) / span, 0.0, 1.0) : 0;
    const auto value = [&](double Key::*part)
    {
        const auto slope = [&](const Key& key)
        {
            const auto index = &key - keys_.data();
            const auto last = static_cast<std::ptrdiff_t>(keys_.size()) - 1;
            if (index == 0 || index == last)
            {
                return 0.0;
            }
            const Key& before = keys_[static_cast<std::size_t>(index - 1)];
            const Key& after = keys_[static_cast<std::size_t>(index + 1)];
            return span * (after.*part - before.*part) / (after.time - before.time);
        };
        return blend(share, from.*part, to.*part, slope(from), slope(to));
    };
    camera.azimuth = value(&Key::azimuth);
    camera.elevation = std::clamp(value(&Key::elevation), -90.0, 90.0);
    camera.zoom = std::clamp(value(&Key::zoom), 1e-4, 1e4);
    return camera;
}

} // namespace frostfill
