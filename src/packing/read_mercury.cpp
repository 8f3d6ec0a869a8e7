// SPDX-License-Identifier: MIT
// Data files of MercuryDPM. A moment begins with the number of spheres, the time and the box; of
// each sphere follow place, velocity, radius, angles, angular velocity and a number (format 14).
#include "packing/timestep.hpp"
#include "packing/timestep_reader.hpp"

#include <fmt/format.h>

#include <charconv>

namespace frostfill
{
namespace
{

constexpr std::size_t kMomentWords = 8;
constexpr std::size_t kFlatMomentWords = 6; ///< in two dimensions
constexpr std::size_t kWordsOfSphere = 14;

bool isMercuryNumber(std::string_view word)
{
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size();
}

SphereColumns columnsOfMercury()
{
    SphereColumns columns;
    int index = 0;
    for (const char* name : {"x", "y", "z", "vx", "vy", "vz", "radius"})
    {
        columns.take(name, index++);
    }
    return columns;
}

void readMomentHead(const std::vector<std::string_view>& words, const TextLines& lines,
                    Timestep& timestep)
{
    if (words.size() == kFlatMomentWords)
    {
        lines.refuse("a data file of MercuryDPM in two dimensions; spheres need three");
    }
    if (words.size() != kMomentWords)
    {
        lines.refuse(fmt::format("{} values, where a moment begins with 8: number of spheres, time "
                                 "and box",
                                 words.size()));
    }
    timestep.time = numberOf(words[1], lines);
    timestep.box.emplace(Eigen::Vector3d(numberOf(words[2], lines), numberOf(words[3], lines),
                                         numberOf(words[4], lines)),
                         Eigen::Vector3d(numberOf(words[5], lines), numberOf(words[6], lines),
                                         numberOf(words[7], lines)));
}

} // namespace

bool isMercury(std::string_view text)
{
    const auto words = wordsOf(text.substr(0, text.find_first_of("\r\n")));
    if (words.size() != kMomentWords && words.size() != kFlatMomentWords)
    {
        return false;
    }
    for (const std::string_view word : words)
    {
        if (!isMercuryNumber(word))
        {
            return false;
        }
    }
    return words.front().find_first_not_of("0123456789") == std::string_view::npos;
}

bool readMercuryTimestep(TextLines& lines, double /*radius*/, Timestep& timestep)
{
    timestep = {};
    const SphereColumns columns = columnsOfMercury();
    for (std::string_view line; lines.next(line);)
    {
        const auto words = wordsOf(line);
        if (words.empty())
        {
            continue;
        }
        readMomentHead(words, lines, timestep);
        const std::size_t count = countOf(words.front(), lines);
        for (std::size_t k = 0; k < count; ++k)
        {
            const auto sphere = wordsOf(lines.need(fmt::format("its {} spheres", count)));
            if (sphere.size() == kMomentWords)
            {
                lines.refuse(
                    fmt::format("the next moment begins after {} of {} spheres", k, count));
            }
            if (sphere.size() < kWordsOfSphere)
            {
                lines.refuse(fmt::format("{} values of a sphere, where format 14 has {}",
                                         sphere.size(), kWordsOfSphere));
            }
            addSphere(sphere, columns, 0, lines, timestep);
        }
        return true;
    }
    return false;
}

} // namespace frostfill
