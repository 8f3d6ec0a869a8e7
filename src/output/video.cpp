// SPDX-License-Identifier: MIT
#include "output/video.hpp"

#include "base/atomic_file.hpp"
#include "base/run_program.hpp"

#include <frostfill/error.hpp>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <tuple>
#include <utility>
#include <vector>

namespace frostfill
{
namespace
{

/// The arguments for good quality with flat colours and thin lines, by extension.
std::vector<std::string> encoderArguments(const std::string& ending, bool withAlpha)
{
    if (ending == ".mp4")
    {
        // Players expect 4:2:0, which needs even sides.
        return {"-c:v",     "libx264", "-preset",   "medium",
                "-crf",     "18",      "-vf",       "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white",
                "-pix_fmt", "yuv420p", "-movflags", "+faststart"};
    }
    if (ending == ".webm")
    {
        return {"-c:v",      "libvpx-vp9",
                "-crf",      "24",
                "-b:v",      "0",
                "-row-mt",   "1",
                "-deadline", "good",
                "-cpu-used", "4",
                "-pix_fmt",  withAlpha ? "yuva420p" : "yuv420p"};
    }
    return {"-c:v", "ffv1", "-level", "3"}; // for other programs, and of which a GIF is made
}

/// GIF: one palette for the whole video, which has to be known first, so that only what changes
/// is stored. Fifteen frames a second are smooth enough, and half the size.
constexpr double kMaxGifFrames = 15;

std::string complaintOf(const std::string& said)
{
    return said.empty() ? "ffmpeg ended early" : "ffmpeg says: " + said;
}

bool isGif(const std::filesystem::path& file)
{
    return file.extension() == ".gif";
}

bool isStandardOutput(const std::filesystem::path& file)
{
    return file == "-";
}

/// Throws Error usage for a video that cannot be made.
void requireKnown(const std::filesystem::path& file)
{
    const std::string ending = file.extension().string();
    if (!isStandardOutput(file) && ending != ".mp4" && ending != ".webm" && !isGif(file))
    {
        throw Error(ErrorCode::usage,
                    fmt::format("the video {} must end in .mp4, .webm or .gif, or be - for "
                                "standard output",
                                file.string()));
    }
    if (isStandardOutput(file) && ::isatty(STDOUT_FILENO) == 1)
    {
        throw Error(ErrorCode::usage, "a video cannot be shown on a terminal: pipe standard output "
                                      "to a program, or name a file in place of -");
    }
}

} // namespace

Video::Video(std::filesystem::path file, double framesPerSecond)
    : file_(std::move(file)), framesPerSecond_(framesPerSecond)
{
    requireKnown(file_);
    if (runProgram(".", {"ffmpeg", "-version"}).error != 0)
    {
        throw Error(
            ErrorCode::cannotCreate,
            fmt::format("cannot make the video {}: ffmpeg is not installed; apt install ffmpeg, "
                        "or omit --video",
                        file_.string()));
    }
    said_ = ::memfd_create("ffmpeg", MFD_CLOEXEC);
    create();
}

void Video::create()
{
    int created = -1;
    if (isStandardOutput(file_))
    {
        created = output_ = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
        ::dup2(STDERR_FILENO, STDOUT_FILENO);
    }
    else
    {
        raw_ = part_ = file_;
        // The ending tells ffmpeg the format.
        part_.replace_extension(".part" + file_.extension().string());
        raw_.replace_extension(".part.mkv");
        ::unlink(part_.c_str());
        created = createNewFile(part_);
        std::ignore = closeFile(created);
    }
    if (created < 0 || said_ < 0)
    {
        ::close(said_);
        throw Error(ErrorCode::cannotCreate,
                    fmt::format("cannot create {}: {}", file_.string(), std::strerror(errno)));
    }
}

Video::~Video()
{
    if (process_ > 0)
    {
        ::kill(process_, SIGKILL);
        close();
    }
    ::close(said_);
    ::close(output_);
    ::unlink(part_.c_str());
    ::unlink(raw_.c_str());
}

void Video::start(const Image& image)
{
    // Unlike a pipe, a socket can suppress SIGPIPE when ffmpeg has died.
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    {
        failed_ = true;
        return;
    }
    const bool withAlpha = image.channels == 4;
    std::vector<std::string> words = {"ffmpeg",
                                      "-hide_banner",
                                      "-loglevel",
                                      "error",
                                      "-y",
                                      "-f",
                                      "rawvideo",
                                      "-pix_fmt",
                                      withAlpha ? "rgba" : "rgb24",
                                      "-s",
                                      fmt::format("{}x{}", image.width, image.height),
                                      "-r",
                                      fmt::format("{}", framesPerSecond_),
                                      "-i",
                                      "-"};
    for (std::string& word : encoderArguments(file_.extension().string(), withAlpha))
    {
        words.push_back(std::move(word));
    }
    if (output_ >= 0)
    {
        words.insert(words.end(), {"-f", "matroska", "pipe:1"});
    }
    else // a name that starts with a dash or contains a colon is still a file name
    {
        words.push_back("file:" + (isGif(file_) ? raw_ : part_).string());
    }
    const StartedProgram started = startProgram(".", std::move(words), {ends[1], output_, said_});
    ::close(ends[1]);
    socket_ = ends[0];
    process_ = started.id;
    failed_ = started.error != 0;
}

void Video::send(const Image& image)
{
    const std::uint8_t* next = image.pixels.data();
    std::size_t left = image.pixels.size();
    while (left > 0)
    {
        const ssize_t sent = ::send(socket_, next, left, MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR)
        {
            continue;
        }
        if (sent <= 0)
        {
            failed_ = true;
            return;
        }
        next += sent;
        left -= static_cast<std::size_t>(sent);
    }
}

void Video::put(std::size_t /*number*/, const Image& image)
{
    if (frames_++ == 0)
    {
        start(image);
    }
    if (!failed_)
    {
        send(image);
    }
}

int Video::close()
{
    if (socket_ >= 0)
    {
        ::close(std::exchange(socket_, -1));
    }
    return process_ > 0 ? exitCodeOf(waitFor(std::exchange(process_, -1))) : -1;
}

std::string Video::complaint() const
{
    std::string all(static_cast<std::size_t>(std::max<off_t>(::lseek(said_, 0, SEEK_END), 0)), 0);
    std::ignore = ::pread(said_, all.data(), all.size(), 0);
    all.erase(all.find_last_not_of('\n') + 1);
    return complaintOf(all.substr(all.rfind('\n') + 1));
}

std::optional<std::string> Video::makeGif() const
{
    const std::string raw = "file:" + std::filesystem::absolute(raw_).string();
    const std::string part = "file:" + std::filesystem::absolute(part_).string();
    const std::string filter =
        fmt::format("[0:v]fps={0},palettegen=stats_mode=full[p];[1:v]fps={0}[v];"
                    "[v][p]paletteuse=dither=none:diff_mode=rectangle",
                    std::min(framesPerSecond_, kMaxGifFrames));
    const ProgramRun run = runProgram(".", {"ffmpeg", "-hide_banner", "-loglevel", "error", "-y",
                                            "-i", raw, "-i", raw, "-filter_complex", filter, part});
    if (run.error == 0 && run.code == 0)
    {
        return std::nullopt;
    }
    return complaintOf(run.said);
}

void Video::finish()
{
    if (frames_ == 0)
    {
        return;
    }
    std::error_code problem;
    const bool encoded = close() == 0 && !failed_;
    std::optional<std::string> failure = encoded ? std::nullopt : std::optional(complaint());
    if (encoded && isGif(file_))
    {
        failure = makeGif();
    }
    const bool worked = !failure;
    if (worked && output_ < 0)
    {
        std::filesystem::rename(part_, file_, problem);
    }
    if (!worked || problem)
    {
        throw Error(ErrorCode::writeFailed,
                    fmt::format("the video {} is missing: {}", file_.string(),
                                worked ? problem.message() : *failure));
    }
}

} // namespace frostfill
