// SPDX-License-Identifier: MIT
#include "run/quality_json.hpp"

namespace frostfill
{

nlohmann::ordered_json qualityJson(const QualityReport& quality)
{
    nlohmann::ordered_json json = {
        {"max_overlap_over_radius", quality.maxOverlap},
        {"mean_overlap_over_radius", quality.meanOverlap},
        {"max_wall_overlap_over_radius", quality.maxWallOverlap},
        {"centres_outside", quality.centresOutside},
        {"not_finite", quality.notFinite},
        {"unsupported_frozen", quality.unsupported},
        {"volume_mesh", quality.meshVolume},
        {"volume_spheres", quality.sphereVolume},
        {"packing_fraction",
         quality.meshVolume > 0 ? quality.sphereVolume / quality.meshVolume : 0}};
    if (const auto& joint = quality.equilibrium)
    {
        json["equilibrium"] = {
            {"friction", joint->friction},     {"at_rest", joint->spheres},
            {"unbalanced", joint->unbalanced}, {"largest_unbalance", joint->largest},
            {"settled", joint->settled},       {"least_friction", joint->leastFriction}};
    }
    return json;
}

} // namespace frostfill
