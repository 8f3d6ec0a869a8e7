// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/image.hpp>

#include <sys/types.h>

#include <filesystem>
#include <string>

namespace frostfill
{

/// A video made by the program ffmpeg, which gets the frames through a socket as they come. It
/// appears under its name only when it is complete.
class Video : public ImageSink
{
public:
    /// Starts ffmpeg. The name's ending says what is made: mp4 (H.264), webm (VP9, with alpha) or
    /// gif. Throws Error usage for another ending and cannotCreate when there is no ffmpeg.
    Video(std::filesystem::path file, double framesPerSecond);
    /// Gives up what is not finished.
    ~Video() override;
    Video(const Video&) = delete;
    Video& operator=(const Video&) = delete;

    /// Takes the next frame; all have the shape of the first. Numbers are not looked at. After a
    /// failure frames are dropped: pictures that are written beside must not be lost for it.
    void put(std::size_t number, const Image& image) override;
    /// Waits for ffmpeg. Throws Error writeFailed with what ffmpeg said when there is no video.
    void finish();

private:
    void start(const Image& image);
    void send(const Image& image);
    /// Ends the connection and returns ffmpeg's exit status.
    int close();
    [[nodiscard]] std::string complaint() const;

    std::filesystem::path file_;
    std::filesystem::path part_;
    std::filesystem::path log_;
    double framesPerSecond_;
    pid_t process_ = -1;
    int socket_ = -1;
    bool failed_ = false;
    std::size_t frames_ = 0;
};

} // namespace frostfill
