// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

namespace frostfill
{

/// Where the bytes of large arrays go that are rarely looked at. Empty: there is no folder for
/// them, or it lies in memory itself.
[[nodiscard]] std::optional<std::filesystem::path> spillFolder();

/// Whether there is one with room for so many bytes, and the user has set no limit on files or on
/// addresses, which those of a file count among.
[[nodiscard]] bool maySpill(double bytes);

/// Bytes in one piece, which may grow. A small piece is in memory. A large one is a file without a
/// name in spillFolder(), which is mapped: reads and writes go to memory as ever, but leave() takes
/// out of it what is not looked at any more, and what is looked at again comes back by itself. So
/// an array of which only the end changes takes memory by what is in use, and space on a disk by
/// its length. The file goes with the piece, however the program ends.
///
/// Where the file cannot grow, as on a full disk, the piece goes back to memory.
class SpilledBytes
{
public:
    /// In memory up to here. Larger: memory that is not looked at. Smaller: files for runs that
    /// take seconds, and pages of 4 KB where huge ones would do.
    static constexpr std::size_t kInMemory = std::size_t{64} << 20;

    explicit SpilledBytes(std::size_t inMemory = kInMemory) : inMemory_(inMemory) {}
    ~SpilledBytes();
    SpilledBytes(SpilledBytes&& other) noexcept;
    SpilledBytes& operator=(SpilledBytes&& other) noexcept;

    [[nodiscard]] void* data() { return bytes_; }
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] std::size_t inMemory() const { return inMemory_; }
    [[nodiscard]] bool isInFile() const { return file_ >= 0; }

    /// To `size` at least, and more where many small steps would be slow. The first `used` bytes
    /// stay as they are, elsewhere perhaps. Throws std::bad_alloc.
    void grow(std::size_t used, std::size_t size);
    /// All that is in a file leaves memory. Threads may read and write meanwhile.
    void leave() const;

private:
    void moveToHeap(std::size_t used, std::size_t size);
    [[nodiscard]] bool moveToMapping(int file, std::size_t used, std::size_t size);
    [[nodiscard]] bool growMapping(std::size_t size);
    void release();

    std::size_t inMemory_;
    void* bytes_ = nullptr;
    std::size_t size_ = 0;
    bool isMapped_ = false; ///< of a file, or of pages of memory where there is none
    int file_ = -1;         ///< its descriptor
};

} // namespace frostfill
