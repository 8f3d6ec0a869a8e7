// SPDX-License-Identifier: MIT
// In front of every stage. Eye space: x to the right, y up in the picture, z towards the viewer.

// The numbers of SphereState and PolygonState.
const uint kRunning = 0u;
const uint kFrozen = 1u;
const uint kDiscarded = 2u;
const uint kDiscardedPolygon = 1u;

// Of a sphere's hatch that is dark.
const float kHatchShare = 0.34;

// Three lights that stay with the camera: key from the upper left, fill from the right, and one from
// behind and above that parts the upper rims from what is behind them; and a sky whose light grows
// evenly from below to above. Directions to the light.
const vec3 kKeyLight = vec3(-0.424, 0.636, 0.645);
const vec3 kFillLight = vec3(0.802, 0.134, 0.582);
const vec3 kBackLight = vec3(0.258, 0.602, -0.756);

float lightOn(vec3 normal)
{
    return 0.56 + 0.13 * normal.y + 0.50 * max(dot(normal, kKeyLight), 0.0)
           + 0.16 * max(dot(normal, kFillLight), 0.0) + 0.5 * max(dot(normal, kBackLight), 0.0);
}

#ifdef CUTAWAY
// A point of eye space is taken away when it lies beyond both planes.
uniform vec4 cutPlanes[2];

// Positive where things are taken away; its zero is the cut's surface.
float cutDepth(vec3 point)
{
    return min(dot(cutPlanes[0], vec4(point, 1.0)), dot(cutPlanes[1], vec4(point, 1.0)));
}

// The ray origin + t direction is within a sphere for `enter` < t < `leave`. Moves `enter` to where
// the ray first meets what is left of the sphere; false when there is nothing left. `cap` is the
// normal of the cut if it is met there, else zero.
bool enterCutSphere(vec3 origin, vec3 direction, inout float enter, float leave, out vec3 cap)
{
    cap = vec3(0.0);
    if (cutDepth(origin + enter * direction) <= 0.0)
    {
        return true;
    }
    // What is taken away is convex: the ray leaves it once, through the plane that comes first.
    float first = leave;
    for (int i = 0; i < 2; ++i)
    {
        float slope = dot(cutPlanes[i].xyz, direction);
        float meets = -dot(cutPlanes[i], vec4(origin, 1.0)) / slope;
        if (slope < 0.0 && meets < first)
        {
            first = meets;
            cap = normalize(cutPlanes[i].xyz);
        }
    }
    enter = first;
    return first < leave;
}
#endif

// Coverage of stripes with period 1 and the given share of dark, antialiased over `width` periods.
// Stripes that are finer than pixels become their mean.
float stripes(float phase, float share, float width)
{
    float edge = abs(fract(phase) - 0.5) - 0.5 * (1.0 - share);
    float crisp = clamp(edge / max(width, 1e-4) + 0.5, 0.0, 1.0);
    return mix(crisp, share, clamp(2.5 * width - 0.75, 0.0, 1.0));
}
