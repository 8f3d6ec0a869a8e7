// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/packing.hpp>

#include <cstddef>
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
    [[nodiscard]] bool done() const { return rest_.empty(); }
    /// Throws Error badData with the file and the line that was read last.
    [[noreturn]] void refuse(std::string_view what) const;

private:
    std::string_view rest_;
    std::string file_;
    std::size_t line_ = 0;
};

/// The words of a line; spaces and tabs separate them, and so does `separator`, if it is not 0.
[[nodiscard]] std::vector<std::string_view> wordsOf(std::string_view line, char separator = 0);

/// Throws Error badData for a word that is no number.
[[nodiscard]] double numberOf(std::string_view word, const TextLines& lines);
/// A whole number from 0.
[[nodiscard]] std::size_t countOf(std::string_view word, const TextLines& lines);

/// The columns that a sphere is read from; each is the index of a word, or -1.
struct SphereColumns
{
    int x = -1, y = -1, z = -1;
    int radius = -1, diameter = -1;
    int state = -1;

    /// Takes a column by its name, in any case; names that mean nothing here are left out.
    void take(std::string_view name, int index);
    /// Throws Error badData if a coordinate is missing, or a radius that is not given otherwise.
    void requireAll(const TextLines& lines, double radius) const;
    [[nodiscard]] std::size_t width() const; ///< words that a line must have
};

/// Adds the sphere of a line. `radius` is taken where the file has none.
void addSphere(const std::vector<std::string_view>& words, const SphereColumns& columns,
               double radius, const TextLines& lines, Packing& packing);

// The readers of text, each for a whole file.
[[nodiscard]] Packing readTable(TextLines lines, double radius);
[[nodiscard]] Packing readXyz(TextLines lines, double radius);
[[nodiscard]] Packing readDump(TextLines lines, double radius);

} // namespace frostfill
