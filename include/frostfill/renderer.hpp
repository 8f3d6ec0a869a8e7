// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/image.hpp>
#include <frostfill/measure.hpp>
#include <frostfill/mesh.hpp>
#include <frostfill/snapshot.hpp>
#include <frostfill/view.hpp>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace frostfill
{

struct RenderSettings
{
    PictureSize size;
    Camera camera;
    Style style;
    Backend backend = Backend::automatic;
    int samples = 4;                ///< samples a pixel; 1 for none
    int supersample = 1;            ///< draw so many times as wide and high, then average
    ColourRange range;              ///< of the colours; a range of heights follows from the mesh
    std::uint32_t groupsPerSet = 1; ///< for colours by set
    double unitsPerMetre = 1;       ///< for speeds in metres a second
    Eigen::Vector3d up = {0, 1, 0}; ///< unit vector that points up in the picture
    std::string title;              ///< first line of the legend; may be empty
};

/// What is seen in a picture beside colour, of the spheres alone. Same size and view; no legend.
struct PassPictures
{
    Image depth; ///< 16 bit: 0..65534 from `nearest` to `furthest` along the view; 65535 where
                 ///< there is no sphere
    double nearest = 0;               ///< [mesh unit] from the eye's plane
    double furthest = 0;
    Image normal;   ///< RGB 0..255 for -1..1: to the right, up, to the viewer; 128 where nothing is
    Image identity; ///< id + 1 as R + 256 G + 65536 B; 0 where there is no sphere
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

    /// Goes round the object with the camera about the up axis, by an angle from where the settings
    /// have it [degree]. Holds until the next call.
    void turn(double degrees);

    /// Draws what else is seen in the picture that `render` makes of the same snapshot.
    void renderPasses(const Snapshot& snapshot, PassPictures& pictures);

    /// Where the object is in the picture, as left, top, right, bottom [pixel]: all of it that the
    /// legend does not take.
    [[nodiscard]] std::array<int, 4> objectRegion() const;

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
    std::string name; ///< as `Backend` is named on the command line: "osmesa"
    bool works = false;
    std::string description; ///< renderer string, or what failed
    std::string remedy;      ///< the command that installs what is missing; empty when it works
};
[[nodiscard]] std::vector<BackendAttempt> probeBackends();

} // namespace frostfill
