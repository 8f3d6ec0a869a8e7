// SPDX-License-Identifier: MIT
#include "export/glb_animation.hpp"
#include "export/glb_file.hpp"
#include "export/sphere_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string>

namespace frostfill
{
namespace
{

using Json = GlbFile::Json;

/// Columns that neither place nor shape nor colour shows: the carried ones. glTF wants the names of
/// a program's own attributes in capitals behind a line.
ColumnList extraColumns(const Snapshot& state)
{
    return without(exportedColumns(state),
                   [](const Column& column) { return !column.isCarried(); });
}

std::string attributeName(const Column& column)
{
    std::string name = "_" + column.name;
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return name;
}

/// The packing of the last frame: a node a state, with an instance a sphere. Viewers that do not
/// know the extension refuse the file rather than show three balls.
class InstancedExporter : public Exporter
{
public:
    InstancedExporter(const ExportedRun& run, std::filesystem::path file)
        : run_(run), name_(std::move(file))
    {
        files_.push_back(name_);
    }
    void add(const ExportedFrame& frame) override
    {
        GlbFile file;
        file.json()["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
        file.json()["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
        addBalls(file);
        Json& nodes = file.json()["nodes"] = Json::array();
        Json children = Json::array();
        addShell(file, run_, frame.state.origin, children);
        const ColumnList columns = extraColumns(frame.state);
        for (std::size_t state = 0; state < 3; ++state)
        {
            std::vector<float> places;
            std::vector<float> sizes;
            std::vector<std::vector<float>> extras(columns.size());
            for (std::size_t i = 0; i < frame.state.states.size(); ++i)
            {
                if (static_cast<std::size_t>(frame.state.states[i]) == state)
                {
                    const Eigen::Vector3d p = frame.centres[i] - frame.state.origin;
                    for (int axis = 0; axis < 3; ++axis)
                    {
                        places.push_back(static_cast<float>(p[axis]));
                        sizes.push_back(static_cast<float>(frame.radii[i]));
                    }
                    for (std::size_t k = 0; k < columns.size(); ++k)
                    {
                        const double value = frame.state.values(*columns[k])->at(i);
                        extras[k].push_back(static_cast<float>(value));
                    }
                }
            }
            if (places.empty())
            {
                continue;
            }
            const std::size_t count = places.size() / 3;
            Json node = {{"name", fmt::format("spheres of state {}", state)}, {"mesh", state}};
            const auto attribute = [&](const std::vector<float>& values, const char* type) {
                return file.addAccessor(file.addView(values), 0, GlbFile::Kind::float32, count,
                                        type);
            };
            Json& attributes = node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
            attributes = {{"TRANSLATION", attribute(places, "VEC3")},
                          {"SCALE", attribute(sizes, "VEC3")}};
            for (std::size_t k = 0; k < columns.size(); ++k)
            {
                attributes[attributeName(*columns[k])] = attribute(extras[k], "SCALAR");
            }
            children.push_back(nodes.size());
            nodes.push_back(node);
        }
        addObject(file, run_, frame, children);
        file.write(name_);
    }
    void finish() override {}

private:
    const ExportedRun& run_;
    std::filesystem::path name_;
};

/// Each sphere is a node, so that every reader shows it, and so that it can move.
class AnimatedExporter : public Exporter
{
public:
    AnimatedExporter(const ExportedRun& run, std::filesystem::path file)
        : run_(run), name_(std::move(file))
    {
        files_.push_back(name_);
    }
    void add(const ExportedFrame& frame) override
    {
        animation_.add(frame);
        if (animation_.frames() == run_.numbers.size())
        {
            write(frame);
        }
    }
    void finish() override {}

private:
    void write(const ExportedFrame& last)
    {
        GlbFile file;
        addBalls(file);
        Json& nodes = file.json()["nodes"] = Json::array();
        Json children = Json::array();
        const ColumnList columns = extraColumns(last.state);
        for (std::size_t i = 0; i < last.radii.size(); ++i)
        {
            const Eigen::Vector3d p = last.centres[i] - last.state.origin;
            const double r = last.radii[i];
            children.push_back(i);
            nodes.push_back({{"name", fmt::format("sphere {}", i)},
                             {"mesh", static_cast<std::size_t>(last.state.states[i])},
                             {"translation", {p.x(), p.y(), p.z()}},
                             {"scale", {r, r, r}}});
            for (const Column* column : columns)
            {
                nodes.back()["extras"][column->name] = last.state.values(*column)->at(i);
            }
        }
        addShell(file, run_, last.state.origin, children);
        const std::size_t object = addObject(file, run_, last, children);
        animation_.addTo(file, last.radii, object);
        file.write(name_);
    }

    const ExportedRun& run_;
    std::filesystem::path name_;
    GlbAnimation animation_;
};

} // namespace

std::unique_ptr<Exporter> makeGlbExporter(const ExportedRun& run,
                                          const std::filesystem::path& folder)
{
    return std::make_unique<AnimatedExporter>(run, folder / "run.glb");
}

std::unique_ptr<Exporter> makeGlbInstancedExporter(const ExportedRun& run,
                                                   const std::filesystem::path& folder)
{
    return std::make_unique<InstancedExporter>(run, folder / "packing.glb");
}

} // namespace frostfill
