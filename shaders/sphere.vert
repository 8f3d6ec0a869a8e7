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

uniform mat4 view;
uniform mat4 projection;

out vec2 corner; // position in the circle's plane, in its radius
out vec3 onPlane; // Q, the point of the square [eye space]
flat out vec3 centre; // C [eye space]
flat out float radius;
flat out float steepness; // e; not used without perspective
flat out uint state;

void main()
{
    corner = vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID & 2) - 1);
    centre = (view * vec4(sphere.xyz, 1.0)).xyz;
    radius = sphere.w;
    state = sphereState;
#ifdef ORTHOGRAPHIC
    steepness = 0.0;
    onPlane = centre + radius * vec3(corner, 0.0);
    gl_Position = projection * vec4(onPlane, 1.0);
#else
    float distance = length(centre);
    steepness = radius / distance;
    if (steepness >= 1.0 || centre.z >= 0.0)
    {
        // The eye is in the sphere or past it: there is no such circle.
        onPlane = vec3(0.0);
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
        return;
    }
    vec3 right = normalize(vec3(-centre.z, 0.0, centre.x));
    vec3 above = cross(centre, right) / -distance;
    float shrink = 1.0 - steepness * steepness;
    onPlane = shrink * centre + radius * sqrt(shrink) * (corner.x * right + corner.y * above);
    gl_Position = projection * vec4(onPlane, 1.0);
#endif
}
