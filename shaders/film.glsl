// SPDX-License-Identifier: MIT
// The translucent shell with its lines. It is denser where it is seen at a grazing angle, as a film
// is: that draws the silhouette and leaves the middle clear for the spheres. Lengths are in pixels,
// and `pixelsOf...` is a length of the picture over which a value changes by 1.

const float kPlain = float(kPlainEdge) / 255.0F;
const float kStrong = float(kStrongEdge) / 255.0F;
const float kCreaseEnd = 0.9F; // others' creases are not drawn from here on, of a reach of 1

INLINE ShellPaint paintOf(float alpha, bool discarded, bool front)
{
    ShellPaint paint;
    paint.density = alpha * (front ? 0.55F : 0.45F);
    paint.rimDensity = 3.0F * paint.density;
    paint.ofLine = front ? 1.0F : 0.5F;
    paint.ofEdges = discarded ? 0.0F : 1.0F;
    if (discarded)
    {
        // Out of the way of the spheres, which are at rest behind it: little is left but a rim.
        paint.density = front ? 0.12F * alpha : 0.0F;
        paint.rimDensity = front ? alpha : 0.0F;
        paint.ofLine *= 0.85F;
    }
    return paint;
}

// Of the light on a surface, what its film shows.
INLINE real lightInFilm(real light)
{
    return 0.55F + 0.45F * light;
}

// How much of it the surface covers. `facing` is 1 where it is seen from straight ahead, 0 edge-on.
INLINE real filmShare(real density, real rimDensity, real facing)
{
    return min(density + rimDensity * ((1.0F - facing) * (1.0F - facing)), 0.85F);
}

// How much a line of that width covers in so many pixels from its middle.
INLINE real onLine(real away, float width)
{
    return clamp(width + 0.5F - away, 0.0F, 1.0F);
}

// How strongly the outline along edges is drawn: it is a zigzag where triangles are small.
INLINE real outlineShown(real sizeInLines)
{
    return smoothstep(1.0F, 2.5F, sizeInLines);
}

// How strongly an edge is drawn that is `strength` strong, of a number of numbers.glsl over 255.
// Plain ones fade out as triangles shrink.
INLINE real edgeStrength(real strength, real plainShown, real outlineShare)
{
    real shown = select(strength < kPlain + 0.002F, plainShown, 1.0F);
    shown = select(strength > kStrong + 0.002F, outlineShare, shown);
    return min(strength, kStrong) * shown;
}

// The outline of the smooth surface takes the place of that along edges.
INLINE real contourStrength(real outlineShare)
{
    return kStrong * (1.0F - outlineShare);
}

// A surface that turns about within the width of a line has no outline there: it is a noisy scan.
INLINE real contourLine(real strength, real facing, real pixelsOfFacing, float width)
{
    return strength * (1.0F - smoothstep(0.3F, 0.5F, facing))
           * smoothstep(3.0F, 8.0F, pixelsOfFacing / width)
           * onLine(0.5F * facing * pixelsOfFacing, width);
}

// Large triangles have no room for others' creases. Where no distance changes, all corners lie on
// creases.
INLINE real creaseStrength(real sizeInLines, real pixelsOfCrease)
{
    real fade = 1.0F - smoothstep(3.0F, 6.0F, sizeInLines);
    return select(pixelsOfCrease < 1e5F, kStrong * fade, 0.0F);
}

// `away` from the nearest crease, which is known up to 1.
INLINE real creaseLine(real strength, real away, real pixelsOfCrease, float width)
{
    return strength * (1.0F - smoothstep(0.6F, kCreaseEnd, away))
           * onLine(away * pixelsOfCrease, width);
}

// Of what is drawn in a point: how much of it is film, and how much line. Lines lie over the film; in
// print they are a part of it that is denser.
struct Film
{
    real film, line;
};

INLINE Film lineInFilm(bool print, real film, real line)
{
    real covered = print ? max(film, line) : film;
    Film result;
    result.film = covered * (1.0F - line);
    result.line = print ? covered * line : line;
    return result;
}

// What is left beside a cut, `away` from it, ends in a line of its own.
INLINE real leftOfCut(real away)
{
    return clamp(0.5F - away, 0.0F, 1.0F);
}

INLINE real lineOfCut(real away, float width)
{
    return 0.85F * clamp(1.5F * width + away + 0.5F, 0.0F, 1.0F);
}
