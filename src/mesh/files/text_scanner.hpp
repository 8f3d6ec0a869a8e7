// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/files/unreadable.hpp"

#include <array>
#include <string>
#include <string_view>

namespace frostfill
{

/// The text in UTF-8 and without its byte order mark. Bytes that begin with no such mark, text or
/// not, stay as they are.
[[nodiscard]] std::string decodeText(std::string bytes);

/// A word of a file, fit for a sentence: short, and without control characters.
[[nodiscard]] std::string quoted(std::string_view word);

/// Walks through a text by words and lines. Lines end in LF, CR LF or CR. Copies nothing.
class TextScanner
{
public:
    struct Rules
    {
        char comment = '\0'; ///< in place of a word: leaves the rest of the line; 0: none does
        char blank = ' ';    ///< that parts words, beside space and tab
        std::string_view marks = {}; ///< each a word by itself
        bool continues = false; ///< a backslash at the end of a line joins it with the next one
    };

    explicit TextScanner(std::string_view text) : TextScanner(text, Rules{}) {}
    TextScanner(std::string_view text, Rules rules, std::uint64_t firstLine = 1);

    /// Goes to the next line that has a word. False at the end of the text.
    bool nextLine();

    /// Leaves what is left of this line.
    void skipLine();

    /// Leaves a text up to its closing quote, of which a backslash before it makes none.
    void skipQuoted();

    /// The next word of this line; empty at its end.
    std::string_view word();

    /// The next word, in this line or below; empty at the end of the text.
    std::string_view wordAnywhere();

    /// The word as a finite number, in C's notation whatever the locale. Throws Unreadable if it is
    /// none; `what` begins the sentence: "the vertex".
    [[nodiscard]] double toNumber(std::string_view word, std::string_view what) const;
    [[nodiscard]] std::int64_t toInteger(std::string_view word, std::string_view what) const;

    /// The first three numbers of the rest of this line.
    [[nodiscard]] std::array<double, 3> point(std::string_view what);

    [[nodiscard]] Place place() const { return {"line", line_}; }
    /// [byte] of the text behind the last word.
    [[nodiscard]] std::size_t at() const { return at_; }
    [[nodiscard]] std::size_t bytesLeft() const { return text_.size() - at_; }

private:
    enum class Kind : std::uint8_t
    {
        ofWord,
        blank,
        endOfLine,
        comment,
        mark,
        backslash ///< only where it can join lines
    };

    [[nodiscard]] Kind kindAt(std::size_t at) const
    {
        return at < text_.size() ? kinds_[static_cast<unsigned char>(text_[at])] : Kind::endOfLine;
    }
    [[nodiscard]] bool joinsLines(std::size_t at) const
    {
        return kindAt(at) == Kind::backslash && kindAt(at + 1) == Kind::endOfLine;
    }
    template <class Number>
    [[nodiscard]] Number parse(std::string_view word, std::string_view what,
                               std::string_view kind) const;
    void skipBlanks();
    void skipEndOfLine();

    std::string_view text_;
    std::array<Kind, 256> kinds_{};
    std::size_t at_ = 0;
    std::uint64_t line_;
    bool started_ = false;
};

} // namespace frostfill
