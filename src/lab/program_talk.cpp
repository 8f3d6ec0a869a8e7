// SPDX-License-Identifier: MIT
#include "lab/program_talk.hpp"

#include "lab/processor_time.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <thread>
#include <utility>

namespace frostfill
{
namespace
{

using namespace std::chrono_literals;

constexpr std::size_t kSendAt = std::size_t(1) << 16;   // [byte]
constexpr std::size_t kMostSaid = std::size_t(1) << 16; // that is no line, or not asked for [byte]
constexpr off_t kMostErrors = 400;                      // told of standard error [byte]
constexpr auto kTimeToEnd = 1s;
constexpr auto kTimeToComplain = 100ms; // of one that says what is wrong, and may go on

/// A file by its path; what is no file is looked for in PATH.
std::string findProgram(const std::string& program)
{
    std::error_code ignored;
    return std::filesystem::is_regular_file(program, ignored)
               ? std::filesystem::absolute(program).string()
               : program;
}

} // namespace

ProgramTalk::ProgramTalk(const std::string& program, double seconds)
    : error_(output_.error()), errors_(memfd_create("errors", MFD_CLOEXEC)), patience_(seconds),
      deadline_(Clock::now() +
                std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds)))
{
    std::array<int, 2> input = {-1, -1}; // a socket: a reader that has gone is an error, no signal
    if (error_ == 0 &&
        (errors_ < 0 || socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, input.data()) != 0))
    {
        error_ = errno;
    }
    if (error_ != 0)
    {
        return;
    }
    input_ = input[0];
    const StartedProgram started =
        startProgram(".", {findProgram(program)},
                     {.input = input[1], .output = output_.writing(), .errors = errors_}, true);
    error_ = started.error;
    id_ = started.id;
    close(input[1]);
    output_.closeWriting();
}

ProgramTalk::~ProgramTalk()
{
    reap();
    closeInput();
    if (errors_ >= 0)
    {
        close(errors_);
    }
}

void ProgramTalk::say(std::string_view text)
{
    outgoing_ += text;
    if (outgoing_.size() >= kSendAt)
    {
        sendAll();
    }
}

std::optional<std::string> ProgramTalk::hear()
{
    sendAll();
    for (;;)
    {
        if (const std::size_t end = said_.find('\n', heard_); end != std::string::npos)
        {
            std::string line = said_.substr(heard_, end - heard_);
            heard_ = end + 1;
            return line;
        }
        if (!canHear())
        {
            return std::nullopt;
        }
        said_.erase(0, std::exchange(heard_, 0));
        exchange();
    }
}

void ProgramTalk::end()
{
    sendAll();
    closeInput();
    static_cast<void>(endsWithin(kTimeToEnd));
    reap();
}

double ProgramTalk::seconds() const
{
    clockid_t clock = 0;
    timespec time{};
    if (id_ < 0 || clock_getcpuclockid(id_, &clock) != 0 || clock_gettime(clock, &time) != 0)
    {
        return usedSeconds_;
    }
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

std::string ProgramTalk::ending()
{
    const bool ended = endsWithin(output_.reading() < 0 ? kTimeToEnd : kTimeToComplain);
    reap();
    if (late_)
    {
        return fmt::format("has not answered within {:g} s", patience_);
    }
    if (output_.reading() >= 0)
    {
        return "says more than it was asked for";
    }
    if (!ended)
    {
        return "has closed its output";
    }
    const int code = exitCodeOf(status_);
    return code > 128 ? fmt::format("was ended by signal {}", code - 128)
                      : fmt::format("ended with code {}", code);
}

/// Nothing is waited for any more when it has closed its output, says what nobody has asked for, or
/// takes too long.
bool ProgramTalk::canHear() const
{
    return output_.reading() >= 0 && said_.size() - heard_ <= kMostSaid && !late_;
}

void ProgramTalk::sendAll()
{
    while (!outgoing_.empty() && input_ >= 0 && canHear())
    {
        exchange();
    }
    outgoing_.clear();
}

/// Waits until the program takes or gives something, and lets it.
void ProgramTalk::exchange()
{
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline_ - Clock::now());
    late_ = left.count() <= 0;
    std::array<pollfd, 2> ends = {
        {{outgoing_.empty() ? -1 : input_, POLLOUT, 0}, {output_.reading(), POLLIN, 0}}};
    constexpr std::chrono::milliseconds kLongest = 1h;
    if (late_ ||
        poll(ends.data(), ends.size(), static_cast<int>(std::min(left, kLongest).count())) <= 0)
    {
        return;
    }
    if (ends[0].revents != 0)
    {
        write();
    }
    if (ends[1].revents != 0)
    {
        read();
    }
}

void ProgramTalk::write()
{
    const ssize_t size =
        send(input_, outgoing_.data(), outgoing_.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (size >= 0)
    {
        outgoing_.erase(0, static_cast<std::size_t>(size));
    }
    else if (errno != EAGAIN && errno != EINTR)
    {
        closeInput();
    }
}

void ProgramTalk::read()
{
    std::array<char, kMostSaid> buffer;
    const ssize_t size = ::read(output_.reading(), buffer.data(), buffer.size());
    if (size > 0)
    {
        said_.append(buffer.data(), static_cast<std::size_t>(size));
    }
    else if (size == 0 || errno != EINTR)
    {
        output_.closeReading();
    }
}

void ProgramTalk::closeInput()
{
    if (input_ >= 0)
    {
        close(std::exchange(input_, -1));
    }
}

std::string ProgramTalk::errors() const
{
    const off_t size = lseek(errors_, 0, SEEK_END);
    const off_t first = std::max<off_t>(0, size - kMostErrors);
    std::string last(static_cast<std::size_t>(std::max<off_t>(0, size - first)), '\0');
    const ssize_t found = pread(errors_, last.data(), last.size(), first);
    last.resize(static_cast<std::size_t>(std::max<ssize_t>(0, found)));
    return last;
}

bool ProgramTalk::endsWithin(Clock::duration time) const
{
    const auto last = Clock::now() + time;
    for (;;)
    {
        siginfo_t info{};
        if (id_ < 0 || late_ ||
            waitid(P_PID, static_cast<id_t>(id_), &info, WEXITED | WNOHANG | WNOWAIT) != 0)
        {
            return false;
        }
        if (info.si_pid != 0 || Clock::now() > last)
        {
            return info.si_pid != 0;
        }
        std::this_thread::sleep_for(1ms);
    }
}

void ProgramTalk::reap()
{
    if (id_ < 0)
    {
        return;
    }
    kill(-id_, SIGKILL);
    rusage usage{};
    while (wait4(id_, &status_, 0, &usage) < 0 && errno == EINTR)
    {
    }
    usedSeconds_ = processorSeconds(usage);
    id_ = -1;
}

} // namespace frostfill
