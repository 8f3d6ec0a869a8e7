// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/fill.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace frostfill
{

/// What is done with the files of an earlier run.
enum class EarlierRun
{
    refuse,
    replace,
    keep,  ///< but for its summary, without which it is not complete
    share, ///< with processes that write other pictures of the same run at the same time
};

/// The directory that a run writes to. It is looked at, locked and found writable first; an earlier
/// run in it goes only when the new one begins. Files that no run of ours has written are never
/// touched, nor is anything behind a symbolic link.
class RunDirectory
{
public:
    /// Creates the directory with what is missing above it. Throws Error cannotCreate when it
    /// cannot be written to, when another process runs in it, when it holds an earlier run that is
    /// refused, and when something that is no file of a run has the name of one.
    RunDirectory(std::filesystem::path directory, EarlierRun earlier);
    /// Throws what the constructor would throw, but writes nothing.
    static void check(const std::filesystem::path& directory, EarlierRun earlier);
    ~RunDirectory();
    RunDirectory(const RunDirectory&) = delete;
    RunDirectory& operator=(const RunDirectory&) = delete;

    /// Removes the files of the earlier run that are not kept. Throws Error cannotCreate.
    void begin();

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    struct SurveyOnly
    {
    };
    RunDirectory(std::filesystem::path directory, EarlierRun earlier, SurveyOnly);
    void survey();
    void lock();
    void surveyFiles();
    void surveyFrames(const std::filesystem::path& folder);
    void takeOver(const std::filesystem::path& file, bool isOurs);

    std::filesystem::path path_;
    EarlierRun earlier_;
    bool writes_; ///< and has the lock to itself; false: shares it
    /// The directory itself, opened; closed also when the rest of the construction fails.
    struct Lock
    {
        int descriptor = -1;
        Lock() = default;
        Lock(const Lock&) = delete;
        Lock& operator=(const Lock&) = delete;
        ~Lock();
    };
    Lock lock_;
    std::vector<std::filesystem::path> old_;  ///< of the earlier run
    std::vector<std::filesystem::path> left_; ///< by one that was killed: not worth keeping
};

/// The mesh of the run that the directory holds, as it is simulated; empty if none is kept there.
/// Throws Error badData or usage for a run of another version or another scene, with which the
/// request cannot go on.
[[nodiscard]] std::optional<LoadedMesh> meshOfEarlierRun(const FillRequest& request);

/// The first setting by which two scenes give different runs, "seed = 1, not 2"; empty if there is
/// none. The number of threads and similar options change no bit.
[[nodiscard]] std::string sceneDifference(const Scene& begun, const Scene& now);

/// What to do with the files in the directory of a request; `resumes`: with a run that is kept.
[[nodiscard]] EarlierRun earlierFiles(const FillRequest& request, bool resumes);

} // namespace frostfill
