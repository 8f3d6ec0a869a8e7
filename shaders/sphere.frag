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
flat in vec4 marks;
flat in vec3 stripeAxis;

uniform float depthAtInfinity; // A0; perspective
uniform float depthSlope; // window depth over distance; orthographic
#ifdef SAMPLES
uniform vec2 samplePositions[SAMPLES]; // from the pixel's centre [pixel]
#endif

#ifdef SURFACES
// Which sphere a pixel shows, where its surface faces, and how far it is.
flat in vec4 identity;

layout(location = 0) out vec4 normalColour;
layout(location = 1) out vec4 identityColour;
#else
out vec4 colour;
#endif

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

#ifdef OCCLUSION
flat in vec4 occluder[12];
flat in vec2 openTo;

uniform vec3 lamp; // towards it
uniform vec3 above; // away from the ground

// What neighbours leave of the sky and of the lamp. What is not there has no radius, and hides nothing.
vec2 lightPastNeighbours(vec3 normal)
{
    vec2 left = openTo;
    for (int i = 0; i < 12; ++i)
    {
        vec3 way = occluder[i].xyz;
        float radius = occluder[i].w;
        float along = dot(normal, way);
        float squared = dot(way, way) + 1.0 - 2.0 * along;
        left.x *= skyPast(along, radius, squared);
#ifdef STUDIO
        left.y *= lampPast(dot(way - normal, lamp), radius, squared);
#endif
    }
    return left;
}
#endif

SphereLook look()
{
    SphereLook own;
    own.tint = tintAndSteepness.rgb;
    own.haze = hazeAndPixel.rgb;
    own.pixel = hazeAndPixel.a;
    own.gloss = marks.x;
    own.ring = marks.y;
    own.hatch = marks.z;
    own.stripe = marks.w;
    return own;
}

// Colour at a place of the sphere: `at` is where on the disc that is seen. The marks of all states
// are drawn without branches: a software renderer runs every branch anyway.
vec3 shaded(vec3 normal, vec2 at, float rhoSquared, float w)
{
    SphereLook own = look();
#ifdef STUDIO
    vec2 left = lightPastNeighbours(normal);
    vec3 lit = inStudio(own.tint, dot(normal, above), dot(normal, lamp),
                        dot(normal, normalize(lamp + vec3(0.0, 0.0, 1.0))), left.x, left.y);
#else
    vec3 lit = own.tint * (lightOn(normal) * lightNearRim(w));
#ifdef OCCLUSION
    lit *= lightPastNeighbours(normal).x;
#endif
#endif
    float unhidden =
        unmarked(own, rhoSquared, at.x + at.y) * unstriped(own, dot(normal, stripeAxis));
#ifdef OUTLINES
    unhidden *= unlined(own, rhoSquared, outlineWidth);
#endif
    return lit * unhidden + own.haze + glossOf(own, dot(normal, kHighlight));
}

#if defined(CUTAWAY) || defined(SURFACES)
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
    bool seen = rhoSquared < 1.0;
#ifdef CUTAWAY
    CutMeeting met = meetCutPlanes(origin, direction, enter, leave);
    seen = met.isThere && seen;
    enter = met.t;
#endif
    vec3 hit = origin + enter * direction;
#ifdef ORTHOGRAPHIC
    float depth = 0.5 * (projection[2][2] * hit.z + projection[3][2]) + 0.5;
#else
    float depth = depthAtInfinity - 0.5 * projection[3][2] / hit.z;
#endif
    gl_FragDepth = seen ? depth : 2.0;

    vec3 fromCentre = (hit - centreAndCurvature.xyz) * centreAndCurvature.w;
#ifdef CUTAWAY
    vec3 cap = normalize(cutPlanes[met.onSecond ? 1 : 0].xyz);
#endif
#if defined(SURFACES) && defined(CUTAWAY)
    fromCentre = met.capped ? cap : fromCentre;
#endif
#ifdef SURFACES
    normalColour = vec4(0.5 + 0.5 * fromCentre, 1.0);
    identityColour = identity;
#else
    if (met.capped)
    {
        float height = dot(fromCentre, cap);
        colour = vec4(onCut(look(), lightOn(cap), dot(fromCentre, fromCentre), height * height,
                            at.x + at.y),
                      1.0);
    }
    else
    {
        colour = vec4(shaded(fromCentre, at, rhoSquared, w), 1.0);
    }
#endif
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
    gl_FragDepth = depth; // what comes nearer than the picture begins is clamped

    vec3 normal = (hit - centreAndCurvature.xyz) * centreAndCurvature.w;
    colour = vec4(shaded(normal, corner, rhoSquared, w), 1.0);
}
#endif
