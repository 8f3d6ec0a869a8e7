// SPDX-License-Identifier: MIT
#include "export/sphere_columns.hpp"
#include "run_file/bytes.hpp"

#include <type_traits>

namespace frostfill
{
namespace
{

constexpr auto kColumns = std::tuple_cat(kPlaceColumns, kPointColumns);
constexpr std::size_t kMostBytes = sizeof(ExportedSphere); ///< of a row

template <typename Value>
constexpr const char* typeName()
{
    return std::is_same_v<Value, double>          ? "double"
           : std::is_same_v<Value, float>         ? "float"
           : std::is_same_v<Value, std::uint32_t> ? "uint"
                                                  : "uchar";
}

/// A PLY file whose vertices are the centres of the spheres, binary and little-endian.
class PlyExporter : public Exporter
{
public:
    PlyExporter(const ExportedRun& run, std::filesystem::path folder)
        : run_(run), folder_(std::move(folder))
    {
    }
    void add(const ExportedFrame& frame) override
    {
        const std::size_t count = frame.state.states.size();
        std::string head =
            fmt::format("ply\nformat binary_little_endian 1.0\ncomment frame {} at {} "
                        "s\nelement vertex {}\n",
                        frame.number, frame.state.time, count);
        forEachColumn(kColumns, [&]<typename Value>(const ExportColumn<Value>& column)
                      { head += fmt::format("property {} {}\n", typeName<Value>(), column.name); });
        ByteWriter rows;
        rows.bytes().reserve(count * kMostBytes);
        for (std::size_t i = 0; i < count; ++i)
        {
            const ExportedSphere sphere = sphereOf(run_, frame, i);
            forEachColumn(kColumns, [&](const auto& column) { rows.raw(sphere.*column.value); });
        }
        files_.push_back(folder_ / numberedName("spheres", frame.number, "ply"));
        AtomicFile file(files_.back());
        file.write(head + "end_header\n");
        file.write(rows.bytes());
        file.commit();
    }
    void finish() override {}

private:
    const ExportedRun& run_;
    std::filesystem::path folder_;
};

} // namespace

std::unique_ptr<Exporter> makePlyExporter(const ExportedRun& run,
                                          const std::filesystem::path& folder)
{
    return std::make_unique<PlyExporter>(run, folder);
}

} // namespace frostfill
