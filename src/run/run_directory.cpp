// SPDX-License-Identifier: MIT
#include "run/run_directory.hpp"

#include "output/atomic_file.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <string>
#include <vector>

namespace frostfill
{
namespace
{

constexpr const char* kFiles[] = {"spheres.csv",  "polygons.csv", "sets.csv",
                                  "summary.json", "mesh.ply",     "contact_sheet.png"};

constexpr const char* kFrameFolders[] = {"frames", "depth", "normal", "identity"};

/// frame_00000.png or a part of one that an interrupted run left behind.
bool isFrame(const std::string& name)
{
    return name.starts_with("frame_") &&
           (name.ends_with(".png") || name.find(".png.") != std::string::npos);
}

std::vector<std::filesystem::path> filesOfRun(const std::filesystem::path& directory)
{
    std::vector<std::filesystem::path> files;
    for (const char* name : kFiles)
    {
        for (const char* ending : {"", ".part"})
        {
            if (std::filesystem::exists(directory / (std::string(name) + ending)))
            {
                files.push_back(directory / (std::string(name) + ending));
            }
        }
    }
    for (const char* folder : kFrameFolders)
    {
        if (std::filesystem::is_directory(directory / folder))
        {
            for (const auto& entry : std::filesystem::directory_iterator(directory / folder))
            {
                if (isFrame(entry.path().filename().string()))
                {
                    files.push_back(entry.path());
                }
            }
        }
    }
    return files;
}

} // namespace

void prepareRunDirectory(const std::filesystem::path& directory, bool overwrite)
{
    createDirectory(directory);
    try
    {
        const auto files = filesOfRun(directory);
        if (!files.empty() && !overwrite)
        {
            throw Error(ErrorCode::cannotCreate,
                        fmt::format("{} already holds a run; give --overwrite to replace it, or "
                                    "another directory with --out",
                                    directory.string()));
        }
        for (const auto& file : files)
        {
            std::filesystem::remove(file);
        }
        std::error_code notEmpty;
        for (const char* folder : kFrameFolders)
        {
            std::filesystem::remove(directory / folder, notEmpty);
        }
    }
    catch (const std::filesystem::filesystem_error& error)
    {
        throw Error(ErrorCode::cannotCreate,
                    fmt::format("cannot use the directory {}: {}", directory.string(),
                                error.code().message()));
    }
    // Whether files can be written is better known before the simulation than after it.
    AtomicFile probe(directory / "summary.json");
}

} // namespace frostfill
