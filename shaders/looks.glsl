// SPDX-License-Identifier: MIT
// How spheres look in a point. `rhoSquared` is 0 in the middle of the disc that is seen and 1 at its
// rim, w = sqrt(1 - rhoSquared); `diagonal` is the sum of the two coordinates on the disc.

const float kHatchShare = 0.34F; // that is dark
const float kStripe = 0.45F; // how dark it is
const float kStripeHalf = 0.14F; // of its width, in the radius

// A sphere's word has its state, and above it, where it is known how the sphere has turned, an axis of
// it: a byte for each coordinate, 127 for 1.
INLINE uint stateOf(uint word)
{
    return word & 255u;
}

INLINE vec3 axisOf(uint word)
{
    return vec3(float(int(word << 16u) >> 24), float(int(word << 8u) >> 24), float(int(word) >> 24))
           * (1.0F / 127.0F);
}

// A sphere that has turned has a stripe around it, square to its axis: it shows how it rolls.
INLINE float stripeAround(vec3 axis)
{
    return dot(axis, axis) > 0.0F ? kStripe : 0.0F;
}

// It is one where e < 1 and the sphere's centre is ahead.
INLINE Circle circleOf(vec3 centre, float radius)
{
    Circle circle;
    float distance = length(centre);
    circle.steepness = radius / distance;
    circle.right = normalize(vec3(-centre.z, 0.0F, centre.x));
    circle.above = cross(centre, circle.right) / -distance;
    circle.shrink = 1.0F - circle.steepness * circle.steepness;
    return circle;
}

// Colour alone does not tell the states apart for everyone. Running spheres are glossy with a dark
// ring, discarded ones are hatched, frozen ones are plain.
INLINE vec3 marksOf(uint state)
{
    return state == kRunning     ? vec3(0.65F * kWhite, 0.8F, 0.0F)
           : state == kDiscarded ? vec3(0.0F, 0.0F, 0.42F)
                                 : vec3(0.0F);
}

// The foot of a pile (`height` 0) gets less light than its top (1), and what is far fades into the
// background's colour, even where that is clear. In the studio nothing is hatched. `supersample`: pixels for one
// of the picture as it is seen, each way.
INLINE SphereLook lookOf(vec3 colour, vec3 marks, float height, float far, vec3 background,
                         float pixel, float supersample, bool studio, bool print)
{
    // On small spheres a hatch is noise. It fades to its mean, and is gone at 12 pixels across in the
    // picture as it is seen.
    float hatch = studio ? 0.0F : marks.z;
    float shown = print ? 1.0F : smoothstep(12.0F, 120.0F, 2.0F / (pixel * supersample));
    float foot = 0.86F + 0.14F * clamp(height, 0.0F, 1.0F);
    SphereLook look;
    look.tint = colour * (foot * (1.0F - far) * (1.0F - kHatchShare * hatch * (1.0F - shown)));
    look.haze = background * far;
    look.pixel = pixel;
    look.gloss = print ? 0.0F : marks.x;
    look.ring = marks.y;
    look.hatch = hatch * shown;
    return look;
}

// Neighbours keep light from each other's rims.
INLINE real lightNearRim(real w)
{
    return 0.64F + 0.36F * min(1.7F * w, 1.0F);
}

INLINE real power16(real value)
{
    real squared = value * value;
    real fourth = squared * squared;
    real eighth = fourth * fourth;
    return eighth * eighth;
}

// `cosine` of the angle between the normal and the highlight's middle.
INLINE real glossOf(SphereLook look, real cosine)
{
    real above = max(cosine, 0.0F);
    return power16(above * above) * look.gloss;
}

INLINE real hatchOf(SphereLook look, real diagonal)
{
    return look.hatch * stripes(diagonal * 1.3F + 0.25F, kHatchShare, look.pixel * 1.84F);
}

// `cosine` of the angle between the normal and the axis.
INLINE real unstriped(SphereLook look, real cosine)
{
    real inside = (kStripeHalf - abs(cosine)) * (1.0F / (look.pixel + 0.02F)) + 0.5F;
    return 1.0F - look.stripe * clamp(inside, 0.0F, 1.0F);
}

// What the other marks leave of the light.
INLINE real unmarked(SphereLook look, real rhoSquared, real diagonal)
{
    real ring =
        clamp((rhoSquared - 0.76F) * (1.0F / (2.0F * look.pixel + 0.02F)) + 0.5F, 0.0F, 1.0F);
    return 1.0F - look.ring * ring - hatchOf(look, diagonal);
}

// What an outline for print leaves. `width` in pixels.
INLINE real unlined(SphereLook look, real rhoSquared, float width)
{
    real fromRim = (1.0F - sqrt(rhoSquared)) * (1.0F / look.pixel);
    return 1.0F - 0.8F * clamp(width - fromRim + 0.5F, 0.0F, 1.0F);
}

// A cut is matt and paler than the outside, with a rim that parts neighbours. `light` falls on it;
// lengths are in the sphere's radius: of the point from the centre, and of the centre from the cut.
INLINE real3 onCut(SphereLook look, real light, real squared, real heightSquared, real diagonal)
{
    real innerSquared = max(squared - heightSquared, 0.0F);
    real discSquared = 1.0F - heightSquared;
    real inside = sqrt(max(discSquared, 0.0F)) - sqrt(innerSquared);
    real rim = clamp((inside - look.pixel) * (1.0F / (look.pixel + 0.02F)), 0.0F, 1.0F);
    real ring = clamp((innerSquared / discSquared - 0.6F) * (1.0F / 0.06F), 0.0F, 1.0F) * rim;
    real left = (0.80F + 0.15F * light) * (1.0F - hatchOf(look, diagonal))
                * (1.0F - 0.7F * (1.0F - rim)) * (1.0F - look.ring * ring);
    return mix(look.tint, vec3(kWhite), 0.34F) * left + look.haze;
}

// Where a ray meets what is left of a sphere: `capped` on the cut, and there `onSecond` of its planes.
struct CutMeeting
{
    real t;
    truth capped, onSecond;
    truth isThere; // anything is left
};

// The ray is within the sphere for `enter` < t < `leave`. At t it lies start + t growth deep in what
// either plane takes away; beyond both, things are taken away.
INLINE CutMeeting meetCut(real start0, real growth0, real start1, real growth1, real enter, real leave)
{
    // What is taken away is convex: the ray leaves it once, through the plane that comes first.
    real first = select(growth0 < 0.0F, min(-start0 / growth0, leave), leave);
    real second = select(growth1 < 0.0F, min(-start1 / growth1, first), first);
    CutMeeting met;
    met.capped = min(start0 + enter * growth0, start1 + enter * growth1) > 0.0F;
    met.onSecond = second < first;
    met.t = select(met.capped, second, enter);
    met.isThere = met.t < leave;
    return met;
}
