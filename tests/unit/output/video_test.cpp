// SPDX-License-Identifier: MIT
#include "output/video.hpp"

#include "support/temporary_folder.hpp"

#include <frostfill/error.hpp>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <fstream>

namespace frostfill
{
namespace
{

namespace fs = std::filesystem;

Image grey(int width, int height, int channels, std::uint8_t value)
{
    Image image;
    image.width = width;
    image.height = height;
    image.channels = channels;
    image.pixels.assign(static_cast<std::size_t>(width * height * channels), value);
    return image;
}

class VideoTest : public testing::Test
{
protected:
    VideoTest() : path_(std::getenv("PATH") != nullptr ? std::getenv("PATH") : "") {}
    ~VideoTest() override { ::setenv("PATH", path_.c_str(), 1); }

    /// Puts a script in the place of ffmpeg.
    void replaceFfmpeg(const std::string& script)
    {
        const fs::path folder = folder_ / "bin";
        fs::create_directory(folder);
        std::ofstream(folder / "ffmpeg") << "#!/bin/sh\n" << script;
        ::chmod((folder / "ffmpeg").c_str(), 0755);
        ::setenv("PATH", (folder.string() + ":/bin:/usr/bin").c_str(), 1);
    }

    [[nodiscard]] std::size_t filesHere() const
    {
        std::size_t count = 0;
        for (const auto& entry : fs::directory_iterator(folder_.path()))
        {
            count += entry.is_regular_file() ? 1 : 0;
        }
        return count;
    }

    test::TemporaryFolder folder_;
    std::string path_;
};

TEST_F(VideoTest, HandsEveryByteOfEveryFrameToFfmpegInOrder)
{
    // The last argument is the file.
    replaceFfmpeg("for last; do :; done\ncat > \"${last#file:}\"\n");
    const fs::path file = folder_ / "film.mp4";
    {
        Video video(file, 30);
        for (int i = 0; i < 5; ++i)
        {
            video.put(static_cast<std::size_t>(i), grey(400, 300, 3, static_cast<std::uint8_t>(i)));
        }
        EXPECT_FALSE(fs::exists(file)) << "it must not be there before it is complete";
        video.finish();
    }
    std::ifstream in(file, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    ASSERT_EQ(bytes.size(), 5U * 400 * 300 * 3);
    for (std::size_t i = 0; i < bytes.size(); i += 9973)
    {
        ASSERT_EQ(static_cast<std::size_t>(bytes[i]), i / (400 * 300 * 3));
    }
    EXPECT_EQ(filesHere(), 1U);
}

TEST_F(VideoTest, TellsWhatFfmpegSaidWhenItFailsAndLeavesNothing)
{
    replaceFfmpeg("head -c 1000 >/dev/null\necho 'no such codec' >&2\nexit 1\n");
    {
        Video video(folder_ / "film.webm", 30);
        for (std::size_t i = 0; i < 20; ++i)
        {
            EXPECT_NO_THROW(video.put(i, grey(400, 300, 4, 1))); // beyond what a socket holds
        }
        try
        {
            video.finish();
            ADD_FAILURE() << "it did not fail";
        }
        catch (const Error& error)
        {
            EXPECT_EQ(error.code(), ErrorCode::writeFailed);
            EXPECT_NE(std::string(error.what()).find("no such codec"), std::string::npos);
        }
    }
    EXPECT_EQ(filesHere(), 0U);
}

TEST_F(VideoTest, LeavesNothingWhenItIsGivenUp)
{
    replaceFfmpeg("cat >/dev/null\n");
    {
        Video video(folder_ / "film.gif", 30);
        video.put(0, grey(20, 10, 3, 1));
    }
    EXPECT_EQ(filesHere(), 0U);
}

TEST_F(VideoTest, IsRefusedAtOnceWithoutFfmpegOrWithAnUnknownEnding)
{
    const auto code = [&](const char* name)
    {
        try
        {
            const Video video(folder_ / name, 30);
        }
        catch (const Error& error)
        {
            return error.code();
        }
        return ErrorCode{};
    };
    replaceFfmpeg("exit 0\n");
    EXPECT_EQ(code("film.avi"), ErrorCode::usage);
    EXPECT_EQ(code("missing/film.mp4"), ErrorCode::cannotCreate);
    ::setenv("PATH", "/nowhere", 1);
    EXPECT_EQ(code("film.mp4"), ErrorCode::cannotCreate);
}

TEST_F(VideoTest, RealFfmpegMakesEveryKind)
{
    if (std::system("command -v ffmpeg >/dev/null 2>&1") != 0)
    {
        GTEST_SKIP() << "there is no ffmpeg";
    }
    for (const char* name : {"a.mp4", "b.webm", "c.gif"})
    {
        Video video(folder_ / name, 25);
        for (std::size_t i = 0; i < 6; ++i)
        {
            video.put(i, grey(63, 35, 3, static_cast<std::uint8_t>(40 * i))); // odd sides
        }
        video.finish();
        EXPECT_GT(fs::file_size(folder_ / name), 200U) << name;
    }
    EXPECT_EQ(filesHere(), 3U);
}

} // namespace
} // namespace frostfill
