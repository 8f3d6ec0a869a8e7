// SPDX-License-Identifier: MIT
// The shell: film.glsl with the lengths that this picture has.

in vec3 eyePosition;
in vec3 eyeNormal;
in vec3 barycentric;
flat in vec3 edgeStrengths; // over 255, as in numbers.glsl
in float creaseDistance; // over kCreaseReach
flat in uint state;

uniform vec4 activeColour;
uniform vec4 discardedColour;
uniform vec3 activeInk; // of lines
uniform vec3 discardedInk;
uniform float lineWidth; // [pixel]
uniform float pixelLength; // of one, in eye space at distance 1, or at any without perspective
uniform vec2 edgeFade; // plain edges appear where triangles grow from one to the other [pixel]

out vec4 colour; // premultiplied, so that it is rounded as tiles round

// A length of the picture over which a value changes by 1. [pixel]
float pixelsOf(float value)
{
    vec2 slope = vec2(dFdx(value), dFdy(value));
    return inversesqrt(max(dot(slope, slope), 1e-12));
}

// Every line is where a number over the surface is zero. The number divided by its slope in the
// picture is the distance from the line, in pixels, at any size of triangles. That of an edge of the
// triangle is its barycentric coordinate, and that of a crease of other triangles the distance from
// it, which reaches as far as a line is wide.
float lineCoverage(float facing, float ofEdges)
{
    vec3 dx = dFdx(barycentric);
    vec3 dy = dFdy(barycentric);
    vec3 heights = inversesqrt(max(dx * dx + dy * dy, 1e-12)); // of the triangle [pixel]
#ifdef FADING_LINES
    float size = min(heights.x, min(heights.y, heights.z));
    float plainShown = ofEdges * smoothstep(edgeFade.x, edgeFade.y, size);
    float outline = outlineShown(size / lineWidth);
#else
    const float plainShown = 1.0;
    const float outline = 1.0;
#endif
    float line = 0.0;
    for (int i = 0; i < 3; ++i)
    {
        line = max(line, edgeStrength(edgeStrengths[i], plainShown, outline)
                             * onLine(barycentric[i] * heights[i], lineWidth));
    }
#ifdef FADING_LINES
    line = max(line, contourLine(contourStrength(outline), abs(facing), pixelsOf(facing), lineWidth));
    float pixels = pixelsOf(creaseDistance);
    line = max(line, creaseLine(creaseStrength(size / lineWidth, pixels), creaseDistance, pixels,
                                lineWidth));
#endif
    return line;
}

void main()
{
    bool front = gl_FrontFacing;
    vec3 normal = normalize(front ? eyeNormal : -eyeNormal);
#ifdef ORTHOGRAPHIC
    float towards = normal.z;
#else
    float towards = -dot(normal, normalize(eyePosition));
#endif

    bool discarded = state == kDiscardedPolygon;
    vec4 base = discarded ? discardedColour : activeColour;
    ShellPaint paint = paintOf(base.a, discarded, front);
    float share = filmShare(paint.density, paint.rimDensity, abs(towards));
    float line = lineCoverage(towards, paint.ofEdges) * paint.ofLine;
    float left = 1.0;
#ifdef CUTAWAY
    float depth = cutDepth(eyePosition);
    float slope = max(fwidth(depth), 1e-6);
#ifdef ORTHOGRAPHIC
    float steepest = kSteepest * pixelLength;
#else
    float steepest = kSteepest * pixelLength * -eyePosition.z;
#endif
#ifdef FADING_LINES
    slope = min(slope, steepest);
#else
    slope = depth > 0.0 ? min(slope, steepest) : slope; // the line keeps its width
#endif
    float away = depth / slope;
    left = leftOfCut(away);
    line = max(line, lineOfCut(away, lineWidth));
#endif
    Film seen = lineInFilm(kPrint, share, line);
    vec3 lit = base.rgb * lightInFilm(lightOn(normal));
    vec3 ink = discarded ? discardedInk : activeInk;
    colour = left * vec4(lit * seen.film + ink * seen.line, seen.film + seen.line);
}
