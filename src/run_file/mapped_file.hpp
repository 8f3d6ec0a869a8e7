// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

namespace frostfill
{

/// The bytes of a file, read when they are looked at.
class MappedFile
{
public:
    /// Throws Error inputMissing.
    explicit MappedFile(const std::filesystem::path& file);
    ~MappedFile();
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;
    [[nodiscard]] std::string_view bytes() const { return bytes_; }

private:
    std::string_view bytes_;
};

} // namespace frostfill
