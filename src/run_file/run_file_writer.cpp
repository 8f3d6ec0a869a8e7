// SPDX-License-Identifier: MIT
#include "base/atomic_file.hpp"
#include "run_file/frame_codec.hpp"
#include "run_file/records.hpp"

#include <frostfill/error.hpp>
#include <frostfill/run_file.hpp>

#include <fcntl.h>
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
constexpr std::size_t kFramesPerRecord = 32;
constexpr std::size_t kBytesPerRecord = std::size_t{1} << 20;

} // namespace

struct RunFileWriter::Implementation
{
    Implementation(double grid, const Eigen::Vector3d& origin, std::size_t polygons)
        : encoder({grid}, origin, polygons)
    {
    }
    ~Implementation()
    {
        if (descriptor >= 0)
        {
            close(descriptor);
        }
    }
    Implementation(const Implementation&) = delete;
    Implementation& operator=(const Implementation&) = delete;

    [[noreturn]] void refuse(int failure, std::size_t bytes) const
    {
        throw Error(ErrorCode::writeFailed, writeFailure(file, failure, bytes));
    }

    /// Opens a file that begins like this one; false for any other.
    bool reopen(std::string_view start)
    {
        descriptor = open(file.c_str(), O_RDWR | O_CLOEXEC);
        if (descriptor >= 0 && isThere(start))
        {
            at += static_cast<off_t>(start.size());
            return true;
        }
        if (descriptor >= 0)
        {
            close(std::exchange(descriptor, -1));
        }
        return false;
    }

    /// Whether the bytes are what the file has next.
    [[nodiscard]] bool isThere(std::string_view bytes) const
    {
        std::string there(bytes.size(), '\0');
        const ssize_t read = pread(descriptor, there.data(), there.size(), at);
        return read == static_cast<ssize_t>(bytes.size()) && there == bytes;
    }

    void write(std::string_view bytes)
    {
        if (continues && isThere(bytes))
        {
            at += static_cast<off_t>(bytes.size());
            return;
        }
        if (std::exchange(continues, false) &&
            (ftruncate(descriptor, at) != 0 || lseek(descriptor, at, SEEK_SET) != at))
        {
            refuse(errno, bytes.size());
        }
        append(bytes);
    }

    void append(std::string_view bytes) const
    {
        const int failure = writeAll(
            descriptor, {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
        if (failure != 0)
        {
            refuse(failure, bytes.size());
        }
    }

    void add(std::size_t frame)
    {
        numbers.push_back(static_cast<std::uint32_t>(frame));
        if (numbers.size() == kFramesPerRecord || encoder.bytes() >= kBytesPerRecord)
        {
            writeFrames();
        }
    }
    void writeFrames()
    {
        if (!numbers.empty())
        {
            write(packRecord(RecordKind::frames, numbers, joined(encoder.take())));
            numbers.clear();
        }
    }

    std::filesystem::path file;
    int descriptor = -1;
    bool continues = true; ///< what follows may be there already
    off_t at = 0;          ///< where, if it continues
    FrameEncoder encoder;
    std::vector<std::uint32_t> numbers; ///< of the frames that wait in the encoder
};

RunFileWriter::RunFileWriter(const std::filesystem::path& file, std::string_view head,
                             const TriangleMesh& mesh, double smallestRadius, EarlierFile earlier)
    : implementation_(std::make_unique<Implementation>(
          gridOf(smallestRadius), boundingBox(mesh).center(), mesh.triangles.size()))
{
    ByteWriter numbers;
    numbers.raw(gridOf(smallestRadius));
    const Eigen::Vector3d origin = boundingBox(mesh).center();
    for (const double coordinate : origin)
    {
        numbers.raw(coordinate);
    }
    numbers.bytes() += head;
    const std::string start = std::string(kRunFileMagic) +
                              packRecord(RecordKind::head, {}, numbers.bytes()) +
                              packRecord(RecordKind::mesh, {}, plyBytes(mesh));
    implementation_->file = file;
    if (earlier != EarlierFile::continued || !implementation_->reopen(start))
    {
        // A run file has a head from its first moment.
        AtomicFile fresh(file);
        fresh.write(start);
        fresh.commit();
        if (!implementation_->reopen(start))
        {
            implementation_->refuse(errno, start.size());
        }
    }
}

RunFileWriter::~RunFileWriter() = default;

void RunFileWriter::put(std::size_t frame, const Snapshot& snapshot, const ExactSphere& exact)
{
    // Spheres that run are kept where the snapshot has them.
    const auto pictured = [&](std::uint32_t id)
    {
        SphereRecord sphere = exact(id);
        if (snapshot.states[id] == SphereState::running)
        {
            sphere.centre = snapshot.origin + snapshot.centres[id].cast<double>();
        }
        return sphere;
    };
    implementation_->encoder.encode(snapshot, pictured);
    implementation_->add(frame);
}

void RunFileWriter::repeat(std::size_t frame)
{
    implementation_->encoder.repeat();
    implementation_->add(frame);
}

void RunFileWriter::flush()
{
    implementation_->writeFrames();
}

void RunFileWriter::finish(std::string_view summary)
{
    Implementation& it = *implementation_;
    it.writeFrames();
    it.write(packRecord(RecordKind::summary, {}, summary));
    int failure = it.continues && ftruncate(it.descriptor, it.at) != 0 ? errno : 0;
    failure = failure != 0 ? failure : syncFile(it.descriptor);
    const int atEnd = closeFile(std::exchange(it.descriptor, -1));
    failure = failure != 0 ? failure : atEnd;
    if (failure != 0)
    {
        it.refuse(failure, 0);
    }
}

} // namespace frostfill
