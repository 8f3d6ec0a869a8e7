// SPDX-License-Identifier: MIT
// particle_input.dat of MFiX, from version 2.0: a head of text says which variables each line has,
// and what those are that it has not. Coordinates come first.
#include "packing/timestep.hpp"
#include "packing/timestep_reader.hpp"

#include <fmt/format.h>

#include <optional>

namespace frostfill
{
namespace
{

/// What a head says.
struct MfixHead
{
    std::optional<std::size_t> count;
    std::optional<int> dimension;
    int words = 0; ///< of a line, up to the variable read last
    SphereColumns columns;
    double diameter = 0; ///< of all, where lines have none
};

bool isRuler(std::string_view line)
{
    return line.starts_with("====");
}

/// "Name:  T" or "Name:  F  value". Only what comes before the diameter matters, and it itself.
void takeVariable(const std::vector<std::string_view>& words, const TextLines& lines,
                  MfixHead& head)
{
    const std::string_view name = words.front();
    const bool isRead = words.size() > 1 && (words[1] == "T" || words[1] == "t");
    if (!isRead && (words.size() < 2 || (words[1] != "F" && words[1] != "f")))
    {
        lines.refuse(fmt::format("'{}' needs T or F behind it", name));
    }
    if (name == "Coordinates:")
    {
        for (const char* axis : {"x", "y", "z"})
        {
            head.columns.take(axis, head.words++);
        }
    }
    else if (name == "Phase_ID:")
    {
        head.words += isRead ? 1 : 0;
    }
    else if (name == "Diameter:" && isRead)
    {
        head.columns.take("diameter", head.words++);
    }
    else if (name == "Diameter:")
    {
        head.diameter = words.size() > 2 ? numberOf(words[2], lines) : 0;
    }
}

/// Up to the second ruler behind the list of variables, between which the columns are named.
MfixHead readMfixHead(TextLines& lines)
{
    MfixHead head;
    int rulers = 0;
    while (rulers < 2 || head.columns.x < 0)
    {
        const std::string_view line = lines.need("its list of variables");
        const auto words = wordsOf(line);
        rulers = head.columns.x < 0 ? 0 : rulers + (isRuler(line) ? 1 : 0);
        if (words.size() < 2 || rulers > 0)
        {
            continue;
        }
        // The instructions before have lines that begin alike, with more text behind.
        if (words.front() == "Dimension:" && words.size() == 2)
        {
            head.dimension = static_cast<int>(countOf(words[1], lines));
        }
        else if (words.front() == "Particles:" && words.size() == 2)
        {
            head.count = countOf(words[1], lines);
        }
        else if (head.count && words.front().ends_with(':'))
        {
            takeVariable(words, lines, head);
        }
    }
    return head;
}

} // namespace

bool isMfix(std::string_view text)
{
    TextLines lines(text, "");
    std::string_view line;
    return lines.next(line) && line.starts_with("Version ") && lines.next(line) && isRuler(line);
}

Timestep readMfix(TextLines lines, double radius)
{
    const MfixHead head = readMfixHead(lines);
    if (head.dimension.value_or(3) != 3)
    {
        lines.refuse("a particle input of MFiX in two dimensions; spheres need three");
    }
    const double ofAll = head.diameter > 0 ? head.diameter / 2 : radius;
    head.columns.requireAll(lines, ofAll);
    Timestep timestep;
    for (std::size_t k = 0; k < *head.count; ++k)
    {
        const auto words = wordsOf(lines.need(fmt::format("its {} particles", *head.count)));
        addSphere(words, head.columns, ofAll, lines, timestep);
    }
    return timestep;
}

} // namespace frostfill
