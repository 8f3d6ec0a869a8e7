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
flat in vec4 centreAndCurvature;
flat in vec4 tintAndSteepness;
flat in vec4 hazeAndPixel;
flat in vec3 marks;

uniform float depthAtInfinity; // A0; perspective
uniform float depthSlope; // window depth over distance; orthographic
#ifdef SAMPLES
uniform vec2 samplePositions[SAMPLES]; // from the pixel's centre [pixel]
#endif

out vec4 colour;

const vec3 kHighlight = vec3(-0.234, 0.351, 0.907); // halfway between key light and viewer

#if defined(SAMPLES) && !defined(CUTAWAY)
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

#ifdef OUTLINES
uniform float outlineWidth; // [pixel]
#endif

#ifdef STUDIO
flat in vec4 occluder[12];
flat in vec2 openTo;

uniform vec3 lamp; // towards it
uniform vec3 above; // away from the ground

const float kSoftness = 0.3; // the lamp's half width, seen from anywhere

// What reaches a point of the sphere of the sky and of the lamp. Neighbours are spheres too, so that
// no rays are needed: what they hide of the sky is a power that fits the exact formula also where
// the horizon cuts them [Quilez 2014]; of a round lamp, it follows from how far the ray to its
// middle passes from their surface.
vec2 lightLeft(vec3 normal)
{
    vec2 left = openTo;
    for (int i = 0; i < 12; ++i)
    {
        vec3 way = occluder[i].xyz - normal;
        float radius = occluder[i].w;
        float squared = dot(way, way);
        float facing = clamp(0.5 * radius * (dot(normal, way) + radius) / squared, 0.0, 1.0);
        left.x *= 1.0 - 0.85 * facing * sqrt(facing);

        float ahead = dot(way, lamp);
        float beside = sqrt(max(squared - ahead * ahead, 0.0));
        float hidden = clamp(0.5 + (radius - beside) / (2.0 * kSoftness * abs(ahead) + 0.04), 0.0, 1.0);
        left.y *= ahead > 0.0 ? 1.0 - hidden : 1.0;
    }
    return left;
}

vec3 inStudio(vec3 normal)
{
    vec2 left = lightLeft(normal);
    float facing = dot(normal, lamp);
    float sky = mix(0.34, 0.66, 0.5 + 0.5 * dot(normal, above)) * left.x;
    float key = 0.74 * max(facing, 0.0) * left.y;
    // Light that has been to the neighbours and back has their colour, which is mostly the sphere's.
    vec3 tint = tintAndSteepness.rgb;
    vec3 ambient = sky * mix(tint, vec3(1.0), 0.04) * (1.0 + 0.25 * (1.0 - left.x) * tint);
    float gloss = max(dot(normal, normalize(lamp + vec3(0.0, 0.0, 1.0))), 0.0);
    gloss *= gloss;
    gloss *= gloss;
    gloss *= gloss;
    gloss *= gloss;
    return ambient + tint * key + 0.10 * gloss * left.y;
}
#endif

// Colour at a place of the sphere: `at` is where on the disc that is seen, `rhoSquared` 0 in its
// middle and 1 at its rim; `shade` is what keeps light from it.
vec3 shaded(vec3 normal, vec2 at, float rhoSquared, float shade)
{
    float pixel = hazeAndPixel.a;
#ifdef STUDIO
    vec3 lit = inStudio(normal);
    float light = 1.0;
#else
    vec3 lit = tintAndSteepness.rgb;
    float light = lightOn(normal) * shade;
#endif

    // The marks of all states, without branches: a software renderer runs every branch anyway. The
    // gloss is the 32nd power of the cosine to the highlight's middle.
    float ring = clamp((rhoSquared - 0.76) / (2.0 * pixel + 0.02) + 0.5, 0.0, 1.0);
    float hatch = stripes((at.x + at.y) * 1.3 + 0.25, kHatchShare, pixel * 1.84);
    float gloss = max(dot(normal, kHighlight), 0.0);
    gloss *= gloss;
    gloss *= gloss;
    gloss *= gloss;
    gloss *= gloss;
    gloss *= gloss;
    light *= 1.0 - marks.y * ring - marks.z * hatch;
#ifdef OUTLINES
    light *= 1.0 - 0.8 * clamp(outlineWidth - (1.0 - sqrt(rhoSquared)) / pixel + 0.5, 0.0, 1.0);
#endif
    return lit * light + marks.x * gloss + hazeAndPixel.rgb;
}

#ifdef CUTAWAY
uniform mat4 projection;

// Every sample for itself: a cut runs through the middle of pixels.
void main()
{
#ifdef SAMPLES
    vec2 offset = gl_SamplePosition - 0.5;
#else
    vec2 offset = vec2(0.0);
#endif
    vec2 at = corner + offset.x * dFdx(corner) + offset.y * dFdy(corner);
    vec3 q = onPlane + offset.x * dFdx(onPlane) + offset.y * dFdy(onPlane);
    float rhoSquared = dot(at, at);
    float w = sqrt(max(1.0 - rhoSquared, 0.0));
    float rise = tintAndSteepness.a * w;
#ifdef ORTHOGRAPHIC
    vec3 origin = q;
    vec3 direction = vec3(0.0, 0.0, -1.0);
    float enter = -rise;
    float leave = rise;
#else
    vec3 origin = vec3(0.0);
    vec3 direction = q;
    float enter = 1.0 / (1.0 + rise);
    float leave = 1.0 / (1.0 - rise);
#endif
    vec3 cap;
    bool seen = enterCutSphere(origin, direction, enter, leave, cap) && rhoSquared < 1.0;
    vec3 hit = origin + enter * direction;
#ifdef ORTHOGRAPHIC
    float depth = 0.5 * (projection[2][2] * hit.z + projection[3][2]) + 0.5;
#else
    float depth = depthAtInfinity - 0.5 * projection[3][2] / hit.z;
#endif
    gl_FragDepth = seen ? depth : 2.0;

    vec3 fromCentre = (hit - centreAndCurvature.xyz) * centreAndCurvature.w;
    if (cap == vec3(0.0))
    {
        colour = vec4(shaded(fromCentre, at, rhoSquared, 0.64 + 0.36 * min(1.7 * w, 1.0)), 1.0);
    }
    else
    {
        // The cut is matt and paler than the outside, with a rim that parts neighbours. Lengths are
        // in the sphere's radius: of the point from the disc's middle, and the disc's own radius.
        float height = dot(fromCentre, cap);
        float discSquared = 1.0 - height * height;
        float innerSquared = max(dot(fromCentre, fromCentre) - height * height, 0.0);
        float inside = sqrt(discSquared) - sqrt(innerSquared);
        float rim = clamp((inside - hazeAndPixel.a) / (hazeAndPixel.a + 0.02), 0.0, 1.0);
        vec3 tint = mix(tintAndSteepness.rgb, vec3(1.0), 0.34);
        float hatch = stripes((at.x + at.y) * 1.3 + 0.25, kHatchShare, hazeAndPixel.a * 1.84);
        float light = (0.80 + 0.15 * lightOn(cap)) * (1.0 - marks.z * hatch);
        light *= 1.0 - 0.7 * (1.0 - rim);
        light *= 1.0 - marks.y * clamp((innerSquared / discSquared - 0.6) / 0.06, 0.0, 1.0) * rim;
        colour = vec4(tint * light + hazeAndPixel.rgb, 1.0);
    }
}
#else
void main()
{
    float rhoSquared = dot(corner, corner);
    float w = sqrt(max(1.0 - rhoSquared, 0.0));

#ifdef SAMPLES
    gl_SampleMask[0] = samplesInside();
#endif

    float rise = tintAndSteepness.a * w;
#ifdef ORTHOGRAPHIC
    vec3 hit = onPlane + vec3(0.0, 0.0, rise);
    float depth = gl_FragCoord.z - depthSlope * rise;
#else
    vec3 hit = onPlane / (1.0 + rise);
    float depth = gl_FragCoord.z + (gl_FragCoord.z - depthAtInfinity) * rise;
#endif
#ifndef SAMPLES
    // Beyond the far plane is never drawn, and cheaper than `discard`.
    depth = rhoSquared < 1.0 ? depth : 2.0;
#endif
    gl_FragDepth = depth;

    // Neighbours keep light from each other's rims.
    vec3 normal = (hit - centreAndCurvature.xyz) * centreAndCurvature.w;
    colour = vec4(shaded(normal, corner, rhoSquared, 0.64 + 0.36 * min(1.7 * w, 1.0)), 1.0);
}
#endif
