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

#pragma GCC visibility push(default)
namespace frostfill
{

/// The file of a run that is named by its file or its directory. Throws Error inputMissing.
[[nodiscard]] std::filesystem::path fileOfRun(const std::filesystem::path& run);

/// What is done with a run file that is there.
enum class EarlierFile
{
    replace,   ///< it goes as soon as the new one has its head and its mesh
    continued, ///< what is equal stays; from the first difference on it is written anew
};

/// A sphere's radius, and its place if it is at rest, exact [mesh unit].
using ExactSphere = std::function<SphereRecord(std::uint32_t id)>;

/// Rounds what has changed in a snapshot to what a run file keeps of it, so that who draws it and
/// who reads it from the file see the same bits. `smallestRadius` is that of the run [mesh unit].
void roundPlaces(Snapshot& snapshot, double smallestRadius, const ExactSphere& exact);

/// Writes a run file: what any picture of a run needs, appended frame by frame, so that a run that
/// is killed leaves all but its last frames. docs/run-file.md describes the bytes.
class RunFileWriter
{
public:
    /// Begins a new file. `head` describes the run, as JSON; `smallestRadius` [mesh unit] sets how
    /// finely places of moving spheres are kept. The file appears with its head and its mesh.
    /// Throws Error cannotCreate or writeFailed.
    RunFileWriter(const std::filesystem::path& file, std::string_view head,
                  const TriangleMesh& mesh, double smallestRadius,
                  EarlierFile earlier = EarlierFile::replace);
    ~RunFileWriter();
    RunFileWriter(const RunFileWriter&) = delete;
    RunFileWriter& operator=(const RunFileWriter&) = delete;

    /// Appends a frame, rounded as by roundPlaces(). Frames of one simulation come in order. Throws
    /// Error writeFailed.
    void put(std::size_t frame, const Snapshot& snapshot, const ExactSphere& exact);
    /// Appends a frame that shows the state of the frame before. Throws Error writeFailed.
    void repeat(std::size_t frame);

    /// Writes the frames that wait to be packed together. Throws Error writeFailed.
    void flush();
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
    /// reference is good until the next call. Snapshot::changed names what has changed since
    /// forgetChanges() was last called. Throws Error badData.
    [[nodiscard]] const Snapshot& seek(std::size_t index);
    /// Called when the snapshot was drawn.
    void forgetChanges();
    /// Grows from frame to frame unless a frame shows the state of the frame before.
    [[nodiscard]] std::uint64_t revision() const;
    /// Exact where the sphere is at rest at the frame that was sought, [mesh unit].
    [[nodiscard]] const std::vector<Eigen::Vector3d>& centres() const;
    /// The same of the radii.
    [[nodiscard]] const std::vector<double>& radii() const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace frostfill
#pragma GCC visibility pop
