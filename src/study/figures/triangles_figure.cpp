// SPDX-License-Identifier: MIT
#include "study/figures/all_figures.hpp"
#include "study/figures/embedded_scripts.hpp"
#include "study/operations/triangle_growth.hpp"

namespace frostfill
{
namespace
{

void makeTrianglesData(const FigureFolder& folder)
{
    if (folder.reuse("triangles.csv"))
    {
        return;
    }
    const auto progress = [&](std::size_t done, std::size_t all, const std::string& what)
    { folder.progress(done, all, what); };
    folder.write("triangles.csv",
                 triangleGrowthCsv(measureTriangleGrowth(folder.quick(), progress)));
}

} // namespace

Figure trianglesFigure()
{
    return {"triangles",
            "what triangles cost: loading, a sphere, a picture",
            true,
            120,
            makeTrianglesData,
            embedded::figure_triangles};
}

} // namespace frostfill
