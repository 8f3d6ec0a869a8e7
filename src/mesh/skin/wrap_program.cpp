// SPDX-License-Identifier: MIT
#include "mesh/skin/wrap_program.hpp"

#include "base/atomic_file.hpp"
#include "base/read_number.hpp"
#include "base/run_program.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

namespace frostfill
{
namespace
{

constexpr const char* kProgram = "frostfill-wrap";

/// Of the child. A skin of a million triangles takes a minute and 1.5 GB.
constexpr std::size_t kBytes = std::size_t{8} << 30;
constexpr unsigned kSeconds = 600; ///< of processor time

/// A file without a name, in memory. A program that is started inherits it; it is gone when the
/// last process that has it is, however that ends.
class MemoryFile
{
public:
    explicit MemoryFile(const char* purpose) : descriptor_(memfd_create(purpose, 0))
    {
        if (descriptor_ < 0)
        {
            fail(errno);
        }
    }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    ~MemoryFile() { close(descriptor_); }
    void write(const std::string& bytes) const
    {
        const int failure = writeAll(
            descriptor_, {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
        if (failure != 0)
        {
            fail(failure);
        }
    }
    /// For this process as for the one that inherits the file.
    [[nodiscard]] std::string path() const { return fmt::format("/proc/self/fd/{}", descriptor_); }

private:
    [[noreturn]] static void fail(int why)
    {
        throw Error(ErrorCode::outOfMemory,
                    fmt::format("no memory for what {} reads and writes: {}", kProgram,
                                std::strerror(why)));
    }

    int descriptor_;
};

bool canRun(const std::filesystem::path& file)
{
    std::error_code ignored;
    return std::filesystem::is_regular_file(file, ignored) && access(file.c_str(), X_OK) == 0;
}

std::vector<std::filesystem::path> placesToLook()
{
    std::vector<std::filesystem::path> places;
    std::error_code failure;
    const auto self = std::filesystem::read_symlink("/proc/self/exe", failure);
    if (!failure)
    {
        places.push_back(self.parent_path());
        places.push_back(self.parent_path().parent_path() / "libexec");
    }
    const char* path = std::getenv("PATH");
    for (const std::string_view folder : partsOf(path != nullptr ? path : "", ':'))
    {
        if (folder.starts_with('/'))
        {
            places.emplace_back(folder);
        }
    }
    return places;
}

std::string lastLine(std::string text)
{
    while (!text.empty() && text.back() == '\n')
    {
        text.pop_back();
    }
    return text.substr(text.rfind('\n') + 1);
}

std::string whyItFailed(const ProgramRun& ran)
{
    if (ran.code == static_cast<int>(ErrorCode::outOfMemory) || ran.code == 128 + SIGABRT)
    {
        return fmt::format("{} needs more than {} GB of memory for it", kProgram, kBytes >> 30);
    }
    if (ran.code == 128 + SIGXCPU || ran.code == 128 + SIGKILL)
    {
        return fmt::format("{} takes more than {} s of processor time for it", kProgram, kSeconds);
    }
    if (ran.code > 128)
    {
        return fmt::format("{} crashed ({})", kProgram, sigdescr_np(ran.code - 128));
    }
    const std::string said = lastLine(ran.said);
    return said.empty() ? fmt::format("{} ended with exit code {}", kProgram, ran.code) : said;
}

/// Calls the program with what to do, the file of a mesh, the file to write, the numbers and the
/// limits.
TriangleMesh call(const TriangleMesh& mesh, const std::string& what,
                  const std::vector<double>& numbers, const std::string& subject)
{
    const auto program = findWrapProgram();
    if (!program)
    {
        const char* named = std::getenv("FROSTFILL_WRAP");
        throw Error(ErrorCode::missingProgram,
                    fmt::format("{}: the program {} is missing ({}); build Frostfill with cmake "
                                "-DFROSTFILL_WITH_CGAL=ON, which needs Debian's libcgal-dev",
                                subject, kProgram,
                                named != nullptr ? fmt::format("FROSTFILL_WRAP names '{}'", named)
                                                 : "it is neither beside frostfill nor in PATH"));
    }
    const MemoryFile in("mesh");
    const MemoryFile out("skin");
    in.write(plyBytes(mesh));
    std::vector<std::string> arguments = {program->string(), what, in.path(), out.path()};
    for (const double number : numbers)
    {
        arguments.push_back(fmt::format("{}", number));
    }
    arguments.push_back(std::to_string(kBytes));
    arguments.push_back(std::to_string(kSeconds));
    const ProgramRun ran = runProgram(".", std::move(arguments));
    if (ran.error != 0)
    {
        throw Error(ErrorCode::missingProgram,
                    fmt::format("{}: '{}' cannot be started: {}", subject, program->string(),
                                std::strerror(ran.error)));
    }
    if (ran.code != 0)
    {
        throw Error(ErrorCode::badData, fmt::format("{}: {}", subject, whyItFailed(ran)));
    }
    return readMesh(out.path());
}

} // namespace

std::optional<std::filesystem::path> findWrapProgram()
{
    if (const char* named = std::getenv("FROSTFILL_WRAP"); named != nullptr && *named != '\0')
    {
        return canRun(named) ? std::optional(std::filesystem::absolute(named)) : std::nullopt;
    }
    for (const std::filesystem::path& place : placesToLook())
    {
        if (canRun(place / kProgram))
        {
            return place / kProgram;
        }
    }
    return std::nullopt;
}

TriangleMesh makeSkin(const TriangleMesh& mesh, double alpha, double offset, std::string_view name)
{
    return call(mesh, "skin", {alpha, offset}, fmt::format("'{}' cannot get a skin", name));
}

TriangleMesh makeUnion(const TriangleMesh& mesh, std::string_view name)
{
    return call(mesh, "unite", {}, fmt::format("'{}' cannot be united", name));
}

} // namespace frostfill
