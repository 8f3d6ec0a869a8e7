// SPDX-License-Identifier: MIT
#include "run/run_directory.hpp"

#include "base/atomic_file.hpp"
#include "run_file/file_of_run.hpp"

#include <frostfill/error.hpp>
#include <frostfill/output.hpp>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <string>
#include <string_view>
#include <utility>

namespace frostfill
{
namespace
{

/// A file of a run, and what it has in its first bytes.
struct KnownFile
{
    const char* name;
    std::string_view sign;
};
constexpr KnownFile kFiles[] = {{"spheres.csv", "id,group,x,y,z,radius"},
                                {"polygons.csv", "id,state"},
                                {"sets.csv", "set,spheres"},
                                {"summary.json", "\"outcome\""},
                                {"mesh.ply", "Frostfill"},
                                {"view.html", "Frostfill"},
                                {kRunFile, "frostrun"},
                                {kBegunFile, "frostrun"}};

constexpr const char* kFrameFolders[] = {"frames", "depth", "normal", "identity"};

/// Signs of our own stand in a file's first bytes.
constexpr std::size_t kHead = 2048;

/// ".png.1234.tmp" or ".png.part": what a run that was killed leaves behind.
bool isLeftOver(std::string_view ending)
{
    return ending.starts_with(".png.") && (ending.ends_with(".tmp") || ending.ends_with(".part"));
}

bool holdsSign(const std::filesystem::path& file, std::string_view sign)
{
    std::string head(kHead, '\0');
    std::ifstream stream(file, std::ios::binary);
    stream.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(stream.gcount()));
    return head.find(sign) != std::string::npos;
}

[[noreturn]] void refuse(const std::string& why)
{
    throw Error(ErrorCode::cannotCreate, why);
}

} // namespace

RunDirectory::RunDirectory(std::filesystem::path directory, EarlierRun earlier)
    : path_(std::move(directory)), earlier_(earlier), writes_(earlier != EarlierRun::share)
{
    createDirectory(path_);
    survey();
    if (writes_)
    {
        // Whether files can be written is better known before the simulation than after it.
        AtomicFile probe(path_ / "summary.json");
    }
}

RunDirectory::RunDirectory(std::filesystem::path directory, EarlierRun earlier, SurveyOnly)
    : path_(std::move(directory)), earlier_(earlier), writes_(false)
{
    survey();
}

void RunDirectory::check(const std::filesystem::path& directory, EarlierRun earlier)
{
    std::error_code none;
    std::filesystem::path there = std::filesystem::absolute(directory);
    while (!std::filesystem::exists(there, none) && there.has_relative_path())
    {
        there = there.parent_path();
    }
    if (!std::filesystem::is_directory(there, none) || access(there.c_str(), W_OK | X_OK) != 0)
    {
        refuse(fmt::format("cannot create the directory {}: {} is no directory that can be "
                           "written to",
                           directory.string(), there.string()));
    }
    if (std::filesystem::is_directory(directory, none))
    {
        const RunDirectory looked(directory, earlier, SurveyOnly{});
    }
}

void RunDirectory::survey()
{
    lock();
    try
    {
        surveyFiles();
        for (const char* folder : kFrameFolders)
        {
            surveyFrames(path_ / folder);
        }
    }
    catch (const std::filesystem::filesystem_error& error)
    {
        refuse(
            fmt::format("cannot use the directory {}: {}", path_.string(), error.code().message()));
    }
    if (!old_.empty() && earlier_ == EarlierRun::refuse)
    {
        refuse(fmt::format("{} already holds a run; give --overwrite to replace it, or another "
                           "directory with --out",
                           path_.string()));
    }
}

RunDirectory::~RunDirectory()
{
    if (!writes_)
    {
        return; // others may be about to use the folder
    }
    std::error_code notEmpty;
    for (const char* folder : kFrameFolders)
    {
        if (!std::filesystem::is_symlink(path_ / folder, notEmpty))
        {
            std::filesystem::remove(path_ / folder, notEmpty);
        }
    }
}

RunDirectory::Lock::~Lock()
{
    if (descriptor >= 0)
    {
        close(descriptor);
    }
}

// On the directory itself: it leaves no file behind, and goes with the process however that ends.
// Where file systems know no such locks the run goes on without.
void RunDirectory::lock()
{
    lock_.descriptor = open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const int kind = writes_ ? LOCK_EX : LOCK_SH;
    if (lock_.descriptor >= 0 && flock(lock_.descriptor, kind | LOCK_NB) != 0 &&
        errno == EWOULDBLOCK)
    {
        refuse(fmt::format("another run is writing to {}; wait for its end, or give another "
                           "directory with --out",
                           path_.string()));
    }
}

void RunDirectory::surveyFiles()
{
    for (const KnownFile& known : kFiles)
    {
        const std::filesystem::path file = path_ / known.name;
        const std::filesystem::path part = file.string() + ".part";
        if (std::filesystem::symlink_status(file).type() != std::filesystem::file_type::not_found)
        {
            takeOver(file, holdsSign(file, known.sign));
        }
        if (std::filesystem::is_regular_file(std::filesystem::symlink_status(part)))
        {
            left_.push_back(part);
        }
    }
    if (std::filesystem::is_regular_file(std::filesystem::symlink_status(path_ / kStatesFile)))
    {
        left_.push_back(path_ / kStatesFile);
    }
}

void RunDirectory::surveyFrames(const std::filesystem::path& folder)
{
    const std::filesystem::file_status status = std::filesystem::symlink_status(folder);
    if (status.type() == std::filesystem::file_type::not_found)
    {
        return;
    }
    if (!std::filesystem::is_directory(status))
    {
        refuse(fmt::format("{} is in the way: a run makes a directory of that name; move it, or "
                           "give another directory with --out",
                           folder.string()));
    }
    for (const auto& entry : std::filesystem::directory_iterator(folder))
    {
        const std::string name = entry.path().filename().string();
        const std::string_view ending = PngSequence::endingOf(name);
        if (ending == ".png")
        {
            takeOver(entry.path(), holdsSign(entry.path(), "Frostfill"));
        }
        else if (isLeftOver(ending) &&
                 entry.symlink_status().type() == std::filesystem::file_type::regular)
        {
            left_.push_back(entry.path());
        }
    }
}

void RunDirectory::takeOver(const std::filesystem::path& file, bool isOurs)
{
    if (!std::filesystem::is_regular_file(std::filesystem::symlink_status(file)) || !isOurs)
    {
        refuse(fmt::format("{} was not written by a run, and this run would replace it; move it, "
                           "or give another directory with --out",
                           file.string()));
    }
    const bool keeps = earlier_ == EarlierRun::keep && file.filename() != "summary.json";
    const bool isBegun = file.filename() == kBegunFile; // goes when there is a run file
    if (!keeps && !isBegun && earlier_ != EarlierRun::share)
    {
        old_.push_back(file);
    }
}

void RunDirectory::begin()
{
    if (earlier_ == EarlierRun::share)
    {
        return; // what looks left behind is being written by others
    }
    std::error_code error;
    for (const auto* files : {&left_, &old_})
    {
        for (const std::filesystem::path& file : *files)
        {
            std::filesystem::remove(file, error);
            if (error)
            {
                refuse(fmt::format("cannot remove {}: {}", file.string(), error.message()));
            }
        }
    }
    left_.clear();
    old_.clear();
}

} // namespace frostfill
