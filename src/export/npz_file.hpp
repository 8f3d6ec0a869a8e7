// SPDX-License-Identifier: MIT
#pragma once

#include "base/atomic_file.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace frostfill
{

/// A .npz file: a ZIP archive, not compressed, of arrays in NumPy's format. Arrays are appended one
/// after another, so that none has to be in memory as a whole.
class NpzFile
{
public:
    explicit NpzFile(const std::filesystem::path& file) : file_(file) {}

    /// Begins an array. `type` is NumPy's name, such as "<f8"; `shape` such as {frames, spheres,
    /// 3}.
    void begin(const std::string& name, std::string_view type,
               const std::vector<std::size_t>& shape);
    /// The next bytes of the array, in C order.
    void write(std::string_view bytes);
    /// Ends the array. Throws Error badData if an array has 4 GiB or more.
    void end();
    /// Writes the archive's directory.
    void commit();

private:
    struct Entry
    {
        std::string name;
        std::uint32_t sum = 0; ///< CRC-32
        std::uint64_t size = 0;
        std::uint64_t at = 0; ///< of its header in the file
    };
    void put(std::string_view bytes);

    AtomicFile file_;
    std::uint64_t written_ = 0;
    std::vector<Entry> entries_;
};

} // namespace frostfill
