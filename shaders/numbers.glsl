// SPDX-License-Identifier: MIT
// Numbers that more than one text of the renderer needs, and what is the same all over a sphere or a
// side of the shell. Eye space: x to the right, y up in the
// picture, z towards the viewer.

// Those of SphereState and PolygonState.
const uint kRunning = 0u;
const uint kFrozen = 1u;
const uint kDiscarded = 2u;
const uint kDiscardedPolygon = 1u;

// What a line of the shell is, 0..255.
const uint kPlainEdge = 60u; // an edge within a smooth surface
const uint kStrongEdge = 190u; // the sharpest crease, and a rim; those less sharp lie between
const uint kOutlineEdge = 255u; // what the viewer sees the surface end at

// Three lights that stay with the camera: key from the upper left, fill from the right, and one from
// behind and above that parts the upper rims from what is behind them. Directions to the light.
const vec3 kKeyLight = vec3(-0.424F, 0.636F, 0.645F);
const vec3 kFillLight = vec3(0.802F, 0.134F, 0.582F);
const vec3 kBackLight = vec3(0.258F, 0.602F, -0.756F);
const vec3 kHighlight = vec3(-0.234F, 0.351F, 0.907F); // halfway between key light and viewer

// The studio's lamp: its half width, seen from anywhere. By so much its light spreads on the way: it
// is as soft as it is large.
const float kLampSoftness = 0.3F;

// Longest way and largest radius that SphereLight tells [radius of the sphere that is lit].
const float kOccluderRange = 7.0F;

// Shadow on the ground, which has the colour of the background.
const vec3 kShadow = vec3(0.07F, 0.08F, 0.11F);

// Slope of the distance from a cut that is drawn smoothly. Triangles that are seen edge-on end
// sharply at the cut: they would leave specks beyond it. [1 / pixel]
const float kSteepest = 4.0F;

// The circle in which the cone from the eye touches a sphere: see sphere.vert. Unit vectors to the right
// and upwards in its plane; its centre is `shrink` times the sphere's, and its radius is the sphere's
// times the root of that.
struct Circle
{
    vec3 right, above;
    float steepness; // e, the sphere's radius over its distance
    float shrink;
};

// What is the same all over a sphere.
struct SphereLook
{
    vec3 tint; // its own colour
    vec3 haze; // what is added to it
    float pixel; // the length of one, in the sphere's radius
    float gloss, ring, hatch; // how strong the marks are
    float stripe; // likewise; 0 where nobody knows how it has turned
};

// What is the same on one side of all triangles of a state.
struct ShellPaint
{
    float density, rimDensity;
    float ofLine; // how strongly lines are drawn
    float ofEdges; // plain ones beside
};
