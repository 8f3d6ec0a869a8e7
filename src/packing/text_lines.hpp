// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace frostfill
{

/// Goes through the lines of a text, and knows the file and the line for messages.
class TextLines
{
public:
    TextLines(std::string_view text, std::string file) : rest_(text), file_(std::move(file)) {}
    /// The next line without its end; false after the last.
    bool next(std::string_view& line);
    /// The next line. Throws Error badData at the end of the file.
    std::string_view need(std::string_view what);
    /// Whether the text ended where more was needed, or within a line: its writer was interrupted.
    [[nodiscard]] bool cut() const { return cut_; }
    /// Throws Error badData with the file and the line that was read last.
    [[noreturn]] void refuse(std::string_view what) const;

private:
    std::string_view rest_;
    std::string file_;
    std::size_t line_ = 0;
    bool cut_ = false;
};

/// The words of a line; spaces and tabs separate them, and so does `separator`, if it is not 0.
[[nodiscard]] std::vector<std::string_view> wordsOf(std::string_view line, char separator = 0);

/// Throws Error badData for a word that is no number. Not-a-number and infinity are numbers.
[[nodiscard]] double numberOf(std::string_view word, const TextLines& lines);
/// A number of spheres, from 0.
[[nodiscard]] std::size_t countOf(std::string_view word, const TextLines& lines);
/// A whole number from 0, such as that of a step or of a sphere.
[[nodiscard]] std::uint64_t wholeNumberOf(std::string_view word, const TextLines& lines);

} // namespace frostfill
