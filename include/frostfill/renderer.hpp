// SPDX-License-Identifier: MIT
// Room: the renderer as a program uses it: settings, pictures, passes. Its inner rooms are the
// folders of src/render.
#pragma once

#include <frostfill/image.hpp>
#include <frostfill/measure.hpp>
#include <frostfill/mesh.hpp>
#include <frostfill/snapshot.hpp>
#include <frostfill/view.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#pragma GCC visibility push(default)
namespace frostfill
{

struct RenderSettings
{
    PictureSize size;
    Camera camera;
    Style style;
    Backend backend = Backend::automatic;
    int samples = 4;                ///< samples per pixel; 1 for no antialiasing
    int supersample = 1;            ///< draw this many times wider and higher, then average
    ColourRange range;              ///< of the colour scale; the mesh gives the range of heights
    std::uint32_t groupsPerSet = 1; ///< for colours by set
    double unitsPerMetre = 1;       ///< for speeds in metres a second
    Eigen::Vector3d up = {0, 1, 0}; ///< unit vector that points up in the picture
    std::vector<Pose> poses;        ///< that must fit into the picture; empty: the mesh as it is
    std::string title;              ///< first line of the legend; may be empty
    bool staticLayer = true;        ///< keep spheres at rest from picture to picture; off gives the
                                    ///< same pictures, slower
};

/// Depth, normals and identities of the spheres in a picture. Same size and view; no legend.
struct PassPictures
{
    Image depth; ///< 16 bit: 0..65534 from `nearest` to `furthest` along the view; 65535 where
                 ///< there is no sphere
    double nearest = 0; ///< [mesh unit] from the eye's plane
    double furthest = 0;
    Image normal;   ///< RGB 0..255 for -1..1: right, up, towards the viewer; 128 where no sphere is
    Image identity; ///< id + 1 as R + 256 G + 65536 B; 0 where there is no sphere
    bool withIdentity = true; ///< else `identity` says nothing, and ids may have any size
};

/// Draws snapshots of one mesh without a screen. Use a renderer in one thread only.
class Renderer
{
public:
    /// Takes the mesh, after opening a context if OpenGL is to draw. Throws Error noOpenGl, which
    /// lists every attempt, or usage if the size is not between 1 and the limit of what draws.
    Renderer(const TriangleMesh& mesh, const RenderSettings& settings);
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    /// Draws one picture. The picture is valid until the next call.
    const Image& draw(const Snapshot& snapshot);
    /// [height] from the top: not 0 for rows of the last picture that may differ from the picture
    /// before.
    [[nodiscard]] std::span<const std::uint8_t> changedRows() const;

    /// Draws one picture into `image` and reuses its memory.
    void render(const Snapshot& snapshot, Image& image);

    /// Turns the camera about the up axis of the object, by an angle from its place in the settings
    /// [degree]. Stays in effect until the next call.
    void turn(double degrees);

    /// Draws depth, normals and identities for the picture that `render` makes of this snapshot.
    /// Throws Error usage if an identity is wanted and has more than 24 bits.
    void renderPasses(const Snapshot& snapshot, PassPictures& pictures);

    /// Changes the camera and undoes turn(). The kind of projection, parallel or perspective, must
    /// stay the same. Throws Error usage for a camera that makes no sense.
    void setCamera(const Camera& camera);

    /// What draws, on one line: the vendor, renderer and version of a context.
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
    std::string name; ///< of the `Backend` on the command line: "osmesa"
    bool works = false;
    std::string description; ///< renderer string, or the failure
    std::string remedy;      ///< the command that installs the missing package; empty if it works
};
[[nodiscard]] std::vector<BackendAttempt> probeBackends();

} // namespace frostfill
#pragma GCC visibility pop
