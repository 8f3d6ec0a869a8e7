// SPDX-License-Identifier: MIT
// Where the ray through a point of the square hits the sphere, exactly and without a quadratic.
//
// With rho the distance from the circle's centre in its radius and w = sqrt(1 - rho^2), Q = M + s
// rho (unit vector in the plane), M perpendicular to the plane:
//     Q.C   = |M| d = d^2 (1 - e^2)
//     |Q|^2 = |M|^2 + s^2 rho^2 = d^2 (1 - e^2) (1 - e^2 + e^2 rho^2) = d^2 (1 - e^2) (1 - e^2 w^2)
// The hit P = t Q has |P - C| = r:  t^2 |Q|^2 - 2 t Q.C + d^2 - r^2 = 0. Every term holds the factor
// d^2 (1 - e^2); without it
//     t^2 (1 - e^2 w^2) - 2 t + 1 = 0,   so   t = (1 -+ e w) / (1 - e^2 w^2);   nearer: 1 / (1 + e w).
// Window depth is z = A0 + B / P.z with A0 its value at infinity, so dividing P by 1 + e w multiplies
// z - A0 by it:
//     P = Q / (1 + e w),    z = z_q + (z_q - A0) e w.
// Nothing is subtracted that nearly cancels: as exact for a distant sphere as for a near one.
//
// Orthographic: P = Q + r w towards the viewer, and the window depth falls in proportion.

in vec2 corner;
in vec3 onPlane;
flat in vec3 centre;
flat in float radius;
flat in float steepness;
flat in uint state;

uniform float depthAtInfinity; // A0; perspective
uniform float depthSlope; // window depth over distance; orthographic
uniform vec4 stateColours[3];
uniform vec4 background;
uniform vec4 heightPlane; // height in the object, 0 at its foot and 1 at its top, of an eye-space point
uniform vec4 distancePlane; // the same for the distance: 0 at the front, 1 at the back
uniform float haze; // share of the background in the furthest spheres
#ifdef SAMPLES
uniform vec2 samplePositions[SAMPLES]; // from the pixel's centre [pixel]
#endif

out vec4 colour;

#ifdef SAMPLES
// Which of the pixel's samples lie inside the outline. Depth and colour are those of the centre, so
// smooth outlines cost no more shading than jagged ones.
int samplesInside()
{
    vec2 dx = dFdx(corner);
    vec2 dy = dFdy(corner);
    int mask = 0;
    for (int i = 0; i < SAMPLES; ++i)
    {
        vec2 at = corner + samplePositions[i].x * dx + samplePositions[i].y * dy;
        mask |= dot(at, at) < 1.0 ? 1 << i : 0;
    }
    return mask;
}
#endif

// Colour alone does not tell the states apart for everyone. Running spheres are glossy with a dark
// ring, discarded ones are hatched, frozen ones are plain.
vec3 markOfState(vec3 lit, float rho, vec3 normal, float pixel)
{
    if (state == kRunning)
    {
        float gloss = pow(max(dot(normal, normalize(kKeyLight + vec3(0.0, 0.0, 1.0))), 0.0), 36.0);
        float ring = clamp((rho - 0.86) / max(pixel, 0.02) + 0.5, 0.0, 1.0);
        return mix(lit + 0.65 * gloss, 0.25 * lit, 0.85 * ring);
    }
    if (state == kDiscarded)
    {
        float dark = stripes((corner.x + corner.y) * 1.3 + 0.25, 0.34, pixel * 1.84);
        return lit * (1.0 - 0.42 * dark);
    }
    return lit;
}

void main()
{
    float rhoSquared = dot(corner, corner);
    float w = sqrt(max(1.0 - rhoSquared, 0.0));
    // Length of a pixel in the sphere's radius.
    float pixel = length(vec2(dFdx(corner.x), dFdy(corner.x)));

#ifdef SAMPLES
    gl_SampleMask[0] = samplesInside();
#endif

#ifdef ORTHOGRAPHIC
    vec3 hit = onPlane + vec3(0.0, 0.0, radius * w);
    float depth = gl_FragCoord.z - depthSlope * radius * w;
#else
    vec3 hit = onPlane / (1.0 + steepness * w);
    float depth = gl_FragCoord.z + (gl_FragCoord.z - depthAtInfinity) * steepness * w;
#endif
#ifndef SAMPLES
    // Beyond the far plane is never drawn, and cheaper than `discard`.
    depth = rhoSquared < 1.0 ? depth : 2.0;
#endif
    gl_FragDepth = depth;

    vec3 normal = normalize(hit - centre);
    // Neighbours keep light from each other's rims, and from the foot of a pile more than its top.
    float crevice = 0.62 + 0.38 * min(1.6 * w, 1.0);
    float foot = 0.84 + 0.16 * clamp(dot(heightPlane, vec4(hit, 1.0)), 0.0, 1.0);
    vec3 lit = stateColours[state].rgb * threeLights(normal) * crevice * foot;
    lit = markOfState(lit, sqrt(rhoSquared), normal, pixel);
    float far = clamp(dot(distancePlane, vec4(hit, 1.0)), 0.0, 1.0);
    colour = vec4(mix(lit, background.rgb, haze * far), 1.0);
}
