// SPDX-License-Identifier: MIT
// The translucent shell with its edges. It is denser where it is seen at a grazing angle, as a film
// is: that draws the silhouette and leaves the middle clear for the spheres.

in vec3 eyePosition;
in vec3 eyeNormal;
in vec3 barycentric;
flat in vec3 edgeStrength;
flat in uint state;

uniform vec4 activeColour;
uniform vec4 discardedColour;
uniform vec3 activeInk; // of edges
uniform vec3 discardedInk;
uniform float lineWidth; // [pixel]
uniform float hatchPeriod; // [pixel]

out vec4 colour;

float edgeCoverage()
{
    vec3 dx = dFdx(barycentric);
    vec3 dy = dFdy(barycentric);
    vec3 pixels = barycentric / max(sqrt(dx * dx + dy * dy), 1e-6); // from each edge
    vec3 line = edgeStrength * clamp(lineWidth - pixels + 0.5, 0.0, 1.0);
    return max(line.x, max(line.y, line.z));
}

void main()
{
    bool front = gl_FrontFacing;
    vec3 normal = normalize(front ? eyeNormal : -eyeNormal);
#ifdef ORTHOGRAPHIC
    float facing = abs(normal.z);
#else
    float facing = abs(dot(normal, normalize(eyePosition)));
#endif
    float grazing = (1.0 - facing) * (1.0 - facing);

    bool discarded = state == kDiscardedPolygon;
    vec4 base = discarded ? discardedColour : activeColour;
    float density = base.a * (front ? 0.55 : 0.45) * (1.0 + 3.0 * grazing);
    if (discarded)
    {
        // The hatch is the second cue; its gaps keep the spheres behind it visible.
        float phase = (gl_FragCoord.x + (front ? 1.0 : -1.0) * gl_FragCoord.y) / hatchPeriod;
        density = base.a * mix(0.35, 1.35, stripes(phase, 0.4, 1.41 / hatchPeriod))
                  * (front ? 1.0 : 0.6);
    }
    vec3 lit = base.rgb * (0.55 + 0.45 * lightOn(normal));
    float line = edgeCoverage() * (front ? 1.0 : 0.5);
    float left = 1.0;
#ifdef CUTAWAY
    // What is left ends in a line of its own.
    float pixels = cutDepth(eyePosition) / max(fwidth(cutDepth(eyePosition)), 1e-6);
    left = clamp(0.5 - pixels, 0.0, 1.0);
    line = max(line, 0.85 * clamp(1.5 * lineWidth + pixels + 0.5, 0.0, 1.0));
#endif
    vec3 ink = discarded ? discardedInk : activeInk;
    colour = vec4(mix(lit, ink, line), left * max(min(density, 0.85), line));
}
