// SPDX-License-Identifier: MIT
#include "bed/bed_files.hpp"
#include "bed/head_space.hpp"
#include "export/exporter.hpp"

#include <frostfill/error.hpp>

#include <algorithm>
#include <utility>

namespace frostfill
{
namespace
{

/// The geometry of one frame: its spheres, wherever they move, in the container where it is then.
class BedExporter : public Exporter
{
public:
    BedExporter(ExportFormat format, const ExportedRun& run, std::filesystem::path folder)
        : format_(format), run_(run), folder_(std::move(folder))
    {
    }
    void add(const ExportedFrame& frame) override
    {
        std::vector<Eigen::Vector3d> centres;
        std::vector<double> radii;
        for (std::size_t k = 0; k < frame.state.states.size(); ++k)
        {
            if (!frame.state.waits(k))
            {
                centres.push_back(frame.centre(k));
                radii.push_back(frame.radii[k]);
            }
        }
        if (radii.empty())
        {
            throw Error(ErrorCode::badData, "the frame has no sphere yet");
        }
        BedContainer container{run_.mesh};
        for (const MeshPatch& patch : run_.patches)
        {
            container.partOf.resize(container.partOf.size() + patch.triangles,
                                    static_cast<std::uint32_t>(container.parts.size()));
            container.parts.push_back(patch.name);
        }
        container.partOf.resize(run_.mesh.triangles.size(), BedContainer::kNoPart);
        for (Eigen::Vector3d& vertex : container.mesh.vertices)
        {
            vertex = frame.inWorld(vertex);
        }
        double unitsPerMetre = run_.scene.object.unitsPerMetre;
        if (isInMetres(format_) && unitsPerMetre != 1)
        {
            const auto toMetres = [&](auto& length) { length /= unitsPerMetre; };
            std::for_each(container.mesh.vertices.begin(), container.mesh.vertices.end(), toMetres);
            std::for_each(centres.begin(), centres.end(), toMetres);
            std::for_each(radii.begin(), radii.end(), toMetres);
            unitsPerMetre = 1;
        }
        Eigen::Vector3d up = Eigen::Vector3d::Unit(run_.up);
        up = frame.moved ? Eigen::Vector3d(frame.state.pose.rotation * up) : up;
        if (format_ == ExportFormat::openFoam || format_ == ExportFormat::gmsh)
        {
            container = withoutHeadSpace(std::move(container), up, centres, radii);
        }
        const Bed bed(container, std::move(centres), std::move(radii), up, run_.bed, unitsPerMetre);
        switch (format_)
        {
        case ExportFormat::stlBed:
            return writeStlBed(bed, folder_, files_);
        case ExportFormat::openFoam:
            cells_ = writeOpenFoamCase(bed, folder_, files_);
            return;
        case ExportFormat::gmsh:
            cells_ = writeGmshBed(bed, folder_, files_);
            return;
        case ExportFormat::vti:
            return writeVti(bed, folder_, files_);
        default:
            return writeNpy(bed, folder_, files_);
        }
    }
    void finish() override {}
    [[nodiscard]] double cells() const override { return cells_; }

private:
    ExportFormat format_;
    double cells_ = 0;
    const ExportedRun& run_;
    std::filesystem::path folder_;
};

} // namespace

std::unique_ptr<Exporter> makeBedExporter(ExportFormat format, const ExportedRun& run,
                                          const std::filesystem::path& folder)
{
    return std::make_unique<BedExporter>(format, run, folder);
}

} // namespace frostfill
