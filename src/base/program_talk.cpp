// SPDX-License-Identifier: MIT
#include "base/program_talk.hpp"

#include "base/timers.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
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
constexpr std::size_t kMostErrors = 400;                // kept of standard error [byte]
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

/// As `write`, but a reader that has gone is an error and no signal.
ssize_t writeWithoutSignal(int pipe, const std::string& bytes)
{
    sigset_t brokenPipe;
    sigset_t before;
    sigset_t waiting;
    sigemptyset(&brokenPipe);
    sigaddset(&brokenPipe, SIGPIPE);
    sigpending(&waiting);
    pthread_sigmask(SIG_BLOCK, &brokenPipe, &before);
    const ssize_t size = ::write(pipe, bytes.data(), bytes.size());
    const int error = errno;
    if (size < 0 && error == EPIPE && sigismember(&waiting, SIGPIPE) == 0)
    {
        const timespec now{};
        sigtimedwait(&brokenPipe, nullptr, &now);
    }
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    errno = error;
    return size;
}

} // namespace

ProgramTalk::ProgramTalk(const std::string& program, double seconds)
    : error_(std::max({input_.error(), output_.error(), errors_.error()})), patience_(seconds),
      deadline_(Clock::now() +
                std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds)))
{
    if (error_ != 0)
    {
        return;
    }
    const StartedProgram started = startProgram(
        ".", {findProgram(program)},
        {.input = input_.reading(), .output = output_.writing(), .errors = errors_.writing()},
        true);
    error_ = started.error;
    id_ = started.id;
    input_.closeReading();
    output_.closeWriting();
    errors_.closeWriting();
    for (const int end : {input_.writing(), output_.reading(), errors_.reading()})
    {
        fcntl(end, F_SETFL, O_NONBLOCK);
    }
}

ProgramTalk::~ProgramTalk()
{
    reap();
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
    input_.closeWriting();
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
    while (errors_.reading() >= 0 && read(errors_, lastErrors_))
    {
    }
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
    while (!outgoing_.empty() && input_.writing() >= 0 && canHear())
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
    std::array<pollfd, 3> ends = {{{outgoing_.empty() ? -1 : input_.writing(), POLLOUT, 0},
                                   {output_.reading(), POLLIN, 0},
                                   {errors_.reading(), POLLIN, 0}}};
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
        read(output_, said_);
    }
    if (ends[2].revents != 0)
    {
        read(errors_, lastErrors_);
        lastErrors_.erase(0, lastErrors_.size() - std::min(lastErrors_.size(), kMostErrors));
    }
}

void ProgramTalk::write()
{
    const ssize_t size = writeWithoutSignal(input_.writing(), outgoing_);
    if (size >= 0)
    {
        outgoing_.erase(0, static_cast<std::size_t>(size));
    }
    else if (errno != EAGAIN && errno != EINTR)
    {
        input_.closeWriting();
    }
}

/// Whether there was something.
bool ProgramTalk::read(Pipe& pipe, std::string& text)
{
    std::array<char, kMostSaid> buffer;
    const ssize_t size = ::read(pipe.reading(), buffer.data(), buffer.size());
    if (size > 0)
    {
        text.append(buffer.data(), static_cast<std::size_t>(size));
    }
    else if (size == 0 || (errno != EAGAIN && errno != EINTR))
    {
        pipe.closeReading();
    }
    return size > 0;
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
