// SPDX-License-Identifier: MIT
#include "base/run_program.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <tuple>

namespace frostfill
{
namespace
{

/// In the child: becomes the program, or tells the parent why not.
[[noreturn]] void become(const std::filesystem::path& folder, char* const* arguments, int output,
                         int failure)
{
    // A parent that is killed takes the program with it.
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGPIPE})
    {
        std::signal(signal, SIG_DFL);
    }
    const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
    if (nothing >= 0 && dup2(nothing, STDIN_FILENO) >= 0 && dup2(output, STDOUT_FILENO) >= 0 &&
        dup2(output, STDERR_FILENO) >= 0 && chdir(folder.c_str()) == 0)
    {
        execvp(arguments[0], arguments);
    }
    const int error = errno;
    std::ignore = write(failure, &error, sizeof error);
    _exit(127);
}

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

/// Both ends of a pipe, which a program that is started does not inherit.
class Pipe
{
public:
    Pipe() : error_(pipe2(ends_.data(), O_CLOEXEC) == 0 ? 0 : errno) {}
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    ~Pipe()
    {
        close(ends_[0]);
        closeWriting();
    }
    void closeWriting()
    {
        close(ends_[1]);
        ends_[1] = -1;
    }
    [[nodiscard]] int error() const { return error_; }
    [[nodiscard]] int reading() const { return ends_[0]; }
    [[nodiscard]] int writing() const { return ends_[1]; }

private:
    std::array<int, 2> ends_ = {-1, -1};
    int error_;
};

} // namespace

ProgramRun runProgram(const std::filesystem::path& folder, std::vector<std::string> arguments)
{
    std::vector<char*> raw;
    for (std::string& argument : arguments)
    {
        raw.push_back(argument.data());
    }
    raw.push_back(nullptr);

    ProgramRun ran;
    Pipe output;
    Pipe failure;
    if (output.error() != 0 || failure.error() != 0)
    {
        ran.error = output.error() != 0 ? output.error() : failure.error();
        return ran;
    }
    const pid_t child = fork();
    if (child == 0)
    {
        become(folder, raw.data(), output.writing(), failure.writing());
    }
    if (child < 0)
    {
        ran.error = errno;
        return ran;
    }
    output.closeWriting();
    failure.closeWriting();
    if (const std::string why = readAll(failure.reading()); why.size() == sizeof ran.error)
    {
        std::memcpy(&ran.error, why.data(), sizeof ran.error);
    }
    ran.said = readAll(output.reading());
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR)
    {
    }
    ran.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return ran;
}

} // namespace frostfill
