// SPDX-License-Identifier: MIT
#include "fps/table.hpp"

#include "base/atomic_file.hpp"
#include "output/column_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace frostfill
{
namespace
{

/// Columns that a UTF-8 text takes on a terminal: continuation bytes take none.
std::size_t widthOf(const std::string& text)
{
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char byte) { return (byte & 0xc0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width, bool toTheRight)
{
    const std::string space(width - std::min(width, widthOf(text)), ' ');
    return toTheRight ? space + text : text + space;
}

std::string textRow(const Table& table, const std::vector<std::string>& cells,
                    const std::vector<std::size_t>& widths)
{
    std::string line;
    for (std::size_t column = 0; column < cells.size(); ++column)
    {
        line +=
            (column > 0 ? "  " : "") + padded(cells[column], widths[column], column >= table.words);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    return line + "\n";
}

} // namespace

std::string formatText(const Table& table)
{
    std::vector<std::size_t> widths;
    for (std::size_t column = 0; column < table.headings.size(); ++column)
    {
        widths.push_back(widthOf(table.headings[column]));
        for (const auto& row : table.rows)
        {
            widths.back() = std::max(widths.back(), widthOf(row[column]));
        }
    }
    std::string text = table.title + "\n" + textRow(table, table.headings, widths);
    for (const auto& row : table.rows)
    {
        text += textRow(table, row, widths);
    }
    return text;
}

std::string formatMarkdown(const Table& table)
{
    const auto line = [](const std::vector<std::string>& cells)
    {
        std::string text = "|";
        for (const std::string& cell : cells)
        {
            text += " " + cell + " |";
        }
        return text + "\n";
    };
    std::string text = "**" + table.title + "**\n\n" + line(table.headings) + "|";
    for (std::size_t column = 0; column < table.headings.size(); ++column)
    {
        text += column < table.words ? "---|" : "---:|";
    }
    text += "\n";
    for (const auto& row : table.rows)
    {
        text += line(row);
    }
    return text;
}

std::string formatCsv(const Table& table)
{
    const auto line = [](const std::vector<std::string>& cells)
    {
        std::string text;
        for (std::size_t column = 0; column < cells.size(); ++column)
        {
            text += column > 0 ? "," : "";
            text += csvCell(cells[column]);
        }
        return text + "\n";
    };
    std::string text = line(table.headings);
    for (const auto& row : table.rows)
    {
        text += line(row);
    }
    return text;
}

void saveCsv(const Table& table, const std::filesystem::path& file)
{
    saveText(formatCsv(table), file);
}

void saveText(const std::string& text, const std::filesystem::path& file)
{
    createDirectory(file.parent_path());
    AtomicFile out(file);
    out.write(text);
    out.commit();
}

} // namespace frostfill
