// SPDX-License-Identifier: MIT
// Room: files that a run writes: frames, video, CSV, JSON. A file appears under its name only
// when it is complete.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace frostfill
{

/// A file that appears under its name only when complete. It is written as `NAME.part`, and
/// commit() renames it. Without a commit the part is removed.
class AtomicFile
{
public:
    /// Throws Error cannotCreate.
    explicit AtomicFile(std::filesystem::path file);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// Throws Error writeFailed, for instance on a full disk.
    void write(std::string_view text);

    /// Throws Error writeFailed.
    void commit();

private:
    void flush();
    void put(std::string_view bytes) const;
    void check(int error) const;

    std::filesystem::path file_;
    std::filesystem::path part_;
    int descriptor_ = -1;
    std::string waiting_;     ///< not given to the system yet
    std::size_t written_ = 0; ///< bytes in all
};

/// Creates `directory` and its missing parents. Throws Error cannotCreate.
void createDirectory(const std::filesystem::path& directory);

} // namespace frostfill
