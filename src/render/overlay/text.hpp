// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/image.hpp>
#include <frostfill/view.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace frostfill
{

/// DejaVu Sans at one size, drawn on the processor into a finished picture.
class Font
{
public:
    /// `size` is the height of a line without leading [pixel].
    explicit Font(double size);
    ~Font();
    Font(Font&&) noexcept;
    Font& operator=(Font&&) noexcept;

    [[nodiscard]] double size() const { return size_; }
    /// Width of a line of UTF-8 [pixel].
    [[nodiscard]] double measure(std::string_view text) const;
    /// The text, or as much of it as fits with an ellipsis.
    [[nodiscard]] std::string shorten(std::string_view text, double width) const;
    /// Draws a line whose letters stand on `baseline` and start at `x` [pixel]. What is outside of
    /// the picture is left out. The halo keeps text readable where the object is behind it.
    void draw(Image& image, double x, double baseline, std::string_view text, const Colour& colour,
              const Colour& halo) const;

    /// The pixels that such a line touches with its halo: left, top, right, bottom, y downwards;
    /// all 0 for none.
    [[nodiscard]] std::array<int, 4> bounds(double x, double baseline, std::string_view text) const;

private:
    struct Glyph
    {
        int left = 0, top = 0; ///< of the bitmap, from the pen on the baseline
        int width = 0, height = 0;
        double advance = 0;
        std::vector<std::uint8_t> coverage; ///< [height x width]
    };
    struct Face;

    [[nodiscard]] const Glyph& glyph(char32_t codepoint) const;
    /// Calls visit(glyph, pen, rest of the text behind it) for what is written from `x` on. Returns
    /// where the pen ends.
    template <typename Visit>
    double along(double x, std::string_view text, Visit visit) const;
    static void blend(Image& image, const Glyph& glyph, int x, int y, const Colour& colour);

    double size_;
    std::unique_ptr<Face> face_;
    mutable std::unordered_map<char32_t, Glyph> glyphs_;
};

} // namespace frostfill
