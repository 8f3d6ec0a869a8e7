// SPDX-License-Identifier: MIT
// Spheres in the studio. Neighbours are spheres too, so that no rays are needed. Lengths are in the
// radius of the sphere that is lit; `squared` is the square of the way from the point of its surface
// to the neighbour's centre.

const float kSkyLight = 0.5F; // on what is level
const float kLampLight = 0.74F; // on what faces it

// What a neighbour leaves of the sky: a power that fits the exact formula also where the horizon cuts
// it [Quilez 2014]. `along` is the way from the own centre to the neighbour's, along the normal.
INLINE real skyPast(real along, float radius, real squared)
{
    real share = clamp(0.5F * radius * (along + (radius - 1.0F)) / squared, 0.0F, 1.0F);
    return 1.0F - 0.85F * share * sqrt(share);
}

// What it leaves of a round lamp follows from how far the ray to the lamp's middle passes from its
// surface. `ahead` is the way from the point, towards the lamp.
INLINE real lampPast(real ahead, float radius, real squared)
{
    real beside = sqrt(max(squared - ahead * ahead, 0.0F));
    real hidden = clamp(
        0.5F + (radius - beside) / (2.0F * kLampSoftness * max(ahead, 0.0F) + 0.04F), 0.0F, 1.0F);
    return select(ahead > 0.0F, 1.0F - hidden, 1.0F);
}

// Colour of a sphere in the light of `sky` and `lamp`, the shares that all neighbours leave, from the
// cosines of the angles between its normal and what is above, the lamp, and the middle of its gloss.
INLINE real3 inStudio(vec3 tint, real up, real facing, real shiny, real sky, real lamp)
{
    real fromSky = (kSkyLight + 0.16F * up) * sky;
    real key = kLampLight * max(facing, 0.0F) * lamp;
    real shine = power16(max(shiny, 0.0F)) * (0.10F * kWhite * lamp);
    // Light that has been to the neighbours and back has their colour, which is mostly the sphere's.
    real returned = (0.25F / kWhite) * (1.0F - sky);
    real3 ambient = fromSky * mix(tint, vec3(kWhite), 0.04F) * (1.0F + returned * tint);
    return ambient + tint * key + shine;
}
