// SPDX-License-Identifier: MIT
// Light outside the studio, and stripes.

// Of the lights of numbers.glsl, and of a sky whose light grows evenly from below to above, from the
// cosines of the angles between them and the normal.
INLINE real lightFrom(real up, real key, real fill, real back)
{
    return 0.56F + 0.13F * up + 0.50F * max(key, 0.0F) + 0.16F * max(fill, 0.0F)
           + 0.5F * max(back, 0.0F);
}

INLINE real lightOn(real3 normal)
{
    return lightFrom(normal.y, dot(normal, kKeyLight), dot(normal, kFillLight),
                     dot(normal, kBackLight));
}

// Coverage of stripes with period 1 and the given share of dark, antialiased over `width` periods.
// Stripes that are finer than pixels become their mean.
INLINE real stripes(real phase, float share, float width)
{
    real edge = abs(fract(phase) - 0.5F) - 0.5F * (1.0F - share);
    real crisp = clamp(edge * (1.0F / max(width, 1e-4F)) + 0.5F, 0.0F, 1.0F);
    return mix(crisp, share, clamp(2.5F * width - 0.75F, 0.0F, 1.0F));
}
