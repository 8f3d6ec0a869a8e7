// SPDX-License-Identifier: MIT
// In front of every stage, behind the texts that C++ has too.

#ifdef OUTLINES
const bool kPrint = true;
#else
const bool kPrint = false;
#endif

#ifdef CUTAWAY
// A point of eye space is taken away when it lies beyond both planes.
uniform vec4 cutPlanes[2];

// Positive where things are taken away; its zero is the cut's surface.
float cutDepth(vec3 point)
{
    return min(dot(cutPlanes[0], vec4(point, 1.0)), dot(cutPlanes[1], vec4(point, 1.0)));
}

// The ray origin + t direction is within a sphere for `enter` < t < `leave`.
CutMeeting meetCutPlanes(vec3 origin, vec3 direction, float enter, float leave)
{
    return meetCut(dot(cutPlanes[0], vec4(origin, 1.0)), dot(cutPlanes[0].xyz, direction),
                   dot(cutPlanes[1], vec4(origin, 1.0)), dot(cutPlanes[1].xyz, direction), enter,
                   leave);
}
#endif
