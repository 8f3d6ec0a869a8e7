// SPDX-License-Identifier: MIT
#include "run/camera_path.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>

namespace frostfill
{
namespace
{

/// Reads a number from the front of a text, and removes it.
std::optional<double> takeNumber(std::string_view& text)
{
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || !std::isfinite(value))
    {
        return std::nullopt;
    }
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return value;
}

bool takeSign(std::string_view& text, char sign)
{
    const bool there = !text.empty() && text.front() == sign;
    text.remove_prefix(there ? 1 : 0);
    return there;
}

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
    std::string_view text = word;
    const auto time = takeNumber(text);
    if (!time || !takeSign(text, ':'))
    {
        return std::nullopt;
    }
    const auto azimuth = takeNumber(text);
    if (!azimuth || !takeSign(text, ','))
    {
        return std::nullopt;
    }
    const auto elevation = takeNumber(text);
    const auto zoom = takeSign(text, ',') ? takeNumber(text) : std::optional(1.0);
    if (!elevation || !zoom || !text.empty())
    {
        return std::nullopt;
    }
    const bool sound = *time >= 0 && std::abs(*azimuth) <= 1e6 && std::abs(*elevation) <= 90 &&
                       *zoom >= 1e-4 && *zoom <= 1e4;
    return sound ? std::optional(Key{*time, *azimuth, *elevation, *zoom}) : std::nullopt;
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
            throw Error(ErrorCode::usage, fmt::format("--camera-path {}: {}", textOrFile, kForm));
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
