// SPDX-License-Identifier: MIT
// Which sphere a pixel shows, where its surface faces, and how far it is. sphere.frag has the
// mathematics.

in vec2 corner;
in vec3 onPlane;
flat in vec4 centreAndCurvature;
flat in vec4 tintAndSteepness;
flat in vec4 identity;

uniform mat4 projection;
uniform float depthAtInfinity;

layout(location = 0) out vec4 normalColour;
layout(location = 1) out vec4 identityColour;

void main()
{
    float rhoSquared = dot(corner, corner);
    float rise = tintAndSteepness.a * sqrt(max(1.0 - rhoSquared, 0.0));
#ifdef ORTHOGRAPHIC
    vec3 origin = onPlane;
    vec3 direction = vec3(0.0, 0.0, -1.0);
    float enter = -rise;
    float leave = rise;
#else
    vec3 origin = vec3(0.0);
    vec3 direction = onPlane;
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

    vec3 normal = (hit - centreAndCurvature.xyz) * centreAndCurvature.w;
#ifdef CUTAWAY
    vec4 plane = cutPlanes[met.onSecond ? 1 : 0];
    normal = met.capped ? normalize(plane.xyz) : normal;
#endif
    normalColour = vec4(0.5 + 0.5 * normal, 1.0);
    identityColour = identity;
}
