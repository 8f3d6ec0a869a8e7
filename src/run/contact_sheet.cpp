// SPDX-License-Identifier: MIT
#include "run/contact_sheet.hpp"

#include "render/overlay/text.hpp"

#include <frostfill/output.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace frostfill
{
namespace
{

constexpr std::size_t kMaxTiles = 12;
constexpr int kColumns = 4;
constexpr int kTileWidth = 480; // [pixel]
constexpr int kMargin = 24;
constexpr double kTitleType = 26;
constexpr double kCaptionType = 19;

/// Pixel of a picture over a ground, as shares of 255.
std::array<double, 3> pixelOver(const Image& image, int x, int y, const Colour& ground)
{
    const std::uint8_t* pixel = image.at(x, y);
    const double alpha = image.channels == 4 ? pixel[3] / 255.0 : 1;
    std::array<double, 3> result{};
    for (std::size_t c = 0; c < 3; ++c)
    {
        result[c] = alpha * pixel[c] + (1 - alpha) * ground[c];
    }
    return result;
}

/// Draws part of a picture smaller: each pixel is the mean of those that it covers.
void drawSmaller(const Image& from, const Crop& crop, Image& sheet, const Crop& place,
                 const Colour& ground)
{
    const double step =
        static_cast<double>(crop.right - crop.left) / std::max(1, place.right - place.left);
    for (int y = place.top; y < place.bottom; ++y)
    {
        for (int x = place.left; x < place.right; ++x)
        {
            const auto first = [&](int at, int start)
            { return static_cast<int>((at - start) * step); };
            const int u0 = crop.left + first(x, place.left);
            const int v0 = crop.top + first(y, place.top);
            const int u1 = std::max(u0 + 1, crop.left + first(x + 1, place.left));
            const int v1 = std::max(v0 + 1, crop.top + first(y + 1, place.top));
            std::array<double, 3> sum{};
            int count = 0;
            for (int v = v0; v < std::min(v1, from.height); ++v)
            {
                for (int u = u0; u < std::min(u1, from.width); ++u, ++count)
                {
                    const auto pixel = pixelOver(from, u, v, ground);
                    for (std::size_t c = 0; c < 3; ++c)
                    {
                        sum[c] += pixel[c];
                    }
                }
            }
            std::uint8_t* to = sheet.pixels.data() + (sheet.at(x, y) - sheet.at(0, 0));
            for (std::size_t c = 0; count > 0 && c < 3; ++c)
            {
                to[c] = static_cast<std::uint8_t>(std::lround(sum[c] / count));
            }
        }
    }
}

Image emptySheet(int width, int height, const Colour& ground)
{
    Image sheet;
    sheet.width = width;
    sheet.height = height;
    sheet.pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
    for (std::size_t i = 0; i < sheet.pixels.size(); ++i)
    {
        sheet.pixels[i] = ground[i % 3];
    }
    return sheet;
}

} // namespace

Image makeContactSheet(const ContactSheetRequest& request)
{
    // A sheet without frames is a title on nothing; a transparent ground becomes white paper.
    Colour ground = request.palette.background;
    if (ground[3] < 255)
    {
        ground = {255, 255, 255, 255};
    }
    const auto tiles = static_cast<int>(std::min(kMaxTiles, request.numbers.size()));
    const int columns = std::clamp(tiles, 1, kColumns);
    const int rows = (tiles + columns - 1) / columns;
    const Crop& crop = request.crop;
    const int width = std::clamp(crop.right - crop.left, 1, kTileWidth);
    const int height =
        std::max(1, static_cast<int>(std::lround(static_cast<double>(crop.bottom - crop.top) *
                                                 width / std::max(1, crop.right - crop.left))));
    const int caption = static_cast<int>(1.6 * kCaptionType);
    const int header = kMargin + static_cast<int>(1.4 * kTitleType);
    Image sheet = emptySheet(columns * (width + kMargin) + kMargin,
                             header + rows * (height + caption + kMargin) + kMargin / 2, ground);

    const Font titleFont(kTitleType);
    const Font font(kCaptionType);
    const Colour& ink = request.palette.text;
    titleFont.draw(sheet, kMargin, kMargin + 0.75 * kTitleType,
                   titleFont.shorten(request.title, sheet.width - 2 * kMargin), ink, ground);
    for (int tile = 0; tile < tiles; ++tile)
    {
        const std::size_t index = tiles == 1 ? 0
                                             : static_cast<std::size_t>(tile) *
                                                   (request.numbers.size() - 1) /
                                                   static_cast<std::size_t>(tiles - 1);
        const Image frame = loadPng(request.frames / PngSequence::fileName(request.numbers[index]));
        Crop place;
        place.left = kMargin + tile % columns * (width + kMargin);
        place.top = header + kMargin / 2 + tile / columns * (height + caption + kMargin);
        place.right = place.left + width;
        place.bottom = place.top + height;
        drawSmaller(frame, crop, sheet, place, ground);
        const std::string text = index < request.times.size()
                                     ? fmt::format("{:.3f} s", request.times[index])
                                     : std::string();
        font.draw(sheet, place.left + (width - font.measure(text)) / 2,
                  place.bottom + 1.1 * kCaptionType, text, ink, ground);
    }
    return sheet;
}

void writeContactSheet(const Scene& scene, const std::filesystem::path& directory,
                       const FramePainter& painter)
{
    const auto& [left, top, right, bottom] = painter.drawn().objectRegion;
    ContactSheetRequest sheet;
    sheet.frames = directory / "frames";
    sheet.numbers = painter.drawn().numbers;
    sheet.times = painter.drawn().moments;
    sheet.title = scene.name;
    sheet.palette = scene.style.palette;
    sheet.crop = {left, top, right, bottom};
    savePng(makeContactSheet(sheet), directory / "contact_sheet.png",
            {{"Software", "Frostfill"}, {"Title", scene.name}});
}

} // namespace frostfill
