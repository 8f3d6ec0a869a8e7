// SPDX-License-Identifier: MIT
#include "run/run_directory.hpp"

#include "base/atomic_file.hpp"
#include "run/run_head.hpp"
#include "run_file/file_of_run.hpp"
#include "scene/shown_unbalance.hpp"

#include <frostfill/error.hpp>
#include <frostfill/measure.hpp>
#include <frostfill/options.hpp>
#include <frostfill/output.hpp>
#include <frostfill/run_file.hpp>

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iterator>
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

namespace
{

/// With these a run may be resumed differently: they change no bit.
constexpr std::string_view kWithoutEffect[] = {"threads", "picture.static_layer", "picture.backend",
                                               "frames.keep_run", "camera.path"};

bool hasEffect(const Option& option, const Scene& scene)
{
    return option.key.starts_with("judge.")
               ? showsUnbalance(scene)
               : std::none_of(std::begin(kWithoutEffect), std::end(kWithoutEffect),
                              [&](std::string_view key) { return &optionOf(key) == &option; });
}

void refuseAnotherScene(const Scene& begun, const Scene& now,
                        const std::filesystem::path& directory)
{
    if (const std::string difference = sceneDifference(begun, now); !difference.empty())
    {
        throw Error(ErrorCode::usage,
                    fmt::format("the run in {} was begun with {}; resume it with the same options "
                                "or none, or replace it with --overwrite",
                                directory.string(), difference));
    }
}

/// Throws Error usage for a run that was never simulated here.
void refuseImported(const RunHead& head, const std::filesystem::path& directory)
{
    if (!head.importedFrom.empty())
    {
        throw Error(
            ErrorCode::usage,
            fmt::format(
                "the run in {} was imported from '{}': it cannot be resumed; render or export it",
                directory.string(), head.importedFrom));
    }
}

bool isThere(const std::filesystem::path& file)
{
    std::error_code error;
    return std::filesystem::exists(file, error);
}

/// The file that keeps the run in a directory: a run that was begun last replaces one before it.
std::filesystem::path keptFile(const std::filesystem::path& directory)
{
    return directory / (isThere(directory / kBegunFile) ? kBegunFile : kRunFile);
}

} // namespace

std::string sceneDifference(const Scene& begun, const Scene& now)
{
    for (const Option& option : sceneOptions())
    {
        if (hasEffect(option, begun) && option.get(begun) != option.get(now))
        {
            return fmt::format("{} = {}, not {}", option.key, optionText(option, option.get(begun)),
                               optionText(option, option.get(now)));
        }
    }
    return "";
}

std::optional<LoadedMesh> meshOfEarlierRun(const FillRequest& request)
{
    const std::filesystem::path file = keptFile(request.directory);
    if (!isThere(file))
    {
        return std::nullopt;
    }
    const RunFileReader reader(file);
    const RunHead head = readHead(reader.head(), file.string());
    refuseImported(head, request.directory);
    const std::string version = describeMachine().version;
    if (head.version != version)
    {
        throw Error(ErrorCode::badData,
                    fmt::format("the run in {} was begun by Frostfill {}, and this is {}, which "
                                "may not repeat it to the bit; begin it again with --overwrite",
                                request.directory.string(), head.version, version));
    }
    refuseAnotherScene(head.scene, request.scene, request.directory);
    LoadedMesh mesh;
    mesh.mesh = reader.mesh();
    mesh.repairs = head.repairs;
    mesh.lidTriangles = head.lidTriangles;
    mesh.patches = head.patches;
    return mesh;
}

EarlierRun earlierFiles(const FillRequest& request, bool resumes)
{
    const bool isBegun = isThere(request.directory / kBegunFile);
    if (resumes && !isBegun)
    {
        return EarlierRun::keep;
    }
    // Without a run file there is nothing to go on with. What a run has left that was killed as it
    // began is not worth keeping; one that has ended is.
    const bool begins = request.resume && (isBegun || !isThere(request.directory / "summary.json"));
    return request.overwrite || begins ? EarlierRun::replace : EarlierRun::refuse;
}

FillRequest resumeRequest(const std::filesystem::path& directory)
{
    const std::filesystem::path file = keptFile(directory);
    if (!isThere(file))
    {
        throw Error(ErrorCode::inputMissing,
                    fmt::format("{} holds no run to resume: {} is missing; a run with --set "
                                "frames.keep_run=true writes it once its mesh is read",
                                directory.string(), kRunFile));
    }
    const RunHead head = readHead(RunFileReader(file).head(), file.string());
    refuseImported(head, directory);
    FillRequest request;
    request.scene = head.scene;
    request.directory = directory;
    request.video = head.video;
    request.resume = true;
    return request;
}

std::string outcomeOfRun(const std::filesystem::path& directory)
{
    if (isThere(directory / kBegunFile))
    {
        return "";
    }
    std::ifstream in(directory / "summary.json");
    const auto summary = nlohmann::json::parse(in, nullptr, false);
    return summary.is_object() && summary.contains("outcome") && summary["outcome"].is_string()
               ? summary["outcome"].get<std::string>()
               : "";
}

} // namespace frostfill
