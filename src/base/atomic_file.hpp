// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace frostfill
{

// Files written by system calls instead of streams: a call that a signal interrupts is repeated,
// a short write goes on, and what the disk refuses is known at the call that it refuses.

/// Creates a file, which must not be there yet. Returns a descriptor, or -1 with errno.
[[nodiscard]] int createNewFile(const std::filesystem::path& file);

/// Each returns an error number, 0 for none.
[[nodiscard]] int writeAll(int descriptor, std::span<const std::uint8_t> bytes);
/// Waits until the content is on the disk. File systems that cannot wait are no error.
[[nodiscard]] int syncFile(int descriptor);
[[nodiscard]] int closeFile(int descriptor);

/// Waits until all that was written to the file system of `directory` is on the disk.
[[nodiscard]] int syncFileSystem(const std::filesystem::path& directory);

/// Why `file` could not be written, in a sentence; on a full disk with what it needs at least and
/// what is free.
[[nodiscard]] std::string writeFailure(const std::filesystem::path& file, int error,
                                       std::size_t bytes);

/// A file that appears under its name only when complete. It is written as `NAME.part`, and
/// commit() renames it. Without a commit the part is removed.
class AtomicFile
{
public:
    /// Throws Error cannotCreate.
    explicit AtomicFile(std::filesystem::path file) : AtomicFile(std::move(file), ".part") {}
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// Throws Error writeFailed, for instance on a full disk.
    void write(std::string_view text);

    /// Throws Error writeFailed, and cannotCreate where a folder has the name.
    void commit() { commit(true); }

private:
    friend void saveBytes(std::span<const std::uint8_t>, const std::filesystem::path&);
    AtomicFile(std::filesystem::path file, std::string_view unfinished);
    void commit(bool waits);
    void flush();
    void put(std::string_view bytes) const;
    void check(int error) const;

    std::filesystem::path file_;
    std::filesystem::path part_;
    int descriptor_ = -1;
    std::string waiting_;     ///< not given to the system yet
    std::size_t written_ = 0; ///< bytes in all
};

/// Writes a whole file, as AtomicFile does, without waiting for the disk: pictures are many. Each
/// process has an unfinished file of its own, so two may write the same picture.
void saveBytes(std::span<const std::uint8_t> bytes, const std::filesystem::path& file);

/// Creates `directory` and its missing parents. Throws Error cannotCreate.
void createDirectory(const std::filesystem::path& directory);

} // namespace frostfill
