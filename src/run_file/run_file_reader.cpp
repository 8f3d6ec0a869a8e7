// SPDX-License-Identifier: MIT
#include "mesh/files/readers.hpp"
#include "run_file/file_of_run.hpp"
#include "run_file/frame_codec.hpp"
#include "run_file/mapped_file.hpp"
#include "run_file/records.hpp"

#include <frostfill/error.hpp>
#include <frostfill/run_file.hpp>

#include <fmt/format.h>

namespace frostfill
{
namespace
{

[[noreturn]] void refuse(const std::filesystem::path& file, std::string_view what)
{
    throw Error(ErrorCode::badData, fmt::format("'{}' {}", file.string(), what));
}

[[noreturn]] void refuseAsNoRunFile(std::string_view bytes)
{
    const std::string_view name = kRunFileMagic.substr(0, kRunFileVersionAt);
    if (bytes.size() <= kRunFileVersionAt || !bytes.starts_with(name))
    {
        throw DamagedBytes("is no run file (run.frost)");
    }
    throw DamagedBytes(
        fmt::format("is a run file of version {}, and this Frostfill reads version {}: fill "
                    "again, or use the Frostfill that wrote it",
                    static_cast<unsigned char>(bytes[kRunFileVersionAt]),
                    static_cast<unsigned char>(kRunFileMagic[kRunFileVersionAt])));
}

} // namespace

std::filesystem::path fileOfRun(const std::filesystem::path& run)
{
    std::error_code error;
    std::filesystem::path file = std::filesystem::is_directory(run, error) ? run / kRunFile : run;
    if (!std::filesystem::is_regular_file(file, error))
    {
        throw Error(ErrorCode::inputMissing,
                    fmt::format("'{}' is not there: give the directory of a run that was kept, or "
                                "its {}",
                                file.string(), kRunFile));
    }
    return file;
}

void requireFrames(const RunFileReader& reader, const std::filesystem::path& file)
{
    if (reader.frames().empty())
    {
        throw Error(ErrorCode::badData,
                    fmt::format("'{}' has no frame yet: its run was killed as it began; resume it "
                                "with frostfill fill --resume",
                                file.string()));
    }
}

struct RunFileReader::Implementation
{
    explicit Implementation(const std::filesystem::path& name) : file(name), mapped(name) {}

    void readHead(const Record& headRecord)
    {
        const std::string bytes = unpackRecord(headRecord);
        ByteReader in(bytes);
        in.raw(grid);
        for (double& coordinate : origin)
        {
            in.raw(coordinate);
        }
        head = bytes.substr(4 * sizeof(double));
        if (!(grid > 0) || !origin.allFinite())
        {
            throw DamagedBytes("has a grid that is not a number");
        }
    }

    /// Frames are unpacked when they are sought; here they are only counted.
    void read()
    {
        const std::string_view bytes = mapped.bytes();
        if (!bytes.starts_with(kRunFileMagic))
        {
            refuseAsNoRunFile(bytes);
        }
        std::vector<Record> all = wholeRecords(bytes);
        whole = kRunFileMagic.size();
        for (const Record& each : all)
        {
            whole += sizeof each.header + each.bytes.size();
        }
        if (all.size() < 2 || all[0].header.kind != RecordKind::head ||
            all[1].header.kind != RecordKind::mesh)
        {
            throw DamagedBytes("ends before its mesh: its run was killed as it began");
        }
        readHead(all[0]);
        mesh = parseMesh(unpackRecord(all[1]), "mesh.ply");
        if (all.back().header.kind == RecordKind::summary)
        {
            summary = unpackRecord(all.back());
        }
        for (const Record& each : all)
        {
            if (each.header.kind == RecordKind::frames)
            {
                for (const std::uint32_t number : frameNumbers(each))
                {
                    frames.push_back(number);
                }
                ends.push_back(frames.size());
                records.push_back(each);
            }
        }
        rewind();
    }

    void rewind()
    {
        decoder = FrameDecoder(grid, origin, mesh.triangles.size(), newSource());
        decoded = 0;
        record = 0;
        rest.reset();
    }

    void decodeNext()
    {
        if (!rest)
        {
            unpacked = unpackRecord(records[record]);
            rest = split(unpacked);
        }
        decoder->decode(*rest);
        ++decoded;
        if (decoded == ends[record])
        {
            ++record;
            rest.reset();
        }
    }

    std::filesystem::path file;
    MappedFile mapped;
    std::uint64_t whole = 0;
    double grid = 0;
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    std::string head;
    TriangleMesh mesh;
    std::vector<std::size_t> frames;
    std::optional<std::string> summary;
    std::vector<Record> records;   ///< of frames
    std::vector<std::size_t> ends; ///< by record: index of the frame after its last

    std::optional<FrameDecoder> decoder;
    std::size_t decoded = 0; ///< frames so far
    std::size_t record = 0;  ///< in which the next one is
    std::string unpacked;
    std::optional<StreamReaders> rest; ///< of `unpacked`
};

RunFileReader::RunFileReader(const std::filesystem::path& file)
    : implementation_(std::make_unique<Implementation>(file))
{
    try
    {
        implementation_->read();
    }
    catch (const DamagedBytes& damage)
    {
        refuse(file, damage.what());
    }
}

RunFileReader::~RunFileReader() = default;
RunFileReader::RunFileReader(RunFileReader&&) noexcept = default;
RunFileReader& RunFileReader::operator=(RunFileReader&&) noexcept = default;

const std::string& RunFileReader::head() const
{
    return implementation_->head;
}

const TriangleMesh& RunFileReader::mesh() const
{
    return implementation_->mesh;
}

const std::vector<std::size_t>& RunFileReader::frames() const
{
    return implementation_->frames;
}

const std::optional<std::string>& RunFileReader::summary() const
{
    return implementation_->summary;
}

std::uint64_t RunFileReader::wholeBytes() const
{
    return implementation_->whole;
}

std::uint64_t RunFileReader::fileBytes() const
{
    return implementation_->mapped.bytes().size();
}

const Snapshot& RunFileReader::seek(std::size_t index)
{
    Implementation& it = *implementation_;
    if (index >= it.frames.size())
    {
        refuse(it.file, fmt::format("has {} frames, and no frame {}", it.frames.size(), index));
    }
    if (index + 1 < it.decoded)
    {
        it.rewind();
    }
    try
    {
        while (it.decoded < index + 1)
        {
            it.decodeNext();
        }
        it.decoder->sortChanges();
    }
    catch (const DamagedBytes& damage)
    {
        refuse(it.file, damage.what());
    }
    return it.decoder->snapshot();
}

void RunFileReader::forgetChanges()
{
    implementation_->decoder->forgetChanges();
}

std::uint64_t RunFileReader::revision() const
{
    return implementation_->decoder->snapshot().revision;
}

const std::vector<Eigen::Vector3d>& RunFileReader::centres() const
{
    return implementation_->decoder->centres();
}

const std::vector<double>& RunFileReader::radii() const
{
    return implementation_->decoder->radii();
}

} // namespace frostfill
