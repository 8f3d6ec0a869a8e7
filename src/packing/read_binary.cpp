// SPDX-License-Identifier: MIT
// The binary of packing-generation (Baranau & Tallarek), .xyzd, and what its .nfo file says of it.
#include "packing/timestep.hpp"
#include "packing/timestep_reader.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>

namespace frostfill
{
namespace
{

constexpr std::size_t kBytesOfSphere = 4 * sizeof(double);

double doubleAt(const char* bytes)
{
    static_assert(std::endian::native == std::endian::little);
    double value = 0;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

/// The number behind a word that a line of the file begins with, from 0 up to 1.
double porosityBehind(std::string_view word, const std::string& text, const std::string& file)
{
    TextLines lines(text, file);
    for (std::string_view line; lines.next(line);)
    {
        const std::size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
        if (line.substr(begin).starts_with(word))
        {
            const auto words = wordsOf(line.substr(begin + word.size()));
            const double value = words.empty() ? -1 : numberOf(words.front(), lines);
            if (!(value >= 0 && value < 1))
            {
                lines.refuse(
                    fmt::format("a porosity from 0 and below 1 is needed behind '{}'", word));
            }
            return value;
        }
    }
    lines.refuse(fmt::format("no line begins with '{}', which tells the diameters of the file "
                             ".xyzd beside it",
                             word));
}

} // namespace

bool isBinary(std::string_view content, const std::filesystem::path& file)
{
    const std::string_view begin = content.substr(0, 4096);
    return file.extension() == ".xyzd" ||
           std::any_of(begin.begin(), begin.end(),
                       [](unsigned char c) { return c < 9 || (c > 13 && c < 32); });
}

Timestep readBinary(std::string_view bytes, const std::string& file, double diameters)
{
    if (bytes.size() % kBytesOfSphere != 0)
    {
        throw Error(ErrorCode::badData,
                    fmt::format("{}, byte {}: the file ends within sphere {}: four doubles x, y, z "
                                "and diameter are needed of each",
                                file, bytes.size(), bytes.size() / kBytesOfSphere + 1));
    }
    Timestep timestep;
    for (std::size_t at = 0; at < bytes.size(); at += kBytesOfSphere)
    {
        const char* sphere = bytes.data() + at;
        const Eigen::Vector3d centre(doubleAt(sphere), doubleAt(sphere + sizeof(double)),
                                     doubleAt(sphere + 2 * sizeof(double)));
        const double diameter = doubleAt(sphere + 3 * sizeof(double));
        if (!centre.allFinite() || !(diameter > 0) || !std::isfinite(diameter))
        {
            throw Error(ErrorCode::badData,
                        fmt::format("{}, byte {}: sphere {} has the place {}, {}, {} and a "
                                    "diameter of {}: no file of doubles x, y, z and diameter",
                                    file, at, at / kBytesOfSphere + 1, centre.x(), centre.y(),
                                    centre.z(), diameter));
        }
        timestep.centres.push_back(centre);
        timestep.radii.push_back(diameter * diameters / 2);
    }
    return timestep;
}

double diametersOf(const std::filesystem::path& file)
{
    std::filesystem::path info = file;
    info.replace_extension(".nfo");
    std::ifstream stream(info, std::ios::binary);
    if (!stream)
    {
        return 1;
    }
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    const double theoretical = porosityBehind("Theoretical Porosity:", text, info.string());
    const double found = porosityBehind("Final Porosity:", text, info.string());
    return theoretical == found ? 1 : std::cbrt((1 - found) / (1 - theoretical));
}

} // namespace frostfill
