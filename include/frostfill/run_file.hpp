// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>
#include <frostfill/snapshot.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace frostfill
{

/// Writes a run file: what any picture of a run needs, appended frame by frame, so that a run that
/// is killed leaves all but its last frames. docs/run-file.md describes the bytes.
class RunFileWriter
{
public:
    /// A sphere's radius, and its place if it is at rest, exact [mesh unit].
    using Exact = std::function<SphereRecord(std::uint32_t id)>;

    /// Begins a new file. `head` describes the run, as JSON; `smallestRadius` [mesh unit] sets how
    /// finely places of moving spheres are kept. Throws Error cannotCreate or writeFailed.
    RunFileWriter(const std::filesystem::path& file, std::string_view head,
                  const TriangleMesh& mesh, double smallestRadius);
    ~RunFileWriter();
    RunFileWriter(const RunFileWriter&) = delete;
    RunFileWriter& operator=(const RunFileWriter&) = delete;

    /// Appends a frame. Rounds the places of moving spheres in the snapshot to the grid of the
    /// file, so that who draws it and who reads it from the file see the same bits. Frames of one
    /// simulation come in order. Throws Error writeFailed.
    void put(std::size_t frame, Snapshot& snapshot, const Exact& exact);

    /// Appends the summary, without which the run counts as unfinished, and waits until all is on
    /// the disk. Throws Error writeFailed.
    void finish(std::string_view summary);

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// Reads a run file, whole or torn.
class RunFileReader
{
public:
    /// Looks through the records without unpacking frames. Throws Error inputMissing, or badData
    /// for a file that is no run file or whose mesh is damaged.
    explicit RunFileReader(const std::filesystem::path& file);
    ~RunFileReader();
    RunFileReader(RunFileReader&&) noexcept;
    RunFileReader& operator=(RunFileReader&&) noexcept;

    [[nodiscard]] const std::string& head() const;
    [[nodiscard]] const TriangleMesh& mesh() const;
    /// Numbers of the frames that are there, ascending.
    [[nodiscard]] const std::vector<std::size_t>& frames() const;
    /// Absent in the file of a run that did not end.
    [[nodiscard]] const std::optional<std::string>& summary() const;
    /// Bytes of whole records, and of the file. They differ where it is torn.
    [[nodiscard]] std::uint64_t wholeBytes() const;
    [[nodiscard]] std::uint64_t fileBytes() const;

    /// The state at frames()[index]. Reads on from the frame before, or from the beginning. The
    /// reference is good until the next call. Throws Error badData.
    [[nodiscard]] const Snapshot& seek(std::size_t index);
    /// Exact where the sphere is at rest at the frame that was sought, [mesh unit].
    [[nodiscard]] const std::vector<Eigen::Vector3d>& centres() const;
    /// The same of the radii.
    [[nodiscard]] const std::vector<double>& radii() const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace frostfill
