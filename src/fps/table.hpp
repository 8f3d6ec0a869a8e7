// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace frostfill
{

/// Text in rows and columns, to be printed in whatever form is asked for.
struct Table
{
    std::string title;
    std::vector<std::string> headings;
    std::vector<std::vector<std::string>> rows; ///< as long as the headings, each
    std::size_t words = 1; ///< so many columns at the left hold words; the others hold numbers
};

/// Columns as wide as they have to be.
[[nodiscard]] std::string formatText(const Table& table);
[[nodiscard]] std::string formatMarkdown(const Table& table);
/// Headings and rows; a cell with a comma or a quotation mark is quoted. No title.
[[nodiscard]] std::string formatCsv(const Table& table);
/// Writes formatCsv into a file, and creates its directory when there is none. Throws Error
/// cannotCreate or writeFailed.
void saveCsv(const Table& table, const std::filesystem::path& file);
void saveText(const std::string& text, const std::filesystem::path& file);

} // namespace frostfill
