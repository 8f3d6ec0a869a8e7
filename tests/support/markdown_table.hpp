// SPDX-License-Identifier: MIT
#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace frostfill::testing_support
{

/// The cells of a row of a table, without the spaces around them.
inline std::vector<std::string> cellsOf(const std::string& row, char between)
{
    std::vector<std::string> cells;
    std::istringstream text(row);
    for (std::string cell; std::getline(text, cell, between);)
    {
        const std::size_t begin = cell.find_first_not_of(' ');
        cells.push_back(begin == std::string::npos
                            ? ""
                            : cell.substr(begin, cell.find_last_not_of(' ') - begin + 1));
    }
    return cells;
}

/// The rows of the table of a page whose first headings are these, as "cost | power"; none where
/// the page has no such table.
inline std::vector<std::vector<std::string>> markdownTable(const std::string& page,
                                                           const std::string& headings)
{
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(page);
    std::string line;
    while (std::getline(lines, line) && line.rfind("| " + headings + " |", 0) != 0)
    {
    }
    std::getline(lines, line); // the line of dashes
    while (std::getline(lines, line) && line.rfind("| ", 0) == 0)
    {
        rows.push_back(cellsOf(line.substr(1), '|'));
    }
    return rows;
}

} // namespace frostfill::testing_support
