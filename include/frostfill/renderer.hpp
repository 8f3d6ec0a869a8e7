// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/image.hpp>
#include <frostfill/measure.hpp>
#include <frostfill/mesh.hpp>
#include <frostfill/snapshot.hpp>
#include <frostfill/view.hpp>

#include <memory>
#include <string>
#include <vector>

namespace frostfill
{

/// Which OpenGL to draw with.
enum class Backend
{
    automatic, ///< the first that works
    osmesa,
};

struct RenderSettings
{
    PictureSize size;
    Camera camera;
    Style style;
    Backend backend = Backend::automatic;
    int samples = 4;                ///< samples a pixel; 1 for none
    Eigen::Vector3d up = {0, 1, 0}; ///< unit vector that points up in the picture
    std::vector<Pose> poses;        ///< that have to fit into the picture; none: as the mesh is
    std::string title;              ///< first line of the legend; may be empty
};

/// Draws snapshots of one mesh without a screen. One renderer belongs to one thread.
class Renderer
{
public:
    /// Opens the context and uploads the mesh. Throws Error noOpenGl, which lists every attempt, or
    /// usage when the size is not between 1 and the context's limit.
    Renderer(const TriangleMesh& mesh, const RenderSettings& settings);
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    /// Draws one picture into `image`, whose memory is reused.
    void render(const Snapshot& snapshot, Image& image);

    /// Vendor, renderer and version strings of the context, on one line.
    [[nodiscard]] const std::string& description() const;

    /// Time spent so far in Stage::rendering and Stage::readback.
    [[nodiscard]] const StageTimes& times() const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// One attempt at opening a context, for `frostfill doctor`.
struct BackendAttempt
{
    std::string name; ///< "osmesa"
    bool works = false;
    std::string description; ///< renderer string, or what failed
    std::string remedy;      ///< the command that installs what is missing; empty when it works
};
[[nodiscard]] std::vector<BackendAttempt> probeBackends();

} // namespace frostfill
