// SPDX-License-Identifier: MIT
#include "image/png_bands.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

using test::readFile;
using test::TemporaryFolder;
using test::writeFile;

class PngFactsTest : public ::testing::Test
{
protected:
    PngFactsTest()
    {
        Image image;
        image.width = 40;
        image.height = 30;
        image.channels = 3;
        for (std::size_t i = 0; i < 3600; ++i)
        {
            image.pixels.push_back(static_cast<std::uint8_t>(i * i % 251));
        }
        savePng(image, file_, {{"Title", "of it"}, {"Empty", ""}});
        bytes_ = readFile(file_);
    }
    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "a.png";
    std::string bytes_;
};

TEST_F(PngFactsTest, TellsSizeTextAndBytes)
{
    const auto facts = pngFacts(file_);
    ASSERT_TRUE(facts);
    EXPECT_EQ(facts->width, 40);
    EXPECT_EQ(facts->height, 30);
    EXPECT_EQ(facts->text, (PngText{{"Title", "of it"}, {"Empty", ""}}));
    EXPECT_GT(facts->packedBytes, 100U);
    EXPECT_LT(facts->packedBytes, bytes_.size());
}

TEST_F(PngFactsTest, AreThereForNoFileThatIsCutOrLonger)
{
    for (std::size_t length = 0; length < bytes_.size(); ++length)
    {
        writeFile(file_, bytes_.substr(0, length));
        EXPECT_FALSE(pngFacts(file_)) << length;
    }
    writeFile(file_, bytes_ + "x");
    EXPECT_FALSE(pngFacts(file_));
    EXPECT_FALSE(pngFacts(folder_ / "missing.png"));
}

TEST_F(PngFactsTest, AreThereForNoFileOfWhichAByteIsAnother)
{
    for (std::size_t at = 0; at < bytes_.size(); ++at)
    {
        std::string damaged = bytes_;
        damaged[at] = static_cast<char>(damaged[at] ^ 4);
        writeFile(file_, damaged);
        EXPECT_FALSE(pngFacts(file_)) << at;
    }
}

} // namespace
} // namespace frostfill
