// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace frostfill
{

/// Where ffmpeg writes what it has to say while it makes a video. It is locked as long as this
/// lives, so the next video of the same name knows which unfinished files are no longer in use.
class VideoLog
{
public:
    /// Removes what killed runs have left of a video of that name. The files are NAME.PROCESS.log,
    /// NAME.PROCESS.part.ENDING and NAME.PROCESS.raw.mkv. Throws Error cannotCreate.
    explicit VideoLog(const std::filesystem::path& video);
    /// Removes these files.
    ~VideoLog();
    VideoLog(const VideoLog&) = delete;
    VideoLog& operator=(const VideoLog&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return log_; }
    /// The unfinished video.
    [[nodiscard]] const std::filesystem::path& part() const { return part_; }
    /// All frames without loss, of a format that has to see them all before it can be made.
    [[nodiscard]] const std::filesystem::path& raw() const { return raw_; }
    /// The last line that ffmpeg has written; empty if there is none.
    [[nodiscard]] std::string lastLine() const;

private:
    std::filesystem::path log_;
    std::filesystem::path part_;
    std::filesystem::path raw_;
    int descriptor_ = -1;
};

} // namespace frostfill
