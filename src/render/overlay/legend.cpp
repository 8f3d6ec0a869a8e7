// SPDX-License-Identifier: MIT
#include "render/overlay/legend.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace frostfill
{
namespace
{

// Lengths are in the font's size, so that the legend looks the same in a picture of any size.
constexpr double kLegendMargin = 0.9;
constexpr double kLine = 1.45;
constexpr double kGap = 0.55; ///< above a heading
constexpr double kTitleSize = 1.2;
constexpr double kLabelIndent = 1.5;
constexpr double kSwatchRadius = 0.44;
constexpr double kNumberGap = 0.9;

constexpr double kScaleHeight = 0.8;

/// Smaller type than this cannot be read [pixel].
constexpr double kSmallestType = 9;

/// Lines of type in a picture's height, and widths of a letter in its width.
constexpr double kLinesInHeight = 40;
constexpr double kLettersInWidth = 62;

/// Largest share of the picture that the legend may take in both directions at once.
constexpr double kLargestWidth = 0.45;
constexpr double kLargestHeight = 0.96;

/// As wide as any count is expected to be; a greater one grows to the right.
constexpr std::string_view kWidestNumber = "000000";

/// Rows with a number below this count spheres, the others polygons.
constexpr int kPolygonRow = 3;
/// From this on they count all, and have no swatch.
constexpr int kTotalRow = 5;

/// In the place of a number: a row without one, with and without a gap above.
constexpr int kHeading = -1;
constexpr int kNoSwatch = -2;

/// Around text, so that it can be read also where the background is clear.
Colour haloOf(const Palette& palette)
{
    const Colour& ground = palette.background;
    return {ground[0], ground[1], ground[2], 255};
}

} // namespace

Legend::Legend(const RenderSettings& settings, std::size_t triangles, const SphereColours& colours)
    : size_(settings.size), palette_(settings.style.palette), triangles_(triangles)
{
    if (!settings.style.legend)
    {
        return;
    }
    // Of a supersampled picture the small one is to be read.
    const double factor = settings.supersample;
    const double size =
        factor *
        std::round(std::max(kSmallestType, std::min(size_.height / factor / kLinesInHeight,
                                                    size_.width / factor / kLettersInWidth)));
    font_.emplace(size);
    titleFont_.emplace(std::round(kTitleSize * size));
    if (colours.hasScale())
    {
        colours_ = colours;
    }
    title_ = titleFont_->shorten(settings.title, size_.width - 2 * kLegendMargin * size);
    layOut();
    visible_ = width_ <= kLargestWidth * size_.width && height_ <= kLargestHeight * size_.height;
    if (!visible_)
    {
        spheres_.clear();
        polygons_.clear();
    }
}

double Legend::titleHeight() const
{
    return visible_ && !title_.empty() ? (kLegendMargin + kTitleSize * kLine) * font_->size() : 0;
}

void Legend::addRow(const std::string& label, int number)
{
    const double size = font_->size();
    if (number == kHeading && !rows_.empty())
    {
        height_ += kGap * size;
    }
    // Letters stand on a line that leaves a fifth of the type's size below it.
    const double baseline = height_ + (0.5 * (kLine - 1) + 0.85) * size;
    rows_.push_back({label, baseline, number});
    if (number >= 0 && number < kTotalRow)
    {
        // Swatches are centred on the small letters. Halves of pixels keep them symmetrical.
        const double y = std::round(baseline - 0.3 * size);
        const double x = std::round((kLegendMargin + 0.5) * size);
        auto& swatches = number < kPolygonRow ? spheres_ : polygons_;
        swatches.push_back(
            {x, y, kSwatchRadius * size, number < kPolygonRow ? number : number - kPolygonRow});
    }
    height_ += kLine * size;
}

void Legend::layOut()
{
    const double size = font_->size();
    height_ = kLegendMargin * size + (title_.empty() ? 0 : (kTitleSize * kLine + kGap) * size);
    if (hasOneColour(palette_))
    {
        addRow("spheres", kTotalRow);
        addRow("polygons", kTotalRow + 1);
    }
    else
    {
        addRow("Spheres", kHeading);
        addRow("running", 0);
        addRow("frozen", 1);
        addRow("discarded", 2);
        addRow("Polygons", kHeading);
        addRow("active", 3);
        addRow("discarded", 4);
    }
    // What is drawn here is known only with the snapshot.
    firstOfPicture_ = rows_.size();
    addRow("", kHeading);
    addRow("", kNoSwatch);
    if (colours_)
    {
        addRow(colours_->title(), kHeading);
        scaleTop_ = height_;
        height_ += (kScaleHeight + kLine) * size;
    }
    height_ += (kLegendMargin - kGap) * size;

    double label = 0;
    for (const Row& row : rows_)
    {
        label = std::max(label, font_->measure(row.label));
    }
    width_ = (2 * kLegendMargin + kLabelIndent + kNumberGap) * size + label +
             font_->measure(kWidestNumber);
}

std::vector<Legend::Piece> Legend::pieces(const Snapshot& snapshot) const
{
    std::vector<Piece> pieces;
    if (!visible_)
    {
        return pieces;
    }
    const double size = font_->size();
    const double left = kLegendMargin * size;
    const auto write = [&](double x, double baseline, std::string text) {
        pieces.push_back({Piece::Kind::text, x, baseline, std::move(text)});
    };

    pieces.push_back({Piece::Kind::title, left, (kLegendMargin + kTitleSize * 0.9) * size, title_});
    const std::array<std::size_t, 7> counts = {
        snapshot.running,
        snapshot.frozen,
        snapshot.discarded,
        triangles_ - std::min(triangles_, snapshot.discardedPolygons),
        snapshot.discardedPolygons,
        snapshot.running + snapshot.frozen + snapshot.discarded,
        triangles_};
    for (const Row& row : rows_)
    {
        if (row.number < 0)
        {
            write(left, row.baseline, row.label);
            continue;
        }
        write(left + (row.number < kTotalRow ? kLabelIndent * size : 0), row.baseline, row.label);
        const std::string number = fmt::format("{}", counts[static_cast<std::size_t>(row.number)]);
        const double right = width_ - kLegendMargin * size;
        const double room = font_->measure(kWidestNumber);
        write(right - std::min(room, font_->measure(number)), row.baseline, number);
    }
    write(left, rows_[firstOfPicture_].baseline,
          fmt::format("set {}  step {}", snapshot.set, snapshot.step));
    write(left, rows_[firstOfPicture_ + 1].baseline, fmt::format("{:.3f} s", snapshot.time));
    if (colours_)
    {
        addScale(pieces);
    }
    return pieces;
}

void Legend::addScale(std::vector<Piece>& pieces) const
{
    pieces.push_back({Piece::Kind::bar, 0, 0, {}});
    const double size = font_->size();
    const auto [left, top, right, bottom] = barBounds();
    const double baseline = scaleTop_ + (kScaleHeight + 0.5 * (kLine - 1) + 0.85) * size;
    const auto& [low, high] = colours_->range();
    for (const double value : roundNumbers(colours_->range(), colours_->countsWhole()))
    {
        const double place = high > low ? (value - low) / (high - low) : 0;
        const std::string text = fmt::format("{:.6g}", value);
        // Under its colour, but not beyond the bar.
        const double wide = font_->measure(text);
        const double x = std::clamp(left + place * (right - left) - wide / 2, double(left),
                                    std::max<double>(left, right - wide));
        pieces.push_back({Piece::Kind::text, x, baseline, text});
    }
}

const Font& Legend::fontOf(const Piece& piece) const
{
    return piece.kind == Piece::Kind::title ? *titleFont_ : *font_;
}

PixelRectangle Legend::bounds(const Piece& piece) const
{
    const auto [left, top, right, bottom] =
        piece.kind == Piece::Kind::bar ? barBounds()
                                       : fontOf(piece).bounds(piece.x, piece.baseline, piece.text);
    const PixelRectangle inside = common({left, size_.height - bottom, right, size_.height - top},
                                         {0, 0, size_.width, size_.height});
    return inside.empty() ? PixelRectangle{} : inside;
}

void Legend::draw(Image& image, const Piece& piece) const
{
    if (piece.kind == Piece::Kind::bar)
    {
        drawBar(image);
        return;
    }
    fontOf(piece).draw(image, piece.x, piece.baseline, piece.text, palette_.text, haloOf(palette_));
}

std::array<int, 4> Legend::barBounds() const
{
    const double size = font_->size();
    return {static_cast<int>(std::lround(kLegendMargin * size)),
            static_cast<int>(std::lround(scaleTop_)),
            static_cast<int>(std::lround(width_ - kLegendMargin * size)),
            static_cast<int>(std::lround(scaleTop_ + kScaleHeight * size))};
}

void Legend::drawBar(Image& image) const
{
    const auto [left, top, right, bottom] = barBounds();
    for (int y = std::max(0, top); y < std::min(bottom, image.height); ++y)
    {
        for (int x = std::max(0, left); x < std::min(right, image.width); ++x)
        {
            const Colour colour = colours_->scaled((x - left) / std::max(1.0, right - left - 1.0));
            std::copy_n(colour.begin(), image.channels,
                        image.pixels.data() + (image.at(x, y) - image.at(0, 0)));
        }
    }
}

Framing frameBesideLegend(std::span<const Eigen::Vector3d> vertices, const RenderSettings& settings,
                          const Legend& legend)
{
    const double width = settings.size.width;
    const double height = settings.size.height;
    if (!legend.visible())
    {
        return frame(vertices, settings, {0, 0, width, height});
    }
    // The title may be wider than the rest of the legend: nothing stands beside it.
    const Framing beside =
        frame(vertices, settings, {legend.width(), legend.titleHeight(), width, height});
    const Framing below = frame(vertices, settings, {0, legend.height(), width, height});
    return below.reach < beside.reach ? below : beside;
}

} // namespace frostfill
