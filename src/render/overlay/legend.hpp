// SPDX-License-Identifier: MIT
// Room: what is written over a picture: the legend, colour scales and text. Text is drawn on the
// processor.
#pragma once

#include "render/framing/framing.hpp"
#include "render/framing/pixel_rectangle.hpp"
#include "render/overlay/colour_scale.hpp"
#include "render/overlay/text.hpp"

#include <frostfill/renderer.hpp>
#include <frostfill/snapshot.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace frostfill
{

/// The key to the picture and its numbers, in the upper left corner. Its swatches are drawn by what
/// draws the scene in tiles, so that they show the very same cues.
class Legend
{
public:
    /// A swatch [pixel], from the upper left corner.
    struct Swatch
    {
        double x, y; ///< centre
        double halfSize;
        int state; ///< number of the SphereState or PolygonState
    };

    /// `triangles` is their number in the mesh.
    Legend(const RenderSettings& settings, std::size_t triangles, const SphereColours& colours);

    /// Off, or left out of a picture that is too small for readable type.
    [[nodiscard]] bool visible() const { return visible_; }
    [[nodiscard]] double width() const { return width_; }   ///< [pixel] margins included
    [[nodiscard]] double height() const { return height_; } ///< [pixel] margins included
    [[nodiscard]] double titleHeight() const;               ///< [pixel] 0 without title

    [[nodiscard]] const std::vector<Swatch>& spheres() const { return spheres_; }
    [[nodiscard]] const std::vector<Swatch>& polygons() const { return polygons_; }

    /// Something that is drawn into the finished picture: a line, the bar of the scale, or all
    /// swatches, which others draw.
    struct Piece
    {
        enum class Kind : std::uint8_t
        {
            text,
            title,
            bar,
            swatches
        };
        Kind kind = Kind::text;
        double x = 0, baseline = 0; ///< [pixel] of a line's first letter
        std::string text;
        friend bool operator==(const Piece&, const Piece&) = default;
    };

    /// What there is to draw for a snapshot, in its order: always the same number of pieces, of
    /// which most are the same for all snapshots. None when the legend is not visible.
    [[nodiscard]] std::vector<Piece> pieces(const Snapshot& snapshot) const;
    /// The part of the picture that a piece touches.
    [[nodiscard]] PixelRectangle bounds(const Piece& piece) const;
    void draw(Image& image, const Piece& piece) const;

private:
    /// A line of the table: what stands to the right of a swatch, or alone.
    struct Row
    {
        std::string label;
        double baseline = 0;
        int number = -1; ///< index of the count to the right; negative for none
    };

    void addRow(const std::string& label, int number);
    void layOut();
    /// Of the bar of the scale: left, top, right, bottom [pixel], y downwards.
    [[nodiscard]] std::array<int, 4> barBounds() const;
    void drawBar(Image& image) const;
    void addScale(std::vector<Piece>& pieces) const;
    [[nodiscard]] const Font& fontOf(const Piece& piece) const;

    PictureSize size_;
    Palette palette_;
    std::size_t triangles_;
    std::optional<SphereColours> colours_; ///< when there is a scale to show
    double scaleTop_ = 0;                  ///< [pixel]
    bool visible_ = false;
    std::optional<Font> font_;
    std::optional<Font> titleFont_;
    std::string title_;
    double width_ = 0;
    double height_ = 0;
    std::vector<Row> rows_;
    std::size_t firstOfPicture_ = 0; ///< the row of set and step; that of the time follows
    std::vector<Swatch> spheres_;
    std::vector<Swatch> polygons_;
};

/// Where the object goes so that the legend does not cover it: beside the legend, or below it,
/// whichever shows the object larger.
[[nodiscard]] Framing frameBesideLegend(std::span<const Eigen::Vector3d> vertices,
                                        const RenderSettings& settings, const Legend& legend);

} // namespace frostfill
