// SPDX-License-Identifier: MIT
// A sphere is drawn as one square that just covers its outline; sphere.frag does the rest.
//
// Perspective. The eye is the origin, the centre C is at distance d, and e = r / d. The cone from
// the eye that touches the sphere touches it along a circle: a tangent from the eye has length
// sqrt(d^2 - r^2), and its projection on C gives
//     circle's centre M = (1 - e^2) C,    circle's radius s = r sqrt(1 - e^2).
// The square around that circle, in the circle's plane, has for its inscribed circle exactly the
// sphere's outline, whatever the perspective makes of it.
//
// Orthographic. The same circle is the great circle that faces the viewer: M = C and s = r.

layout(location = 0) in vec4 sphere; // centre and radius
layout(location = 1) in uint sphereState;
layout(location = 2) in vec4 sphereColour;

#ifdef OCCLUSION
layout(location = 3) in vec4 occluders[12]; // SphereLight, in unit space
layout(location = 15) in vec4 open;

flat out vec4 occluder[12]; // way to the centre and radius, in the sphere's radius [eye space]
flat out vec2 openTo; // what all others let through of the sky, of the lamp
#endif

uniform mat4 view;
uniform mat4 projection;

uniform float pixelScale; // pixels in a length of 1 at distance 1, or at any without perspective
uniform float supersample; // drawn for one pixel of the picture, each way
uniform vec3 background;
uniform vec4 heightPlane; // with an eye-space point: 0 at the object's foot, 1 at its top
uniform vec4 distancePlane; // with an eye-space point: 0 at the object's front, 1 at its back
uniform float haze; // share of the background in the furthest spheres

out vec2 corner; // position in the circle's plane, in its radius
out vec3 onPlane; // Q, the point of the square [eye space]
flat out vec4 centreAndCurvature; // C [eye space], 1 / r
flat out vec4 tintAndSteepness; // the sphere's own colour, e (r without perspective)
flat out vec4 hazeAndPixel; // what is added to the colour, a pixel's length in the sphere's radius
flat out vec4 marks; // strength of gloss, of the ring, of the hatch and of the stripe
flat out vec3 stripeAxis; // what the stripe is square to [eye space]
flat out vec4 identity; // bytes of it, for surfaces

#ifdef STUDIO
const bool kStudio = true;
#else
const bool kStudio = false;
#endif

// All that is the same over one sphere is worked out here, once a corner and not once a pixel.
// `pixel` is the length of one in the sphere's radius.
void setColours(vec3 centre, float pixel)
{
    float far = haze * clamp(dot(distancePlane, vec4(centre, 1.0)), 0.0, 1.0);
    SphereLook look = lookOf(sphereColour.rgb, marksOf(stateOf(sphereState)),
                             dot(heightPlane, vec4(centre, 1.0)), far,
                             background, pixel, supersample, kStudio, kPrint);
    tintAndSteepness.rgb = look.tint;
    hazeAndPixel = vec4(look.haze, pixel);
    vec3 axis = axisOf(sphereState);
    marks = vec4(look.gloss, look.ring, look.hatch, stripeAround(axis));
    stripeAxis = mat3(view) * axis;
}

void main()
{
    identity = sphereColour;
    corner = vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID & 2) - 1);
    vec3 centre = (view * vec4(sphere.xyz, 1.0)).xyz;
    float radius = sphere.w;
    centreAndCurvature = vec4(centre, 1.0 / radius);
#ifdef OCCLUSION
    for (int i = 0; i < 12; ++i)
    {
        occluder[i] = kOccluderRange * vec4(mat3(view) * occluders[i].xyz, occluders[i].w);
    }
    openTo = open.xy;
#endif
#ifdef ORTHOGRAPHIC
    setColours(centre, 1.0 / (pixelScale * radius));
    tintAndSteepness.a = radius;
    onPlane = centre + radius * vec3(corner, 0.0);
    gl_Position = projection * vec4(onPlane, 1.0);
#else
    Circle circle = circleOf(centre, radius);
    setColours(centre, -centre.z / (pixelScale * radius));
    tintAndSteepness.a = circle.steepness;
    if (circle.steepness >= 1.0 || centre.z >= 0.0)
    {
        // The eye is in the sphere or past it: there is no such circle.
        onPlane = vec3(0.0);
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
        return;
    }
    onPlane = circle.shrink * centre
              + radius * sqrt(circle.shrink)
                    * (corner.x * circle.right + corner.y * circle.above);
    gl_Position = projection * vec4(onPlane, 1.0);
#endif
}
