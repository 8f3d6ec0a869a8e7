// SPDX-License-Identifier: MIT
#include "support/load_png.hpp"
#include "support/paths.hpp"

#include <frostfill/error.hpp>
#include <frostfill/image.hpp>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

namespace frostfill
{
namespace
{

namespace fs = std::filesystem;

/// A directory of its own for each test, removed afterwards.
class Png : public testing::Test
{
protected:
    Png() : directory(testing_support::testOutput() / testName())
    {
        fs::remove_all(directory);
        fs::create_directories(directory);
    }
    ~Png() override { fs::remove_all(directory); }

    static std::string testName()
    {
        return testing::UnitTest::GetInstance()->current_test_info()->name();
    }

    fs::path directory;
};

/// Pixels without any pattern that a filter could get right by chance.
Image noise(int width, int height, int channels)
{
    Image image{width, height, channels, {}};
    std::uint32_t state = 1;
    for (int i = 0; i < width * height * channels; ++i)
    {
        state = state * 1664525U + 1013904223U;
        image.pixels.push_back(static_cast<std::uint8_t>(state >> 24));
    }
    return image;
}

std::uint32_t bigEndian(const std::uint8_t* bytes)
{
    return std::uint32_t{bytes[0]} << 24 | std::uint32_t{bytes[1]} << 16 |
           std::uint32_t{bytes[2]} << 8 | bytes[3];
}

/// Bit by bit, as in the appendix of the PNG specification: slow and surely right.
std::uint32_t crc32(const std::uint8_t* bytes, std::size_t count)
{
    std::uint32_t crc = 0xffffffffU;
    for (std::size_t i = 0; i < count; ++i)
    {
        crc ^= bytes[i];
        for (int bit = 0; bit < 8; ++bit)
        {
            crc = (crc & 1U) != 0 ? 0xedb88320U ^ crc >> 1 : crc >> 1;
        }
    }
    return ~crc;
}

struct Chunk
{
    std::string type;
    std::string data;
    bool sound = false;
};

std::vector<Chunk> chunksOf(const std::vector<std::uint8_t>& png)
{
    std::vector<Chunk> chunks;
    for (std::size_t at = 8; at + 12 <= png.size();)
    {
        const std::size_t size = bigEndian(&png[at]);
        const char* type = reinterpret_cast<const char*>(&png[at + 4]);
        chunks.push_back({{type, 4},
                          {type + 4, size},
                          crc32(&png[at + 4], size + 4) == bigEndian(&png[at + 8 + size])});
        at += size + 12;
    }
    return chunks;
}

TEST_F(Png, PixelsComeBackAsTheyWere)
{
    for (const int channels : {3, 4})
    {
        const Image image = noise(37, 19, channels);
        savePng(image, directory / "picture.png");
        const Image back = loadPng(directory / "picture.png");
        EXPECT_EQ(back.width, 37);
        EXPECT_EQ(back.height, 19);
        EXPECT_EQ(back.channels, channels);
        EXPECT_EQ(back.pixels, image.pixels);
    }
}

TEST_F(Png, OnePixelIsAPictureToo)
{
    const Image image = noise(1, 1, 3);
    savePng(image, directory / "picture.png");
    EXPECT_EQ(loadPng(directory / "picture.png").pixels, image.pixels);
}

TEST_F(Png, TextStandsBetweenHeaderAndPixels)
{
    const std::vector<std::uint8_t> png =
        encodePng(noise(8, 8, 3), {{"Software", "Frostfill"}, {"Scene", "torus\n320 spheres"}});
    const std::vector<Chunk> chunks = chunksOf(png);
    ASSERT_EQ(chunks.size(), 6U);
    EXPECT_EQ(chunks[0].type, "IHDR");
    EXPECT_EQ(chunks[1].type, "tEXt");
    EXPECT_EQ(chunks[1].data, std::string("Software\0Frostfill", 18));
    EXPECT_EQ(chunks[2].data, std::string("Scene\0torus\n320 spheres", 23));
    EXPECT_EQ(chunks[3].type, "IDAT");
    EXPECT_EQ(chunks[4].type, "IDAT");
    EXPECT_EQ(chunks[5].type, "IEND");
    for (const Chunk& chunk : chunks)
    {
        EXPECT_TRUE(chunk.sound) << chunk.type;
    }
}

TEST_F(Png, PictureWithTextCanBeRead)
{
    const Image image = noise(8, 8, 4);
    savePng(image, directory / "picture.png", {{"Software", "Frostfill"}});
    EXPECT_EQ(loadPng(directory / "picture.png").pixels, image.pixels);
}

TEST_F(Png, NothingIsLeftBesideThePicture)
{
    savePng(noise(8, 8, 3), directory / "picture.png");
    savePng(noise(9, 9, 3), directory / "picture.png");
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(directory))
    {
        files.push_back(entry.path().filename());
    }
    EXPECT_EQ(files, std::vector<fs::path>{"picture.png"});
}

ErrorCode codeOf(const std::function<void()>& action, std::string& message)
{
    try
    {
        action();
    }
    catch (const Error& error)
    {
        message = error.what();
        return error.code();
    }
    return ErrorCode{};
}

TEST_F(Png, MissingDirectoryIsNamed)
{
    std::string message;
    const fs::path file = directory / "none" / "picture.png";
    EXPECT_EQ(codeOf([&] { savePng(noise(2, 2, 3), file); }, message), ErrorCode::cannotCreate);
    EXPECT_NE(message.find(file.string()), std::string::npos) << message;
    EXPECT_NE(message.find("No such file"), std::string::npos) << message;
}

TEST_F(Png, DirectoryInThePlaceOfThePictureLeavesNoTemporaryFile)
{
    fs::create_directories(directory / "picture.png" / "inside");
    std::string message;
    EXPECT_EQ(codeOf([&] { savePng(noise(2, 2, 3), directory / "picture.png"); }, message),
              ErrorCode::cannotCreate);
    EXPECT_EQ(std::distance(fs::directory_iterator(directory), fs::directory_iterator()), 1);
}

} // namespace
} // namespace frostfill
