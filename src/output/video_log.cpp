// SPDX-License-Identifier: MIT
#include "output/video_log.hpp"

#include "base/atomic_file.hpp"

#include <frostfill/error.hpp>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string_view>
#include <tuple>

namespace frostfill
{
namespace
{

constexpr const char* kRaw = ".raw.mkv";

/// The first line, by which a log is known as ours.
constexpr std::string_view kSign = "Frostfill makes a video\n";

std::filesystem::path withProcess(std::filesystem::path video, const std::string& process,
                                  const std::string& ending)
{
    return video.replace_extension(process + ending);
}

/// The process in "film.1234.log"; empty for any other name.
std::string processOf(const std::string& name, const std::string& stem)
{
    constexpr std::string_view kEnding = ".log";
    if (!name.starts_with(stem + ".") || !name.ends_with(kEnding) ||
        name.size() <= stem.size() + 1 + kEnding.size())
    {
        return {};
    }
    const std::string process =
        name.substr(stem.size() + 1, name.size() - stem.size() - 1 - kEnding.size());
    const bool digits = std::all_of(process.begin(), process.end(),
                                    [](unsigned char c) { return std::isdigit(c) != 0; });
    return digits ? process : std::string();
}

/// Whether the file begins with our sign, and no process holds its lock.
bool isForsaken(const std::filesystem::path& log)
{
    const int descriptor = ::open(log.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0)
    {
        return false;
    }
    std::string head(kSign.size(), '\0');
    const bool ours =
        ::pread(descriptor, head.data(), head.size(), 0) == static_cast<ssize_t>(head.size()) &&
        head == kSign;
    const bool free = ours && ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
    std::ignore = closeFile(descriptor);
    return free;
}

void clearForsaken(const std::filesystem::path& video)
{
    const auto folder = video.parent_path().empty() ? "." : video.parent_path();
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    {
        const std::string process =
            processOf(entry.path().filename().string(), video.stem().string());
        if (!process.empty() && isForsaken(entry.path()))
        {
            ::unlink(withProcess(video, process, ".part" + video.extension().string()).c_str());
            ::unlink(withProcess(video, process, kRaw).c_str());
            ::unlink(entry.path().c_str());
        }
    }
}

} // namespace

VideoLog::VideoLog(const std::filesystem::path& video)
{
    clearForsaken(video);
    // The process number separates two runs; the ending tells ffmpeg the format.
    const std::string process = fmt::format("{}", ::getpid());
    log_ = withProcess(video, process, ".log");
    part_ = withProcess(video, process, ".part" + video.extension().string());
    raw_ = withProcess(video, process, kRaw);
    ::unlink(log_.c_str());
    descriptor_ = createNewFile(log_);
    const bool signedIt =
        descriptor_ >= 0 &&
        writeAll(descriptor_,
                 {reinterpret_cast<const std::uint8_t*>(kSign.data()), kSign.size()}) == 0;
    if (!signedIt)
    {
        const int reason = errno;
        if (descriptor_ >= 0)
        {
            std::ignore = closeFile(descriptor_);
            ::unlink(log_.c_str());
        }
        throw Error(ErrorCode::cannotCreate,
                    fmt::format("cannot create {}: {}", video.string(), std::strerror(reason)));
    }
    std::ignore = ::flock(descriptor_, LOCK_EX | LOCK_NB); // where the file system knows locks
}

VideoLog::~VideoLog()
{
    ::unlink(part_.c_str());
    ::unlink(raw_.c_str());
    ::unlink(log_.c_str());
    std::ignore = closeFile(descriptor_);
}

std::string VideoLog::lastLine() const
{
    std::ifstream in(log_);
    std::string line;
    std::getline(in, line); // the sign
    std::string last;
    while (std::getline(in, line))
    {
        last = line.empty() ? last : line;
    }
    return last;
}

} // namespace frostfill
