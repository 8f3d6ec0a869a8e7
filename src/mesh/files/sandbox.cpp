// SPDX-License-Identifier: MIT
#include "mesh/files/sandbox.hpp"

#include "base/atomic_file.hpp"
#include "base/resources.hpp"

#include <frostfill/error.hpp>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <new>
#include <string_view>
#include <system_error>
#include <utility>

namespace frostfill
{
namespace
{

/// The child's end of the pipe; it has no other file open above it.
constexpr int kReport = 3;
constexpr rlim_t kMaxFiles = 16;
/// A child that sleeps uses no processor time: it is killed after its limit times this. [1]
constexpr unsigned kWaitFactor = 10;

/// What the pipe holds, if the system allows that. [byte] Smaller: parent and child wait for each
/// other more often. Larger: more than the processor's cache keeps.
constexpr int kPipe = 1 << 20;

// How the report of the child begins.
struct Head
{
    char kind = '\0';
    unsigned char code = 0; ///< of an error
    std::uint64_t size = 0; ///< of what follows [byte]
};
constexpr char kDone = 'D';        // the bytes follow
constexpr char kRefused = 'E';     // the error's sentence follows
constexpr char kOutOfMemory = 'M'; // nothing follows

// Sanitizers map terabytes of shadow, which no limit on addresses could leave room for.
#ifdef FROSTFILL_SANITIZED
constexpr bool kLimitsAddresses = false;
#else
constexpr bool kLimitsAddresses = true;
#endif

/// Whether this process has no other thread. The child of one that has may hang: a lock that
/// another thread held at the fork stays locked there.
bool hasOneThread()
{
    std::error_code ignored;
    const std::filesystem::directory_iterator threads("/proc/self/task", ignored);
    return std::distance(begin(threads), end(threads)) == 1;
}

/// Address space that this process has now. [byte]
std::size_t addressSpace()
{
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

/// Lowers a limit. One that is stricter already stays.
void limit(__rlimit_resource what, rlim_t soft, rlim_t hard)
{
    rlimit now = {};
    getrlimit(what, &now);
    now = {std::min(now.rlim_cur, soft), std::min(now.rlim_max, hard)};
    setrlimit(what, &now);
}

/// With the limits of this process where these are stricter: they hold in its children too.
SandboxLimits bounded(SandboxLimits limits)
{
    rlimit time = {};
    rlimit addresses = {};
    getrlimit(RLIMIT_CPU, &time);
    getrlimit(RLIMIT_AS, &addresses);
    limits.seconds = static_cast<unsigned>(std::min<rlim_t>(time.rlim_cur, limits.seconds));
    const rlim_t left = addresses.rlim_cur - std::min<rlim_t>(addresses.rlim_cur, addressSpace());
    limits.bytes = std::min<rlim_t>(left, limits.bytes);
    return limits;
}

void enterSandbox(const SandboxLimits& limits)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGPIPE, SIGXCPU})
    {
        std::signal(signal, SIG_DFL);
    }
    limit(RLIMIT_CORE, 0, 0);
    limit(RLIMIT_FSIZE, 0, 0);
    limit(RLIMIT_NOFILE, kMaxFiles, kMaxFiles);
    limit(RLIMIT_CPU, limits.seconds, limits.seconds + 1); // at the hard one there is no SIGXCPU
    if (kLimitsAddresses)
    {
        const rlim_t addresses = addressSpace() + limits.bytes;
        limit(RLIMIT_AS, addresses, addresses);
    }
}

void report(char kind, unsigned char code, const SandboxReport& parts)
{
    Head head{kind, code, 0};
    for (const std::string_view part : parts)
    {
        head.size += part.size();
    }
    const auto send = [](const void* bytes, std::size_t size)
    {
        if (writeAll(kReport, {static_cast<const std::uint8_t*>(bytes), size}) != 0)
        {
            _exit(1);
        }
    };
    send(&head, sizeof head);
    for (const std::string_view part : parts)
    {
        send(part.data(), part.size());
    }
}

[[noreturn]] void runAsChild(const SandboxLimits& limits, int pipe,
                             const std::function<SandboxReport()>& work)
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
        report(kDone, 0, work());
    }
    catch (const Error& error)
    {
        report(kRefused, static_cast<unsigned char>(error.code()), {error.what()});
    }
    catch (const std::bad_alloc&)
    {
        report(kOutOfMemory, 0, {});
    }
    // Nothing of the parent's is to be flushed or destroyed twice.
    _exit(0);
}

/// A child process and the pipe on which it reports. Ends with it, by force if need be.
class Child
{
public:
    Child(const SandboxLimits& limits, const std::function<SandboxReport()>& work)
    {
        std::array<int, 2> ends{};
        if (pipe2(ends.data(), O_CLOEXEC) != 0)
        {
            refuse("no pipe is available");
        }
        fcntl(ends[0], F_SETPIPE_SZ, kPipe);
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

    /// What it reports. Without a kind if that is less than it announces, or if it had to be
    /// ended: see end().
    [[nodiscard]] std::pair<Head, SandboxedBytes> listen(std::chrono::seconds atMost,
                                                         std::size_t mostBytes)
    {
        const auto end = std::chrono::steady_clock::now() + atMost;
        Head head;
        SandboxedBytes bytes;
        if (!receive(reinterpret_cast<char*>(&head), sizeof head, end))
        {
            return {};
        }
        if (head.size > mostBytes)
        {
            end_ = End::tooLarge;
            kill(id_, SIGKILL);
            return {};
        }
        bytes = {std::make_unique_for_overwrite<char[]>(head.size), head.size};
        if (!receive(bytes.bytes.get(), bytes.size, end))
        {
            return {};
        }
        return {head, std::move(bytes)};
    }

    /// Why it had to be ended.
    enum class End
    {
        byItself,
        tooLate,
        tooLarge,
    };
    [[nodiscard]] End end() const { return end_; }

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

    /// False when it ends or takes too long before; then it is no more.
    [[nodiscard]] bool receive(char* to, std::size_t size,
                               std::chrono::steady_clock::time_point end)
    {
        while (size > 0)
        {
            if (!hasMore(end))
            {
                end_ = End::tooLate;
                kill(id_, SIGKILL);
                return false;
            }
            const ssize_t count = read(pipe_, to, size);
            if (count == 0 || (count < 0 && errno != EINTR))
            {
                return false;
            }
            to += std::max<ssize_t>(count, 0);
            size -= static_cast<std::size_t>(std::max<ssize_t>(count, 0));
        }
        return true;
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
    End end_ = End::byItself;
};

std::string describeMemory(const SandboxLimits& limits)
{
    return fmt::format("it needs more than {} MB of memory", limits.bytes >> 20);
}

std::string describeExit(int status, Child::End end, const SandboxLimits& limits)
{
    const std::string anew = "export the mesh again, in another format if need be";
    if (end == Child::End::tooLarge)
    {
        return describeMemory(limits);
    }
    if (end == Child::End::tooLate)
    {
        return fmt::format("it takes more than {} s; {}", kWaitFactor * limits.seconds, anew);
    }
    if (!WIFSIGNALED(status))
    {
        return fmt::format("the reader gave up on it; {}", anew);
    }
    switch (WTERMSIG(status))
    {
    case SIGXCPU:
        return fmt::format("it takes more than {} s of processor time; {}", limits.seconds, anew);
    case SIGKILL:
        return "the reader was killed, as by a system whose memory is used up";
    default:
        return fmt::format("the reader crashed on it ({}); the file is damaged: {}",
                           sigdescr_np(WTERMSIG(status)), anew);
    }
}

SandboxedBytes joinedParts(const SandboxReport& parts)
{
    SandboxedBytes all;
    for (const std::string_view part : parts)
    {
        all.size += part.size();
    }
    all.bytes = std::make_unique_for_overwrite<char[]>(all.size);
    char* end = all.bytes.get();
    for (const std::string_view part : parts)
    {
        end = std::copy(part.begin(), part.end(), end);
    }
    return all;
}

} // namespace

SandboxedBytes runSandboxed(const SandboxLimits& asked, const std::string& subject,
                            const std::function<SandboxReport()>& work)
{
    if (!hasOneThread())
    {
        return joinedParts(work());
    }
    const SandboxLimits limits = bounded(asked);
    Child child(limits, work);
    auto [head, bytes] =
        child.listen(std::chrono::seconds(kWaitFactor * limits.seconds), limits.bytes);
    const int status = child.wait();
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || head.kind == '\0')
    {
        throw Error(ErrorCode::badData,
                    fmt::format("{}: {}", subject, describeExit(status, child.end(), limits)));
    }
    if (head.kind == kRefused)
    {
        throw Error(static_cast<ErrorCode>(head.code), std::string(bytes.view()));
    }
    if (head.kind == kOutOfMemory)
    {
        throw Error(ErrorCode::badData, fmt::format("{}: {}", subject, describeMemory(limits)));
    }
    return std::move(bytes);
}

} // namespace frostfill
