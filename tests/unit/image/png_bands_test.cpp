// SPDX-License-Identifier: MIT
// The encoder of sequences, read by libpng.
#include "image/png_bands.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>

namespace frostfill
{
namespace
{

struct Decoded
{
    Image image;
    std::map<std::string, std::string> text;
};

/// By libpng, which checks every checksum and gives up at the first fault.
Decoded decode(const std::vector<std::uint8_t>& file)
{
    struct Source
    {
        const std::uint8_t* at;
        std::size_t left;
    } source{file.data(), file.size()};
    Decoded result;
    std::string message;
    png_structp png = png_create_read_struct(
        PNG_LIBPNG_VER_STRING, &message,
        [](png_structp failed, png_const_charp what)
        {
            *static_cast<std::string*>(png_get_error_ptr(failed)) = what;
            throw std::runtime_error(what);
        },
        [](png_structp, png_const_charp what) { ADD_FAILURE() << "libpng warns: " << what; });
    png_infop info = png_create_info_struct(png);
    png_set_read_fn(png, &source,
                    [](png_structp reader, png_bytep to, png_size_t count)
                    {
                        auto& from = *static_cast<Source*>(png_get_io_ptr(reader));
                        if (count > from.left)
                        {
                            png_error(reader, "the file ends early");
                        }
                        std::copy_n(from.at, count, to);
                        from.at += count;
                        from.left -= count;
                    });
    png_read_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
    result.image.width = static_cast<int>(png_get_image_width(png, info));
    result.image.height = static_cast<int>(png_get_image_height(png, info));
    result.image.channels = png_get_channels(png, info);
    for (int y = 0; y < result.image.height; ++y)
    {
        const png_bytep row = png_get_rows(png, info)[y];
        result.image.pixels.insert(result.image.pixels.end(), row,
                                   row + png_get_rowbytes(png, info));
    }
    png_textp texts = nullptr;
    const int count = png_get_text(png, info, &texts, nullptr);
    for (int i = 0; i < count; ++i)
    {
        result.text[texts[i].key] = texts[i].text;
    }
    EXPECT_EQ(source.left, 0U) << "bytes after the end";
    png_destroy_read_struct(&png, &info, nullptr);
    return result;
}

class Pictures
{
public:
    std::uint8_t next()
    {
        state_ = state_ * 1664525U + 1013904223U;
        return static_cast<std::uint8_t>(state_ >> 24);
    }

    /// Smooth on the left, noise on the right.
    Image make(int width, int height, int channels)
    {
        Image image{width, height, channels, {}};
        for (int y = 0; y < height; ++y)
        {
            for (int i = 0; i < width * channels; ++i)
            {
                image.pixels.push_back(i < width ? static_cast<std::uint8_t>(y + i) : next());
            }
        }
        return image;
    }

private:
    std::uint32_t state_ = 7;
};

TEST(PngBands, LibpngReadsBackEveryShape)
{
    Pictures pictures;
    for (const int channels : {3, 4})
    {
        for (const auto& [width, height] :
             {std::pair{1, 1}, {1, 15}, {640, 16}, {33, 17}, {7, 300}, {1280, 720}})
        {
            const Image image = pictures.make(width, height, channels);
            PngBands encoder;
            const Decoded decoded = decode(encoder.encode(image, {{"Software", "x"}}));
            EXPECT_EQ(decoded.image.width, width);
            EXPECT_EQ(decoded.image.height, height);
            EXPECT_EQ(decoded.image.channels, channels);
            EXPECT_EQ(decoded.image.pixels, image.pixels) << width << "x" << height;
        }
    }
}

TEST(PngBands, CarriesTextsOfEachPicture)
{
    Pictures pictures;
    const Image image = pictures.make(40, 40, 3);
    PngBands encoder;
    const std::vector<std::uint8_t> unchanged(40, 0);
    for (const char* frame : {"0", "17"})
    {
        const Decoded decoded =
            decode(encoder.encode(image, {{"Software", "Frostfill"}, {"Frame", frame}}, unchanged));
        EXPECT_EQ(decoded.text.at("Software"), "Frostfill");
        EXPECT_EQ(decoded.text.at("Frame"), frame);
    }
}

TEST(PngBands, KeptBandsGiveTheBytesOfCompressingAll)
{
    Pictures pictures;
    Image image = pictures.make(200, 90, 3);
    PngBands reusing;
    std::vector<std::uint8_t> changed(90, 1);
    for (int frame = 0; frame < 40; ++frame)
    {
        const std::vector<std::uint8_t> all = encodePng(image);
        EXPECT_EQ(reusing.encode(image, {}, changed), all) << frame;
        EXPECT_EQ(decode(all).image.pixels, image.pixels) << frame;
        // One row at a time, those at the borders of bands too.
        std::fill(changed.begin(), changed.end(), std::uint8_t{0});
        const int row = (frame * 7 + frame / 3) % 90;
        changed[static_cast<std::size_t>(row)] = 1;
        const auto first = image.pixels.begin() + std::ptrdiff_t{row} * 600;
        std::generate(first, first + 600, [&] { return pictures.next(); });
    }
}

TEST(PngBands, CompressesOnlyWhatIsSaidToHaveChanged)
{
    Pictures pictures;
    const Image before = pictures.make(64, 64, 3);
    const Image after = pictures.make(64, 64, 3);
    PngBands encoder;
    encoder.encode(before, {});
    std::vector<std::uint8_t> changed(64, 0);
    EXPECT_EQ(decode(encoder.encode(after, {}, changed)).image.pixels, before.pixels);
}

TEST(PngBands, ANewShapeStartsAgain)
{
    Pictures pictures;
    PngBands encoder;
    encoder.encode(pictures.make(64, 64, 3), {});
    const Image image = pictures.make(48, 64, 4);
    EXPECT_EQ(decode(encoder.encode(image, {}, std::vector<std::uint8_t>(64, 0))).image.pixels,
              image.pixels);
}

} // namespace
} // namespace frostfill
