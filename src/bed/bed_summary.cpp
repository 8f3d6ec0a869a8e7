// SPDX-License-Identifier: MIT
#include "bed/bed_summary.hpp"

#include "base/atomic_file.hpp"

namespace frostfill
{

nlohmann::ordered_json bedSummary(const Bed& bed)
{
    constexpr std::array<const char*, 3> kNames = {"none", "shrink", "caps"};
    const BedSettings& settings = bed.settings();
    nlohmann::ordered_json treatment = {
        {"name", kNames[static_cast<std::size_t>(settings.contacts)]}};
    if (settings.contacts == ContactTreatment::shrink)
    {
        treatment["factor"] = settings.factor;
    }
    else if (settings.contacts != ContactTreatment::none)
    {
        treatment["gap"] = settings.gap;
    }
    const Eigen::AlignedBox3d& box = bed.surface().box();
    const auto point = [](const Eigen::Vector3d& p) {
        return nlohmann::ordered_json{p.x(), p.y(), p.z()};
    };
    return {{"spheres", bed.size()},
            {"units_per_metre", bed.unitsPerMetre()},
            {"contacts", treatment},
            {"container_volume", bed.containerVolume()},
            {"container_box", {point(box.min()), point(box.max())}},
            {"mean_diameter", bed.meanDiameter()},
            {"porosity_exact", bed.porosity()}};
}

nlohmann::ordered_json surfaceSummary(const BedSurface& surface)
{
    nlohmann::ordered_json summary = bedSummary(surface.bed());
    summary["porosity_of_surface"] = surface.porosity();
    summary["free_volume"] = surface.freeVolume();
    summary["flattened"] = surface.links().links.size();
    summary["triangles"] = surface.triangles();
    const std::vector<BedPatch>& patches = surface.bed().patches();
    for (std::size_t patch = 0; patch < patches.size(); ++patch)
    {
        summary["triangles_of_patch"][patches[patch].name] = surface.triangles(patch);
    }
    return summary;
}

void writeSummary(const nlohmann::ordered_json& summary, const std::filesystem::path& file)
{
    AtomicFile out(file);
    out.write(summary.dump(2) + "\n");
    out.commit();
}

} // namespace frostfill
