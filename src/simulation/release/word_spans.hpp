// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/brick_table.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace frostfill
{

/// A word of a lattice: its place in its row, and the row.
using WordPlace = GridPlace;

/// Numbers some words of a lattice, ascending in z, y, x. Words that follow each other in a row are
/// one span, so memory follows the rows, not the words.
class WordSpans
{
public:
    static constexpr std::size_t kNone = ~std::size_t{0};

    static bool isBefore(const WordPlace& a, const WordPlace& b)
    {
        return std::tie(a[2], a[1], a[0]) < std::tie(b[2], b[1], b[0]);
    }

    [[nodiscard]] std::size_t size() const { return size_; }
    /// A word that comes after all others.
    void append(const WordPlace& word)
    {
        const auto number = static_cast<std::uint32_t>(size_);
        if (spans_.empty() || spans_.back().placeOf(number) != word)
        {
            spans_.push_back({word, number});
        }
        if (number % kStride == 0)
        {
            spanAt_.push_back(static_cast<std::uint32_t>(spans_.size() - 1));
        }
        ++size_;
    }

    [[nodiscard]] WordPlace place(std::size_t number) const
    {
        std::size_t span = spanAt_[number / kStride];
        while (span + 1 < spans_.size() && spans_[span + 1].number <= number)
        {
            ++span;
        }
        return spans_[span].placeOf(static_cast<std::uint32_t>(number));
    }
    /// Number of the first word from this one on, or size().
    [[nodiscard]] std::size_t firstFrom(const WordPlace& word) const
    {
        const auto next =
            std::partition_point(spans_.begin(), spans_.end(),
                                 [&](const Span& span) { return !isBefore(word, span.first); });
        const std::size_t end = next == spans_.end() ? size_ : next->number;
        if (next == spans_.begin())
        {
            return end;
        }
        const Span& span = *(next - 1); // the last that begins no later
        const bool isInRow = span.first[1] == word[1] && span.first[2] == word[2];
        return isInRow ? std::min<std::size_t>(
                             end, span.number + static_cast<std::size_t>(word[0] - span.first[0]))
                       : end;
    }
    /// Number of a word, or kNone.
    [[nodiscard]] std::size_t find(const WordPlace& word) const
    {
        const std::size_t number = firstFrom(word);
        return number < size_ && place(number) == word ? number : kNone;
    }

private:
    static constexpr std::size_t kStride = 64;
    struct Span
    {
        WordPlace first;
        std::uint32_t number; ///< of the first

        [[nodiscard]] WordPlace placeOf(std::uint32_t its) const
        {
            return {first[0] + static_cast<int>(its - number), first[1], first[2]};
        }
    };

    std::size_t size_ = 0;
    std::vector<Span> spans_;           ///< ascending
    std::vector<std::uint32_t> spanAt_; ///< in which every 64th word is
};

} // namespace frostfill
