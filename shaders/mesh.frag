// SPDX-License-Identifier: MIT
// The translucent shell with its lines. It is denser where it is seen at a grazing angle, as a film
// is: that draws the silhouette and leaves the middle clear for the spheres.

in vec3 eyePosition;
in vec3 eyeNormal;
in vec3 barycentric;
flat in vec3 edgeStrength; // a line_strength of mesh_shading.hpp over 255
in float creaseDistance; // over kCreaseReach
flat in uint state;

uniform vec4 activeColour;
uniform vec4 discardedColour;
uniform vec3 activeInk; // of lines
uniform vec3 discardedInk;
uniform float lineWidth; // [pixel]
uniform float hatchPeriod; // [pixel]
uniform float pixelLength; // of one, in eye space at distance 1, or at any without perspective
uniform vec2 edgeFade; // plain edges appear where triangles grow from one to the other [pixel]

out vec4 colour;

const float kSteepest = 4.0; // slope of the distance from a cut that is drawn smoothly
const float kPlain = 60.0 / 255.0;
const float kStrong = 190.0 / 255.0;

// A length of the picture over which a value changes by 1. [pixel]
float pixelsOf(float value)
{
    vec2 slope = vec2(dFdx(value), dFdy(value));
    return inversesqrt(max(dot(slope, slope), 1e-12));
}

#ifdef FADING_LINES
// Every line is where a number over the surface is zero. The number divided by its slope in the
// picture is the distance from the line, in pixels, at any size of triangles.
//
// An edge of the triangle: its barycentric coordinate. Plain ones fade out as triangles shrink, and
// so does the outline along edges, which is a zigzag then; the outline of the smooth surface, where
// the normal is perpendicular to the view, takes its place.
// A crease of other triangles: the distance from it, which reaches as far as a line is wide.
const vec2 kOutlineFade = vec2(1.0, 2.5); // as edgeFade [width of a line]
const float kCreaseFade = 6.0; // triangles larger than this have no room for others' creases

float lineCoverage(float facing, bool discarded)
{
    vec3 dx = dFdx(barycentric);
    vec3 dy = dFdy(barycentric);
    vec3 heights = inversesqrt(max(dx * dx + dy * dy, 1e-12)); // of the triangle [pixel]
    float size = min(heights.x, min(heights.y, heights.z));
    vec3 covered = clamp(lineWidth - barycentric * heights + 0.5, 0.0, 1.0);

    float edges = discarded ? 0.0 : smoothstep(edgeFade.x, edgeFade.y, size);
    float outline = smoothstep(kOutlineFade.x, kOutlineFade.y, size / lineWidth);
    vec3 isPlain = vec3(lessThan(edgeStrength, vec3(kPlain + 0.002)));
    vec3 isOutline = vec3(greaterThan(edgeStrength, vec3(kStrong + 0.002)));
    vec3 strength = min(edgeStrength, kStrong);
    vec3 shown = mix(mix(vec3(1.0), vec3(edges), isPlain), vec3(outline), isOutline);
    vec3 line = strength * covered * shown;

    float turn = abs(facing) * pixelsOf(facing);
    float contour = kStrong * (1.0 - outline) * (1.0 - smoothstep(0.3, 0.5, abs(facing)))
                    * clamp(lineWidth + 0.5 - 0.5 * turn, 0.0, 1.0);
    float slope = pixelsOf(creaseDistance);
    float crease = slope < 1e5 ? creaseDistance * slope : 1e6; // all corners lie on creases
    float creased = kStrong * (1.0 - smoothstep(0.5 * kCreaseFade, kCreaseFade, size / lineWidth))
                    * (1.0 - smoothstep(0.6, 0.9, creaseDistance))
                    * clamp(lineWidth + 0.5 - crease, 0.0, 1.0);
    return max(max(line.x, max(line.y, line.z)), max(contour, creased));
}
#else
float lineCoverage(float facing, bool discarded)
{
    vec3 dx = dFdx(barycentric);
    vec3 dy = dFdy(barycentric);
    vec3 pixels = barycentric / max(sqrt(dx * dx + dy * dy), 1e-6); // from each edge
    vec3 line = min(edgeStrength, kStrong) * clamp(lineWidth - pixels + 0.5, 0.0, 1.0);
    return max(line.x, max(line.y, line.z));
}
#endif

void main()
{
    bool front = gl_FrontFacing;
    vec3 normal = normalize(front ? eyeNormal : -eyeNormal);
#ifdef ORTHOGRAPHIC
    float towards = normal.z;
#else
    float towards = -dot(normal, normalize(eyePosition));
#endif
    float facing = abs(towards);
    float grazing = (1.0 - facing) * (1.0 - facing);

    bool discarded = state == kDiscardedPolygon;
    vec4 base = discarded ? discardedColour : activeColour;
    float density = base.a * (front ? 0.55 : 0.45) * (1.0 + 3.0 * grazing);
    float ofLine = front ? 1.0 : 0.5;
#ifdef OUTLINES
    if (discarded)
    {
        // The hatch is the second cue; its gaps keep the spheres behind it visible.
        float phase = (gl_FragCoord.x + (front ? 1.0 : -1.0) * gl_FragCoord.y) / hatchPeriod;
        density = base.a * mix(0.35, 1.35, stripes(phase, 0.4, 1.41 / hatchPeriod))
                  * (front ? 1.0 : 0.6);
    }
#else
    if (discarded)
    {
        // Out of the way of the spheres, which are at rest behind it: little is left but a rim.
        density = front ? base.a * (0.1 + 0.5 * grazing) : 0.0;
        ofLine *= 0.6;
    }
#endif
    vec3 lit = base.rgb * (0.55 + 0.45 * lightOn(normal));
    float line = lineCoverage(towards, discarded) * ofLine;
    float left = 1.0;
#ifdef CUTAWAY
    // What is left ends in a line of its own.
    float slope = max(fwidth(cutDepth(eyePosition)), 1e-6);
#ifdef FADING_LINES
    // Triangles that are seen edge-on end sharply at the cut: they would leave specks beyond it.
#ifdef ORTHOGRAPHIC
    slope = min(slope, kSteepest * pixelLength);
#else
    slope = min(slope, kSteepest * pixelLength * -eyePosition.z);
#endif
#endif
    float pixels = cutDepth(eyePosition) / slope;
    left = clamp(0.5 - pixels, 0.0, 1.0);
    line = max(line, 0.85 * clamp(1.5 * lineWidth + pixels + 0.5, 0.0, 1.0));
#endif
    vec3 ink = discarded ? discardedInk : activeInk;
#ifdef OUTLINES
    colour = vec4(mix(lit, ink, line), left * max(min(density, 0.85), line));
#else
    // Lines over the film.
    float film = min(density, 0.85) * (1.0 - line);
    colour = vec4((lit * film + ink * line) / max(film + line, 1e-6), left * (film + line));
#endif
}
