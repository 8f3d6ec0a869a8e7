// SPDX-License-Identifier: MIT
#include "render/overlay/text.hpp"

#include "render/context/embedded.hpp"

#include <stb_truetype.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace frostfill
{
namespace
{

constexpr char32_t kReplacement = 0xfffd;

/// Takes one code point off the front of UTF-8 text; what is not UTF-8 becomes the replacement
/// character, a byte at a time.
char32_t takeCodepoint(std::string_view& text)
{
    const auto lead = static_cast<unsigned char>(text.front());
    const std::size_t length = lead < 0x80 ? 1 : lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    if (length == 1 || lead < 0xc2 || lead > 0xf4 || text.size() < length)
    {
        text.remove_prefix(1);
        return length == 1 ? char32_t{lead} : kReplacement;
    }
    char32_t codepoint = lead & (0x7fU >> length);
    for (std::size_t i = 1; i < length; ++i)
    {
        const auto byte = static_cast<unsigned char>(text[i]);
        if ((byte & 0xc0U) != 0x80U)
        {
            text.remove_prefix(1);
            return kReplacement;
        }
        codepoint = codepoint << 6 | (byte & 0x3fU);
    }
    text.remove_prefix(length);
    return codepoint;
}

} // namespace

struct Font::Face
{
    stbtt_fontinfo info{};
    float scale = 1;
};

Font::Font(double size) : size_(size), face_(std::make_unique<Face>())
{
    const std::string_view file = embedded::fontDejaVuSans();
    const auto* data = reinterpret_cast<const unsigned char*>(file.data());
    stbtt_InitFont(&face_->info, data, stbtt_GetFontOffsetForIndex(data, 0));
    face_->scale = stbtt_ScaleForMappingEmToPixels(&face_->info, static_cast<float>(size));
}

Font::~Font() = default;
Font::Font(Font&&) noexcept = default;
Font& Font::operator=(Font&&) noexcept = default;

const Font::Glyph& Font::glyph(char32_t codepoint) const
{
    const auto [entry, isNew] = glyphs_.try_emplace(codepoint);
    Glyph& glyph = entry->second;
    if (isNew)
    {
        const int index = stbtt_FindGlyphIndex(&face_->info, static_cast<int>(codepoint));
        int advance = 0;
        int right = 0;
        int bottom = 0;
        stbtt_GetGlyphHMetrics(&face_->info, index, &advance, nullptr);
        stbtt_GetGlyphBitmapBox(&face_->info, index, face_->scale, face_->scale, &glyph.left,
                                &glyph.top, &right, &bottom);
        glyph.advance = static_cast<double>(advance) * double{face_->scale};
        glyph.width = right - glyph.left;
        glyph.height = bottom - glyph.top;
        glyph.coverage.resize(static_cast<std::size_t>(glyph.width) *
                              static_cast<std::size_t>(glyph.height));
        if (!glyph.coverage.empty())
        {
            stbtt_MakeGlyphBitmap(&face_->info, glyph.coverage.data(), glyph.width, glyph.height,
                                  glyph.width, face_->scale, face_->scale, index);
        }
    }
    return glyph;
}

template <typename Visit>
double Font::along(double x, std::string_view text, Visit visit) const
{
    while (!text.empty())
    {
        const Glyph& next = glyph(takeCodepoint(text));
        visit(next, static_cast<int>(std::lround(x)), text);
        x += next.advance;
    }
    return x;
}

double Font::measure(std::string_view text) const
{
    return along(0, text, [](const Glyph&, int, std::string_view) {});
}

std::array<int, 4> Font::bounds(double x, double baseline, std::string_view text) const
{
    constexpr int kHalo = 1;
    std::array<int, 4> bounds{};
    bool any = false;
    along(x, text,
          [&](const Glyph& glyph, int pen, std::string_view)
          {
              const int left = pen + glyph.left - kHalo;
              const int top = static_cast<int>(std::lround(baseline)) + glyph.top - kHalo;
              const std::array<int, 4> own = {left, top, left + glyph.width + 2 * kHalo,
                                              top + glyph.height + 2 * kHalo};
              if (!glyph.coverage.empty())
              {
                  bounds =
                      any ? std::array{std::min(bounds[0], own[0]), std::min(bounds[1], own[1]),
                                       std::max(bounds[2], own[2]), std::max(bounds[3], own[3])}
                          : own;
                  any = true;
              }
          });
    return bounds;
}

std::string Font::shorten(std::string_view text, double width) const
{
    if (measure(text) <= width)
    {
        return std::string(text);
    }
    constexpr std::string_view kEllipsis = "\u2026";
    double used = measure(kEllipsis);
    std::size_t kept = 0;
    along(0, text,
          [&](const Glyph& glyph, int, std::string_view rest)
          {
              used += glyph.advance;
              kept = used <= width ? text.size() - rest.size() : kept;
          });
    return std::string(text.substr(0, kept)).append(kEllipsis);
}

void Font::blend(Image& image, const Glyph& glyph, int x, int y, const Colour& colour)
{
    for (int row = std::max(0, -y); row < std::min(glyph.height, image.height - y); ++row)
    {
        for (int column = std::max(0, -x); column < std::min(glyph.width, image.width - x);
             ++column)
        {
            const int cover = glyph.coverage[static_cast<std::size_t>(row) *
                                                 static_cast<std::size_t>(glyph.width) +
                                             static_cast<std::size_t>(column)];
            std::uint8_t* pixel =
                image.pixels.data() + (image.at(x + column, y + row) - image.at(0, 0));
            if (cover == 0)
            {
                continue;
            }
            // Over what is partly clear, with straight alpha: each colour counts by its coverage.
            const int below = image.channels == 4 ? pixel[3] * (255 - cover) / 255 : 255 - cover;
            for (std::size_t c = 0; c < 3; ++c)
            {
                pixel[c] = static_cast<std::uint8_t>(
                    (pixel[c] * below + colour[c] * cover + (below + cover) / 2) / (below + cover));
            }
            if (image.channels == 4)
            {
                pixel[3] = static_cast<std::uint8_t>(below + cover);
            }
        }
    }
}

void Font::draw(Image& image, double x, double baseline, std::string_view text,
                const Colour& colour, const Colour& halo) const
{
    constexpr std::array<std::array<int, 2>, 8> kAround = {
        {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};
    for (const bool isHalo : {true, false})
    {
        along(x, text,
              [&, isHalo = isHalo](const Glyph& glyph, int pen, std::string_view)
              {
                  const int left = pen + glyph.left;
                  const int top = static_cast<int>(std::lround(baseline)) + glyph.top;
                  if (!isHalo)
                  {
                      blend(image, glyph, left, top, colour);
                      return;
                  }
                  for (const auto& [dx, dy] : kAround)
                  {
                      blend(image, glyph, left + dx, top + dy, halo);
                  }
              });
    }
}

} // namespace frostfill
