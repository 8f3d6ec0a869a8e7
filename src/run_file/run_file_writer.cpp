// SPDX-License-Identifier: MIT
#include "base/posix_file.hpp"
#include "run_file/frame_codec.hpp"
#include "run_file/records.hpp"

#include <frostfill/error.hpp>
#include <frostfill/run_file.hpp>

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace frostfill
{
namespace
{

/// A record is written once it has so many frames or bytes. Fewer: it packs less well. More: a kill
/// loses more.
constexpr std::size_t kFramesInARecord = 32;
constexpr std::size_t kBytesInARecord = std::size_t{1} << 20;

} // namespace

struct RunFileWriter::Implementation
{
    Implementation(std::filesystem::path name, double grid) : file(std::move(name)), encoder(grid)
    {
    }

    void write(std::string_view bytes)
    {
        const int failure = writeAll(
            descriptor, {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
        if (failure != 0)
        {
            throw Error(ErrorCode::writeFailed, writeFailure(file, failure, bytes.size()));
        }
    }
    void writeFrames()
    {
        if (!numbers.empty())
        {
            write(packRecord(RecordKind::frames, numbers, waiting.bytes()));
        }
        waiting.bytes().clear();
        numbers.clear();
    }

    std::filesystem::path file;
    int descriptor = -1;
    FrameEncoder encoder;
    ByteWriter waiting;
    std::vector<std::uint32_t> numbers; ///< of the frames that wait
};

RunFileWriter::RunFileWriter(const std::filesystem::path& file, std::string_view head,
                             const TriangleMesh& mesh, double smallestRadius)
    : implementation_(std::make_unique<Implementation>(file, gridOf(smallestRadius)))
{
    unlink(file.c_str()); // of a run that is overwritten
    implementation_->descriptor = createNewFile(file);
    if (implementation_->descriptor < 0)
    {
        throw Error(ErrorCode::cannotCreate,
                    fmt::format("cannot create '{}': {}", file.string(), std::strerror(errno)));
    }
    implementation_->write(kRunFileMark);
    ByteWriter bytes;
    bytes.raw(gridOf(smallestRadius));
    const Eigen::Vector3d origin = boundingBox(mesh).center();
    for (int axis = 0; axis < 3; ++axis)
    {
        bytes.raw(origin[axis]);
    }
    bytes.bytes() += head;
    implementation_->write(packRecord(RecordKind::head, {}, bytes.bytes()));
    implementation_->write(packRecord(RecordKind::mesh, {}, plyBytes(mesh)));
}

RunFileWriter::~RunFileWriter()
{
    if (implementation_->descriptor >= 0)
    {
        close(implementation_->descriptor);
    }
}

void RunFileWriter::put(std::size_t frame, Snapshot& snapshot, const Exact& exact)
{
    implementation_->encoder.encode(snapshot, exact, implementation_->waiting);
    implementation_->numbers.push_back(static_cast<std::uint32_t>(frame));
    if (implementation_->numbers.size() == kFramesInARecord ||
        implementation_->waiting.bytes().size() >= kBytesInARecord)
    {
        implementation_->writeFrames();
    }
}

void RunFileWriter::finish(std::string_view summary)
{
    implementation_->writeFrames();
    implementation_->write(packRecord(RecordKind::summary, {}, summary));
    int failure = syncFile(implementation_->descriptor);
    const int atEnd = closeFile(std::exchange(implementation_->descriptor, -1));
    failure = failure != 0 ? failure : atEnd;
    if (failure != 0)
    {
        throw Error(ErrorCode::writeFailed, writeFailure(implementation_->file, failure, 0));
    }
}

} // namespace frostfill
