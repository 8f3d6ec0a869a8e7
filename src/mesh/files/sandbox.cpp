// SPDX-License-Identifier: MIT
// Reading a mesh from an untrusted source. Assimp 5.2.5, the reader of glTF in Debian 12,
// crashes, hangs or fills the memory on damaged files; in a child process that costs a sentence.
// The other readers are not known to, and are sandboxed nevertheless.
#include "mesh/files/sandbox.hpp"

#include "base/atomic_file.hpp"
#include "base/read_number.hpp"
#include "base/resources.hpp"
#include "base/run_program.hpp"
#include "mesh/files/readers.hpp"
#include "mesh/repair/repair_steps.hpp"

#include <frostfill/error.hpp>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <new>
#include <span>
#include <system_error>
#include <utility>

namespace frostfill
{
namespace
{

/// The child's end of the pipe; it has no other file open above it.
constexpr int kReport = 3;
constexpr rlim_t kMaxFiles = 16;
/// A child that sleeps uses no processor time: it ends after its limit times this. [1]
constexpr unsigned kWaitFactor = 10;

/// What the pipe holds, if the system allows that. [byte] Smaller: parent and child wait for each
/// other more often. Larger: more than the processor's cache keeps.
constexpr int kPipe = 1 << 20;

enum class Outcome : char
{
    none,
    done,       ///< vertices, triangles, remarks and patches follow
    refused,    ///< the error's sentence follows in place of remarks
    outOfMemory ///< nothing follows
};

/// How the report of the child begins.
struct Head
{
    Outcome outcome = Outcome::none;
    unsigned char code = 0;                ///< of an error
    std::array<std::uint64_t, 4> counts{}; ///< of vertices, triangles, and bytes of both texts
};

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
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGPIPE, SIGXCPU, SIGALRM})
    {
        std::signal(signal, SIG_DFL);
    }
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    alarm(std::max(1U, kWaitFactor * limits.seconds));
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

void send(const void* bytes, std::size_t size)
{
    if (writeAll(kReport, {static_cast<const std::uint8_t*>(bytes), size}) != 0)
    {
        _exit(1);
    }
}

void report(Outcome outcome, unsigned char code, const ReadResult& result)
{
    const auto& [mesh, remarks, patches] = result;
    const Head head{outcome,
                    code,
                    {mesh.vertices.size(), mesh.triangles.size(), remarks.size(), patches.size()}};
    send(&head, sizeof head);
    send(mesh.vertices.data(), mesh.vertices.size() * sizeof mesh.vertices[0]);
    send(mesh.triangles.data(), mesh.triangles.size() * sizeof mesh.triangles[0]);
    send(remarks.data(), remarks.size());
    send(patches.data(), patches.size());
}

[[noreturn]] void runAsChild(const SandboxLimits& limits, int pipe,
                             const std::function<ReadResult()>& work)
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
        report(Outcome::done, 0, work());
    }
    catch (const Error& error)
    {
        report(Outcome::refused, static_cast<unsigned char>(error.code()), {{}, error.what(), {}});
    }
    catch (const std::bad_alloc&)
    {
        report(Outcome::outOfMemory, 0, {});
    }
    // Nothing of the parent's is to be flushed or destroyed twice.
    _exit(0);
}

/// A child process and the pipe on which it reports. Ends with it, by force if need be.
class Child
{
public:
    Child(const SandboxLimits& limits, const std::function<ReadResult()>& work)
    {
        if (pipe_.error() != 0)
        {
            refuse("no pipe is available", pipe_.error());
        }
        fcntl(pipe_.reading(), F_SETPIPE_SZ, kPipe);
        id_ = fork();
        if (id_ == 0)
        {
            runAsChild(limits, pipe_.writing(), work);
        }
        if (id_ < 0)
        {
            refuse("no process is available", errno);
        }
        pipe_.closeWriting();
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child()
    {
        if (id_ > 0)
        {
            kill(id_, SIGKILL);
            std::ignore = end();
        }
    }

    /// Reads what the child sends into `values`. False when the child ends before.
    template <class Values>
    [[nodiscard]] bool receive(Values&& values) const
    {
        auto* to = reinterpret_cast<char*>(std::data(values));
        for (std::size_t left = std::size(values) * sizeof *std::data(values); left > 0;)
        {
            const ssize_t count = read(pipe_.reading(), to, left);
            if (count == 0 || (count < 0 && errno != EINTR))
            {
                return false;
            }
            to += std::max<ssize_t>(count, 0);
            left -= static_cast<std::size_t>(std::max<ssize_t>(count, 0));
        }
        return true;
    }

    /// Waits until the child has ended, and returns how, as waitpid tells it. What it still sends
    /// is lost.
    [[nodiscard]] int end()
    {
        pipe_.closeReading();
        return waitFor(std::exchange(id_, -1));
    }

private:
    [[noreturn]] static void refuse(const char* why, int error)
    {
        throw Error(
            ErrorCode::outOfMemory,
            fmt::format("{} for reading a mesh in a child process: {}", why, std::strerror(error)));
    }

    Pipe pipe_;
    pid_t id_ = -1;
};

std::string describeExit(int status, const SandboxLimits& limits)
{
    const std::string anew = "export the mesh again, in another format if need be";
    if (!WIFSIGNALED(status))
    {
        return fmt::format("the reader gave up on it; {}", anew);
    }
    switch (WTERMSIG(status))
    {
    case SIGALRM:
        return fmt::format("it takes more than {} s; {}", kWaitFactor * limits.seconds, anew);
    case SIGXCPU:
        return fmt::format("it takes more than {} s of processor time; {}", limits.seconds, anew);
    case SIGKILL:
        return "the reader was killed, as by a system whose memory is used up";
    default:
        return fmt::format("the reader crashed on it ({}); the file is damaged: {}",
                           sigdescr_np(WTERMSIG(status)), anew);
    }
}

/// Whether all that a child announces is no more than it may have.
bool isModest(const Head& head, std::size_t most)
{
    const std::array<std::size_t, 4> sizes = {sizeof(Eigen::Vector3d), sizeof(Triangle), 1, 1};
    std::size_t left = most;
    for (std::size_t k = 0; k < sizes.size(); ++k)
    {
        if (head.counts[k] > left / sizes[k])
        {
            return false;
        }
        left -= head.counts[k] * sizes[k];
    }
    return true;
}

} // namespace

ReadResult runSandboxed(const SandboxLimits& asked, const std::string& subject,
                        const std::function<ReadResult()>& work)
{
    if (!hasOneThread())
    {
        return work();
    }
    const SandboxLimits limits = bounded(asked);
    Child child(limits, work);
    Head head;
    ReadResult result;
    const bool isAnswer = child.receive(std::span(&head, 1));
    const bool fits = isModest(head, limits.bytes);
    if (isAnswer && fits)
    {
        result.mesh.vertices.resize(head.counts[0]);
        result.mesh.triangles.resize(head.counts[1]);
        result.remarks.resize(head.counts[2]);
        result.patches.resize(head.counts[3]);
    }
    const bool isWhole = isAnswer && fits && child.receive(result.mesh.vertices) &&
                         child.receive(result.mesh.triangles) && child.receive(result.remarks) &&
                         child.receive(result.patches);
    const int status = child.end();
    if (!fits || head.outcome == Outcome::outOfMemory)
    {
        throw Error(ErrorCode::badData, fmt::format("{}: it needs more than {} MB of memory",
                                                    subject, limits.bytes >> 20));
    }
    if (!isWhole || status != 0)
    {
        throw Error(ErrorCode::badData,
                    fmt::format("{}: {}", subject, describeExit(status, limits)));
    }
    if (head.outcome == Outcome::refused)
    {
        throw Error(static_cast<ErrorCode>(head.code), result.remarks);
    }
    return result;
}

namespace
{

// A mesh takes some 30 times its file's size while it is read. Damaged files of a few hundred bytes
// take without end.
constexpr std::size_t kBytesAtLeast = std::size_t{768} << 20;
constexpr std::size_t kBytesPerByte = 100;
constexpr std::size_t kSecondsAtLeast = 2;
constexpr std::size_t kBytesPerSecond = std::size_t{1} << 20;

SandboxLimits limitsFor(const std::filesystem::path& given)
{
    std::size_t size = 0;
    for (const std::filesystem::path& file : filesOfMesh(given))
    {
        size += contentSize(file); // a file that is not there is told by readMesh
    }
    return {kBytesAtLeast + kBytesPerByte * size,
            static_cast<unsigned>(kSecondsAtLeast + size / kBytesPerSecond)};
}

/// Whole lines of ASCII, which no terminal takes for anything else.
bool isText(std::string_view text)
{
    return (text.empty() || text.back() == '\n') &&
           std::all_of(text.begin(), text.end(),
                       [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); });
}

std::vector<std::string_view> linesOf(std::string_view text)
{
    return text.empty() ? std::vector<std::string_view>()
                        : partsOf(text.substr(0, text.size() - 1), '\n');
}

} // namespace

TriangleMesh readMeshSandboxed(const std::filesystem::path& file, std::vector<std::string>* remarks,
                               std::vector<MeshPatch>* patches)
{
    const std::string subject = fmt::format("'{}' cannot be read as a mesh", file.string());
    const ReadResult result =
        runSandboxed(limitsFor(file), subject,
                     [&]
                     {
                         std::vector<std::string> sentences;
                         std::vector<MeshPatch> found;
                         ReadResult read{readMesh(file, &sentences, &found), {}, {}};
                         for (const std::string& sentence : sentences)
                         {
                             read.remarks += sentence + '\n';
                         }
                         for (const MeshPatch& patch : found)
                         {
                             read.patches +=
                                 fmt::format("{}\n{}\n", wordOfPatch(patch.name), patch.triangles);
                         }
                         return read;
                     });
    // What came out of the sandbox is believed no more than the file: a reader that was led astray
    // may have sent anything.
    if (!isText(result.remarks) || !isText(result.patches) || findInvalidData(result.mesh))
    {
        throw Error(ErrorCode::badData, subject + ": the reader returned an invalid mesh; export "
                                                  "the mesh again, in another format if need be");
    }
    const std::vector<std::string_view> sentences = linesOf(result.remarks);
    if (remarks != nullptr)
    {
        remarks->insert(remarks->end(), sentences.begin(), sentences.end());
    }
    const std::vector<std::string_view> found = linesOf(result.patches);
    for (std::size_t k = 1; patches != nullptr && k < found.size(); k += 2)
    {
        patches->push_back(
            {std::string(found[k - 1]), readNumber<std::size_t>(found[k]).value_or(0)});
    }
    return result.mesh;
}

} // namespace frostfill
