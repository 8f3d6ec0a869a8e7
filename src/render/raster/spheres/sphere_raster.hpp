// SPDX-License-Identifier: MIT
// Room: spheres in tiles, with the light and the shadows between them, the walls and the ground.
#pragma once

#include "render/framing/numbers.hpp"
#include "render/picture/projected_sphere.hpp"
#include "render/picture/sphere_instance.hpp"
#include "render/raster/lanes/sample_tile.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace frostfill
{

/// From pixels to what is seen there. Of the point where pixel (x, y) meets the plane at distance 1
/// ahead, or without perspective of the place itself: left + perColumn * x, bottom + perRow * y.
struct PixelGrid
{
    bool orthographic = false;
    float left = 0;
    float bottom = 0;
    float perColumn = 0;
    float perRow = 0;
};

[[nodiscard]] PixelGrid pixelGrid(const glm::mat4& projection, bool orthographic,
                                  const PictureSize& size);

/// Draws spheres as sphere.vert and sphere.frag do, which have the mathematics. As there, depth and
/// colour are those of a pixel's middle for all its samples.
class SphereRaster
{
public:
    /// Plane of a tile's colours that identities are left in.
    static constexpr std::size_t kIdentities = 1;

    /// How SpherePass draws, for a size of the picture.
    SphereRaster(const SphereUniforms& uniforms, const ShaderVariant& variant,
                 const PictureSize& size, const Style& style, float lineWidth, int samples);
    /// For what spheres are and not how they look: one sample a pixel, for its colour where the
    /// sphere faces, and in another plane what SphereInstance::colour has, as a word.
    [[nodiscard]] static SphereRaster ofSurfaces(const SphereUniforms& uniforms,
                                                 const ShaderVariant& variant,
                                                 const PictureSize& size);

    /// `pixels` is the sphere's rectangle in the picture. `light`: with ambient occlusion.
    void draw(const SphereInstance& sphere, const PixelRectangle& pixels, const TilePart& part,
              SampleTile& tile, const SphereLight* light = nullptr) const;

    /// Whether the cutaway takes it away.
    [[nodiscard]] bool takesAway(const SphereInstance& sphere) const
    {
        return leftOf(sphere) == CutShare::nothing;
    }
    /// An upper bound of the inverse depth of the sphere's points; see kNothing.
    [[nodiscard]] float nearest(const SphereInstance& sphere) const;

    /// What is constant over one sphere. Let dx, dy be pixels from its middle, D the ray, C the
    /// centre, and R and A unit vectors to the right and upwards in the plane of the outline:
    struct Setup
    {
        float x, y;                  ///< its middle in the picture [pixel]
        float acrossX;               ///< K D.R = acrossX dx
        float aboveX, aboveY;        ///< K D.A = aboveX dx + aboveY dy
        float along, alongX, alongY; ///< D.C = along + alongX dx + alongY dy
        /// D.C between which the outline's plane is as far away as OpenGL shows anything
        float leastAlong, mostAlong;
        float radiusOverDistance; ///< e; 0 without perspective
        float nearScale, rise;    ///< inverse depth = q + (q e + rise) w, q = D.C nearScale
        /// Coefficients of the dot product of the normal with a direction: of (e + w) t, and of the
        /// two coordinates in the outline times t, where t = 1 / (1 + e w).
        struct Slope
        {
            float axis, right, above;
        };
        Slope up, key, fill, back, highlight;
        Slope stripe;             ///< to what the stripe is square to
        shading::SphereLook look; ///< [0..255]
        float outline;            ///< its width, for print
        std::array<float, kMaxTileSamples> acrossAt, aboveAt, alongAt; ///< from a pixel's middle
    };

    /// Occlusion by neighbours, and the lamp of the studio. Lengths are in the radius.
    struct Lighting
    {
        struct Occluder
        {
            Setup::Slope way; ///< to its centre
            float squared;    ///< of the way's length, and 1
            float radius;
            float ahead; ///< of the way, towards the lamp
        };
        std::array<Occluder, SphereLight{}.occluders.size()> occluders;
        std::size_t count; ///< of occluders that are there
        float sky, lamp;   ///< what all others let through
        Setup::Slope towardsLamp, up, gloss;
    };

    /// What a cutaway adds to a sphere of which it leaves a part.
    struct Cut
    {
        /// How deep in what is taken away, positive: `start` + t `growth`, with t the way along the
        /// ray: 1 in the plane of the outline, or without perspective from there towards it.
        /// Either changes evenly over the outline.
        struct Plane
        {
            float start, startAcross, startAbove;
            float growth, growthAcross, growthAbove;
            float heightSquared; ///< of the plane above the centre, in its radius
            float light;         ///< on the cut
        };
        std::array<Plane, 2> planes;
        bool orthographic;
        float radius;
        float shrink; ///< the outline's radius in the sphere's
    };

    /// What of a surface is drawn that is not shaded.
    struct Surface
    {
        Setup::Slope right, up, towards;
        std::uint32_t identity;
        std::array<std::uint32_t, 2> ofCut; ///< as colours, where the planes of a cut face
    };

    /// What one sphere is drawn with; null for what it does not have.
    struct Drawn
    {
        const Setup& setup;
        const Lighting* lighting;
        const Cut* cut;
        const Surface* surface;
        bool print, studio;
    };

private:
    /// Unit vectors in eye space: to the centre, and in the plane of the circle.
    struct Axes
    {
        glm::vec3 axis{0, 0, -1};
        glm::vec3 right{1, 0, 0};
        glm::vec3 above{0, 1, 0};
        float shrink = 1; ///< the circle's radius in the sphere's

        [[nodiscard]] Setup::Slope slope(const glm::vec3& way) const;
    };

    /// False when it cannot be seen.
    bool setUp(const SphereInstance& sphere, Axes& axes, Setup& setup) const;
    void setColours(const SphereInstance& sphere, const glm::vec3& centre, const Axes& axes,
                    Setup& setup) const;
    void setLighting(const SphereLight& light, const Axes& axes, Lighting& lighting) const;
    void setCut(const SphereInstance& sphere, const Axes& axes, Cut& cut) const;
    [[nodiscard]] Surface surfaceOf(const SphereInstance& sphere, const Axes& axes) const;
    [[nodiscard]] CutShare leftOf(const SphereInstance& sphere) const
    {
        return cutaway_ ? cutShareOf(sphere, uniforms_) : CutShare::whole;
    }
    [[nodiscard]] glm::vec3 centreOf(const SphereInstance& sphere) const;

    SphereUniforms uniforms_;
    PixelGrid grid_;
    bool cutaway_;
    bool print_, studio_;
    bool surfaces_ = false;
    float outline_;        ///< [pixel] for print
    glm::vec3 background_; ///< [0..1]
    int samples_;
    std::array<float, 2> shown_; ///< distances ahead between which outlines are, as OpenGL clips
};

/// Where a sphere may be seen in the picture, and how near it comes.
struct SphereBounds
{
    PixelRectangle pixels;
    float nearest = 0;
};

/// How spheres come into the picture, from where the camera is.
struct TileView
{
    SphereRaster raster;
    SphereProjector projector;

    [[nodiscard]] SphereBounds place(const SphereInstance& sphere) const
    {
        return raster.takesAway(sphere)
                   ? SphereBounds{}
                   : SphereBounds{projector.project(sphere).pixels, raster.nearest(sphere)};
    }
};

} // namespace frostfill
