// SPDX-License-Identifier: MIT
#include "output/thinned_folder.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <string>
#include <tuple>

namespace frostfill
{
namespace
{

std::error_code keepInPlace(const std::filesystem::path& folder, std::size_t count,
                            const PictureName& name)
{
    std::error_code error;
    for (std::size_t index = 1; index < count && !error; ++index)
    {
        if (index % 2 == 1)
        {
            std::filesystem::remove(folder / name(index), error);
        }
        else
        {
            std::filesystem::rename(folder / name(index), folder / name(index / 2), error);
        }
    }
    return error;
}

/// Pictures that a killed run has left there go; the folder itself only if nothing else is in it.
void clear(const std::filesystem::path& folder, std::size_t count, const PictureName& name)
{
    for (std::size_t index = 0; index < count; ++index)
    {
        unlink((folder / name(index)).c_str());
    }
    rmdir(folder.c_str());
}

/// Puts hard links to the half into a new folder; false when that cannot be done here.
bool linkHalf(const std::filesystem::path& from, const std::filesystem::path& to, std::size_t count,
              const PictureName& name)
{
    std::error_code error;
    if (!std::filesystem::create_directory(to, error))
    {
        return false;
    }
    for (std::size_t index = 0; index < count && !error; index += 2)
    {
        std::filesystem::create_hard_link(from / name(index), to / name(index / 2), error);
    }
    return !error;
}

/// In one step where the file system can, else in two.
bool changePlaces(const std::filesystem::path& folder, const std::filesystem::path& other)
{
    if (renameat2(AT_FDCWD, folder.c_str(), AT_FDCWD, other.c_str(), RENAME_EXCHANGE) == 0)
    {
        return true;
    }
    const std::string aside = other.string() + ".old";
    if (std::rename(folder.c_str(), aside.c_str()) != 0)
    {
        return false;
    }
    if (std::rename(other.c_str(), folder.c_str()) != 0)
    {
        std::ignore = std::rename(aside.c_str(), folder.c_str());
        return false;
    }
    return std::rename(aside.c_str(), other.c_str()) == 0;
}

/// What is not ours goes along.
void moveRest(const std::filesystem::path& from, const std::filesystem::path& to)
{
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(from, error))
    {
        renameat2(AT_FDCWD, entry.path().c_str(), AT_FDCWD, (to / entry.path().filename()).c_str(),
                  RENAME_NOREPLACE);
    }
}

} // namespace

std::error_code keepEverySecond(const std::filesystem::path& folder, std::size_t count,
                                const PictureName& name)
{
    std::error_code error;
    std::filesystem::path plain = folder.has_filename() ? folder : folder.parent_path();
    std::filesystem::path half = plain;
    half += ".part";
    clear(half, count, name);
    const bool swaps = std::filesystem::symlink_status(plain, error).type() ==
                           std::filesystem::file_type::directory &&
                       linkHalf(plain, half, count, name) && changePlaces(plain, half);
    if (!swaps)
    {
        clear(half, count, name);
        return keepInPlace(folder, count, name);
    }
    for (std::size_t index = 0; index < count; ++index)
    {
        unlink((half / name(index)).c_str());
    }
    moveRest(half, plain);
    rmdir(half.c_str());
    return {};
}

} // namespace frostfill
