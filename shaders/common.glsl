// SPDX-License-Identifier: MIT
// In front of every stage. Eye space: x to the right, y up in the picture, z towards the viewer.

// The numbers of SphereState and PolygonState.
const uint kRunning = 0u;
const uint kFrozen = 1u;
const uint kDiscarded = 2u;
const uint kDiscardedPolygon = 1u;

// Lights that stay with the camera: key from the upper left, fill from the right, and a sky whose
// light grows evenly from below to above. Directions to the light.
const vec3 kKeyLight = vec3(-0.424, 0.636, 0.645);
const vec3 kFillLight = vec3(0.802, 0.134, 0.582);

float lightOn(vec3 normal)
{
    return 0.58 + 0.13 * normal.y + 0.50 * max(dot(normal, kKeyLight), 0.0)
           + 0.14 * max(dot(normal, kFillLight), 0.0);
}

// Coverage of stripes with period 1 and the given share of dark, antialiased over `width` periods.
// Stripes that are finer than pixels become their mean.
float stripes(float phase, float share, float width)
{
    float edge = abs(fract(phase) - 0.5) - 0.5 * (1.0 - share);
    float crisp = clamp(edge / max(width, 1e-4) + 0.5, 0.0, 1.0);
    return mix(crisp, share, clamp(2.5 * width - 0.75, 0.0, 1.0));
}
