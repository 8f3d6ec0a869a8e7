// SPDX-License-Identifier: MIT
#include "base/run_program.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <tuple>
#include <utility>

namespace frostfill
{
namespace
{

bool giveStream(int stream, int given, int nothing)
{
    return dup2(given >= 0 ? given : nothing, stream) >= 0;
}

/// In the child: becomes the program, or tells the parent why not.
[[noreturn]] void become(const std::filesystem::path& folder, char* const* arguments,
                         const ProgramStreams& streams, bool leads, int failure)
{
    // A parent that is killed takes the program with it.
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGPIPE})
    {
        std::signal(signal, SIG_DFL);
    }
    const int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
    if (nothing >= 0 && (!leads || setpgid(0, 0) == 0) &&
        giveStream(STDIN_FILENO, streams.input, nothing) &&
        giveStream(STDOUT_FILENO, streams.output, nothing) &&
        giveStream(STDERR_FILENO, streams.errors, nothing) && chdir(folder.c_str()) == 0)
    {
        execvp(arguments[0], arguments);
    }
    const int error = errno;
    std::ignore = write(failure, &error, sizeof error);
    _exit(127);
}

void closeEnd(int& end)
{
    if (end >= 0)
    {
        close(std::exchange(end, -1));
    }
}

} // namespace

Pipe::Pipe() : error_(pipe2(ends_.data(), O_CLOEXEC) == 0 ? 0 : errno)
{
}

Pipe::~Pipe()
{
    closeReading();
    closeWriting();
}

void Pipe::closeReading()
{
    closeEnd(ends_[0]);
}

void Pipe::closeWriting()
{
    closeEnd(ends_[1]);
}

StartedProgram startProgram(const std::filesystem::path& folder, std::vector<std::string> arguments,
                            const ProgramStreams& streams, bool leads)
{
    std::vector<char*> raw;
    raw.reserve(arguments.size() + 1);
    for (std::string& argument : arguments)
    {
        raw.push_back(argument.data());
    }
    raw.push_back(nullptr);

    StartedProgram started;
    Pipe failure;
    if (failure.error() != 0)
    {
        started.error = failure.error();
        return started;
    }
    started.id = fork();
    if (started.id == 0)
    {
        become(folder, raw.data(), streams, leads, failure.writing());
    }
    if (started.id < 0)
    {
        started.error = errno;
        return started;
    }
    // It is closed when the child has become the program.
    failure.closeWriting();
    ssize_t size = 0;
    do
    {
        size = read(failure.reading(), &started.error, sizeof started.error);
    } while (size < 0 && errno == EINTR);
    if (size > 0)
    {
        waitFor(std::exchange(started.id, -1));
    }
    return started;
}

int waitFor(pid_t id)
{
    int status = 0;
    while (waitpid(id, &status, 0) < 0 && errno == EINTR)
    {
    }
    return status;
}

int exitCodeOf(int status)
{
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

namespace
{

/// All that comes through a pipe until its other end is closed.
std::string readAll(int pipe)
{
    std::string said;
    std::array<char, 4096> buffer{};
    for (;;)
    {
        const ssize_t size = read(pipe, buffer.data(), buffer.size());
        if (size > 0)
        {
            said.append(buffer.data(), static_cast<std::size_t>(size));
        }
        else if (size == 0 || errno != EINTR)
        {
            return said;
        }
    }
}

} // namespace

ProgramRun runProgram(const std::filesystem::path& folder, std::vector<std::string> arguments)
{
    ProgramRun ran;
    Pipe output;
    ran.error = output.error();
    if (ran.error != 0)
    {
        return ran;
    }
    const StartedProgram program =
        startProgram(folder, std::move(arguments),
                     {.input = -1, .output = output.writing(), .errors = output.writing()});
    ran.error = program.error;
    if (ran.error != 0)
    {
        ran.code = 127; // that of a shell
        return ran;
    }
    output.closeWriting();
    ran.said = readAll(output.reading());
    ran.code = exitCodeOf(waitFor(program.id));
    return ran;
}

} // namespace frostfill
