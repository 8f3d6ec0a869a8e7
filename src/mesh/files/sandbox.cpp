// SPDX-License-Identifier: MIT
#include "mesh/files/sandbox.hpp"

#include "base/posix_file.hpp"
#include "base/sanitized.hpp"

#include <frostfill/error.hpp>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <new>
#include <string_view>

namespace frostfill
{
namespace
{

/// The child's end of the pipe; it has no other file open above it.
constexpr int kReport = 3;
constexpr rlim_t kMaxFiles = 16;
/// A child that sleeps uses no processor time: it is killed after its limit times this. [1]
constexpr unsigned kWaitFactor = 10;

// The first byte of what the child reports.
constexpr char kDone = 'D';        // then the bytes
constexpr char kRefused = 'E';     // then the error's code in one byte, and its sentence
constexpr char kOutOfMemory = 'M'; // nothing more

// Sanitizers map terabytes of shadow, which no limit on addresses could leave room for.
#ifdef FROSTFILL_SANITIZED
constexpr bool kLimitsAddresses = false;
#else
constexpr bool kLimitsAddresses = true;
#endif

/// Address space that this process has now. [byte]
std::size_t addressSpace()
{
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

void limit(int what, rlim_t value)
{
    rlimit now = {};
    getrlimit(static_cast<__rlimit_resource>(what), &now);
    // A limit that is stricter already stays.
    now.rlim_max = now.rlim_max == RLIM_INFINITY ? value : std::min(now.rlim_max, value);
    now.rlim_cur = now.rlim_max;
    setrlimit(static_cast<__rlimit_resource>(what), &now);
}

void enterSandbox(const SandboxLimits& limits)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGPIPE, SIGXCPU})
    {
        std::signal(signal, SIG_DFL);
    }
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, 0);
    limit(RLIMIT_NOFILE, kMaxFiles);
    limit(RLIMIT_CPU, limits.seconds);
    if (kLimitsAddresses)
    {
        limit(RLIMIT_AS, addressSpace() + limits.bytes);
    }
}

void report(std::string_view bytes)
{
    const int failure =
        writeAll(kReport, {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
    if (failure != 0)
    {
        _exit(1);
    }
}

[[noreturn]] void runAsChild(const SandboxLimits& limits, int pipe,
                             const std::function<std::string()>& work)
{
    dup2(pipe, kReport);
    close_range(kReport + 1, ~0U, 0);
    if (kLimitsAddresses)
    {
        // What the reader prints is of no use; what a sanitizer prints is.
        dup2(open("/dev/null", O_WRONLY | O_CLOEXEC), STDERR_FILENO);
    }
    enterSandbox(limits);
    try
    {
        const std::string bytes = work();
        report({&kDone, 1});
        report(bytes);
    }
    catch (const Error& error)
    {
        const std::array<char, 2> head = {kRefused, static_cast<char>(error.code())};
        report({head.data(), head.size()});
        report(error.what());
    }
    catch (const std::bad_alloc&)
    {
        report({&kOutOfMemory, 1});
    }
    // Nothing of the parent's is to be flushed or destroyed twice.
    _exit(0);
}

/// A child process and the pipe on which it reports. Ends with it, by force if need be.
class Child
{
public:
    Child(const SandboxLimits& limits, const std::function<std::string()>& work)
    {
        std::array<int, 2> ends{};
        if (pipe2(ends.data(), O_CLOEXEC) != 0)
        {
            refuse("no pipe is available");
        }
        id_ = fork();
        if (id_ == 0)
        {
            runAsChild(limits, ends[1], work);
        }
        close(ends[1]);
        pipe_ = ends[0];
        if (id_ < 0)
        {
            close(pipe_);
            refuse("no process is available");
        }
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child()
    {
        close(pipe_);
        if (id_ > 0)
        {
            kill(id_, SIGKILL);
            std::ignore = wait();
        }
    }

    /// All that it reports, or nothing more after a while or too many bytes.
    [[nodiscard]] std::string listen(std::chrono::seconds atMost, std::size_t mostBytes)
    {
        const auto end = std::chrono::steady_clock::now() + atMost;
        std::string bytes;
        std::array<char, 1 << 16> some{};
        while (bytes.size() <= mostBytes && hasMore(end))
        {
            const ssize_t count = read(pipe_, some.data(), some.size());
            if (count > 0)
            {
                bytes.append(some.data(), static_cast<std::size_t>(count));
            }
            else if (count == 0 || errno != EINTR)
            {
                return bytes;
            }
        }
        kill(id_, SIGKILL);
        return {};
    }

    /// How it ended, as waitpid tells it.
    [[nodiscard]] int wait()
    {
        int status = 0;
        while (waitpid(id_, &status, 0) < 0 && errno == EINTR)
        {
        }
        id_ = -1;
        return status;
    }

private:
    [[noreturn]] static void refuse(const char* why)
    {
        throw Error(
            ErrorCode::outOfMemory,
            fmt::format("{} for reading a mesh in a child process: {}", why, std::strerror(errno)));
    }

    [[nodiscard]] bool hasMore(std::chrono::steady_clock::time_point end) const
    {
        while (true)
        {
            const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
                end - std::chrono::steady_clock::now());
            if (left.count() <= 0)
            {
                return false;
            }
            pollfd pipe = {pipe_, POLLIN, 0};
            const int ready = poll(&pipe, 1, static_cast<int>(left.count()) + 1);
            if (ready > 0 || (ready < 0 && errno != EINTR))
            {
                return true;
            }
        }
    }

    int pipe_ = -1;
    pid_t id_ = -1;
};

std::string describeExit(int status, const SandboxLimits& limits)
{
    const std::string anew = "export the mesh again, in another format if need be";
    if (!WIFSIGNALED(status))
    {
        return fmt::format("the reader gave up on it; {}", anew);
    }
    const int signal = WTERMSIG(status);
    if (signal == SIGXCPU || signal == SIGKILL)
    {
        return fmt::format("it takes more than {} s of processor time; {}", limits.seconds, anew);
    }
    return fmt::format("the reader crashed on it ({}); the file is damaged: {}",
                       sigdescr_np(signal), anew);
}

} // namespace

std::string runSandboxed(const SandboxLimits& limits, const std::string& subject,
                         const std::function<std::string()>& work)
{
    Child child(limits, work);
    std::string bytes =
        child.listen(std::chrono::seconds(kWaitFactor * limits.seconds), limits.bytes);
    const int status = child.wait();
    const char kind = bytes.empty() ? '\0' : bytes[0];
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || kind == '\0')
    {
        throw Error(ErrorCode::badData,
                    fmt::format("{}: {}", subject, describeExit(status, limits)));
    }
    if (kind == kRefused)
    {
        throw Error(static_cast<ErrorCode>(static_cast<unsigned char>(bytes.at(1))),
                    bytes.substr(2));
    }
    if (kind == kOutOfMemory)
    {
        throw Error(ErrorCode::badData, fmt::format("{}: it needs more than {} MB of memory",
                                                    subject, limits.bytes >> 20));
    }
    return bytes.substr(1);
}

} // namespace frostfill
