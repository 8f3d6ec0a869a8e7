// SPDX-License-Identifier: MIT
#include "mesh/files/text_scanner.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <type_traits>

namespace frostfill
{
namespace
{

constexpr std::size_t kLongestQuote = 40;

void appendUtf8(std::string& text, std::uint32_t code)
{
    const auto put = [&](std::uint32_t byte) { text.push_back(static_cast<char>(byte)); };
    if (code < 0x80)
    {
        put(code);
    }
    else if (code < 0x800)
    {
        put(0xc0 | code >> 6);
        put(0x80 | (code & 0x3f));
    }
    else
    {
        put(0xe0 | code >> 12);
        put(0x80 | (code >> 6 & 0x3f));
        put(0x80 | (code & 0x3f));
    }
}

/// Only names and comments have letters beyond the first 65,536; each half of such a pair becomes a
/// question mark.
std::string fromUtf16(std::string_view bytes, bool bigEndian)
{
    std::string text;
    text.reserve(bytes.size() / 2);
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2)
    {
        const auto first = static_cast<unsigned char>(bytes[i]);
        const auto second = static_cast<unsigned char>(bytes[i + 1]);
        const std::uint32_t code = bigEndian ? first << 8U | second : second << 8U | first;
        appendUtf8(text, code >= 0xd800 && code < 0xe000 ? '?' : code);
    }
    return text;
}

/// Whether a decimal number, of which is known that no double holds it, is too small rather than
/// too large.
bool isTiny(std::string_view digits)
{
    return digits.find("e-") != std::string_view::npos ||
           digits.find("E-") != std::string_view::npos || digits.find_first_of("123456789") > 300;
}

} // namespace

std::string decodeText(std::string bytes)
{
    const std::string_view view = bytes;
    if (view.starts_with("\xef\xbb\xbf"))
    {
        bytes.erase(0, 3);
        return bytes;
    }
    if (view.starts_with("\xff\xfe") || view.starts_with("\xfe\xff"))
    {
        return fromUtf16(view.substr(2), view[0] == '\xfe');
    }
    return bytes;
}

std::string quoted(std::string_view word)
{
    std::string text(word.substr(0, kLongestQuote));
    for (char& c : text)
    {
        c = c >= ' ' && c <= '~' ? c : '?'; // whether or not char has a sign
    }
    return "'" + text + (word.size() > kLongestQuote ? "...'" : "'");
}

TextScanner::TextScanner(std::string_view text, Rules rules, std::uint64_t firstLine)
    : text_(text), line_(firstLine)
{
    const auto set = [&](char c, Kind kind) { kinds_[static_cast<unsigned char>(c)] = kind; };
    for (const char blank : {' ', '\t', '\v', '\f', rules.blank})
    {
        set(blank, Kind::blank);
    }
    set('\n', Kind::endOfLine);
    set('\r', Kind::endOfLine);
    if (rules.comment != '\0')
    {
        set(rules.comment, Kind::comment);
    }
    for (const char mark : rules.marks)
    {
        set(mark, Kind::mark);
    }
    if (rules.continues)
    {
        set('\\', Kind::backslash);
    }
}

void TextScanner::skipBlanks()
{
    while (true)
    {
        if (kindAt(at_) == Kind::blank)
        {
            ++at_;
        }
        else if (joinsLines(at_))
        {
            ++at_;
            skipEndOfLine();
        }
        else
        {
            return;
        }
    }
}

void TextScanner::skipLine()
{
    while (kindAt(at_) != Kind::endOfLine)
    {
        ++at_;
    }
}

void TextScanner::skipQuoted()
{
    while (at_ < text_.size() && text_[at_] != '"')
    {
        at_ += text_[at_] == '\\' ? 1 : 0;
        at_ < text_.size() && kindAt(at_) == Kind::endOfLine ? skipEndOfLine() : void(++at_);
    }
    at_ = std::min(at_ + 1, text_.size());
}

void TextScanner::skipEndOfLine()
{
    if (at_ < text_.size())
    {
        at_ += text_.substr(at_).starts_with("\r\n") ? 2 : 1;
        ++line_;
    }
}

bool TextScanner::nextLine()
{
    if (started_)
    {
        // Not by words: a path at the end of a comment may end in a backslash.
        skipLine();
    }
    started_ = true;
    while (true)
    {
        skipBlanks();
        if (at_ >= text_.size())
        {
            return false;
        }
        if (kindAt(at_) == Kind::comment)
        {
            skipLine();
        }
        if (kindAt(at_) != Kind::endOfLine)
        {
            return true;
        }
        skipEndOfLine();
    }
}

std::string_view TextScanner::word()
{
    started_ = true;
    skipBlanks();
    const std::size_t begin = at_;
    if (kindAt(at_) == Kind::mark)
    {
        return text_.substr(at_++, 1);
    }
    // A comment begins only where a word could: 1.#IND is one word.
    while (kindAt(at_) == Kind::ofWord || (kindAt(at_) == Kind::comment && at_ > begin) ||
           (kindAt(at_) == Kind::backslash && !joinsLines(at_)))
    {
        ++at_;
    }
    return text_.substr(begin, at_ - begin);
}

std::string_view TextScanner::wordAnywhere()
{
    std::string_view found = started_ ? word() : std::string_view();
    if (found.empty() && nextLine())
    {
        found = word();
    }
    return found;
}

template <class Number>
Number TextScanner::parse(std::string_view word, std::string_view what, std::string_view kind) const
{
    if (word.empty())
    {
        refuseAt(place(), fmt::format("{} has too few numbers; export the mesh again", what));
    }
    std::string_view digits = word;
    if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-')
    {
        digits.remove_prefix(1);
    }
    Number value = 0;
    const char* end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, value);
    if (std::is_floating_point_v<Number> && error == std::errc::result_out_of_range && stop == end)
    {
        if (isTiny(digits))
        {
            return 0;
        }
        refuseAt(place(),
                 fmt::format("the number {} is too large; export the mesh again", quoted(word)));
    }
    if (error != std::errc() || stop != end)
    {
        refuseAt(place(), fmt::format("{} is not a {}; export the mesh again", quoted(word), kind));
    }
    return value;
}

double TextScanner::toNumber(std::string_view word, std::string_view what) const
{
    const auto value = parse<double>(word, what, "number");
    if (!std::isfinite(value))
    {
        refuseAt(place(), fmt::format("{} has a coordinate that is infinite or not a number ({}); "
                                      "export the mesh again",
                                      what, quoted(word)));
    }
    return value;
}

std::int64_t TextScanner::toInteger(std::string_view word, std::string_view what) const
{
    return parse<std::int64_t>(word, what, "whole number of its kind");
}

std::array<double, 3> TextScanner::point(std::string_view what)
{
    std::array<double, 3> coordinates{};
    for (double& coordinate : coordinates)
    {
        coordinate = toNumber(word(), what);
    }
    return coordinates;
}

} // namespace frostfill
