// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/framing.hpp"
#include "render/picture/surfaces.hpp"
#include "render/raster/spheres/sphere_raster.hpp"

#include <frostfill/image.hpp>

#include <array>
#include <vector>

namespace frostfill
{

/// Darkens pictures where neighbours keep off light that comes from all around. After [McGuire et
/// al. 2011], with a fixed pattern of samples, so that equal surfaces give equal bytes.
class AmbientOcclusion
{
public:
    /// `avx2` as lanes::hasAvx2().
    explicit AmbientOcclusion(bool avx2) : avx2_(avx2) {}

    /// Share of the light that reaches each pixel, 0..1, top row first: 1 where nothing is.
    /// Neighbours up to `reach` [unit space] away keep light off. Until the next call.
    const std::vector<float>& lightOn(const Surfaces& surfaces, const Framing& framing,
                                      double reach);
    /// Darkens a picture of the same size, RGB or RGBA.
    void darken(const Surfaces& surfaces, const Framing& framing, double reach, Image& image);

    /// What is the same all over a picture.
    struct Scene
    {
        const Surfaces& surfaces;
        PixelGrid grid; ///< rows upwards
        float reach;
        float pixelScale; ///< pixels in a length of 1 at distance 1, or at any without perspective
        std::vector<std::array<int, 2>> columns; ///< of each row between which there are surfaces
    };

private:
    void findLight(const Scene& scene);

    bool avx2_;
    std::vector<float> rough_; ///< before its noise is evened out
    std::vector<float> light_;
};

} // namespace frostfill
