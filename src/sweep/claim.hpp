// SPDX-License-Identifier: MIT
// Room: many runs: which of them a process does, how each has ended, and the table of all.
#pragma once

#include <filesystem>

namespace frostfill
{

/// Holds a run against other processes, also on other machines that see the same folder, for as
/// long as it lives, or its process. The folder gets an empty file sweep.lock. The lock of a run's
/// directory itself does not reach over NFS, this one does.
class Claim
{
public:
    /// Throws Error cannotCreate.
    explicit Claim(const std::filesystem::path& folder);
    ~Claim();
    Claim(const Claim&) = delete;
    Claim& operator=(const Claim&) = delete;

    /// False if another one holds the run. On a file system without locks this is always true.
    [[nodiscard]] bool holds() const { return holds_; }

private:
    int descriptor_ = -1;
    bool holds_ = false;
};

/// Whether some process holds the run. Writes nothing.
[[nodiscard]] bool isClaimed(const std::filesystem::path& folder);

} // namespace frostfill
