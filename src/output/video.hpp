// SPDX-License-Identifier: MIT
// Room: files that a run writes: frames, video, CSV, JSON.
#pragma once

#include <frostfill/image.hpp>

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>

namespace frostfill
{

/// A video made by the program ffmpeg, which gets each frame through a socket. The file appears
/// under its name only when complete.
class Video : public ImageSink
{
public:
    /// The extension selects the format: mp4 (H.264), webm (VP9, with alpha) or gif (up to 15
    /// frames a second, at the same speed). Until it is complete, "film.mp4" is "film.part.mp4"; a
    /// run that is killed leaves that to the next one of the same name. "-" is standard output,
    /// which gets Matroska without loss (FFV1) for another program; what this process prints from
    /// then on goes to standard error. Throws Error usage for another extension and for standard
    /// output that is a terminal, and cannotCreate if ffmpeg or the folder is missing.
    Video(std::filesystem::path file, double framesPerSecond);
    /// Abandons an unfinished video.
    ~Video() override;
    Video(const Video&) = delete;
    Video& operator=(const Video&) = delete;

    /// Takes the next frame; all frames have the shape of the first. Ignores `number`. After a
    /// failure it drops frames without an error, so the pictures of the run are not lost.
    void put(std::size_t number, const Image& image) override;
    /// Waits for ffmpeg. Throws Error writeFailed, with the message of ffmpeg, if there is no
    /// video.
    void finish();

private:
    void create();
    void start(const Image& image);
    void send(const Image& image);
    /// Ends the connection and returns ffmpeg's exit code.
    int close();
    /// What ffmpeg has said last.
    [[nodiscard]] std::string complaint() const;
    [[nodiscard]] std::optional<std::string> makeGif() const;

    std::filesystem::path file_;
    std::filesystem::path part_; ///< the unfinished video
    std::filesystem::path raw_;  ///< all frames without loss, of which a GIF is made
    double framesPerSecond_;
    int output_ = -1; ///< what was standard output, if the video goes there
    int said_ = -1;   ///< a file in memory that ffmpeg writes its messages to
    pid_t process_ = -1;
    int socket_ = -1;
    bool failed_ = false;
    std::size_t frames_ = 0;
};

} // namespace frostfill
