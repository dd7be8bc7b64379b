/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The slope of the wedge is a broken line. It is -1 up to x = -1, rises by 1 per length up to x =
 * 1, and is constant beyond. Each of the two bends adds its own part to every result. */
#include "eccentric_patch.h"

#include "claims.h"

static const double PI = 3.14159265358979323846;

typedef struct {
    double x, k;
} bend;

static const bend BENDS[2] = {{-1, 1}, {1, -1}};

/* Its place on the patch, as an angle: from -pi/2 at the left edge to pi/2 at the right one. */
static double angle_of(eccentric_patch patch, double x)
{
    return asin(fmax(-1, fmin(1, (x - patch.middle) / patch.half)));
}

/* The moment is that of the two flanks' and the tip's shares, integrated. */
patch_loads eccentric_loads(eccentric_patch patch)
{
    const double m = patch.middle, s = patch.half;
    const double u = angle_of(patch, -1), v = angle_of(patch, 1);
    patch_loads l = {.tilt = -1};
    for (int i = 0; i < 2; i++) {
        const double phi = angle_of(patch, BENDS[i].x), psi = PI / 2 - phi;
        const double beyond = fmax(0, m - s - BENDS[i].x); /* the patch is on one side of it */
        l.P += BENDS[i].k * s * s * (psi / 2 + sin(2 * phi) / 4 - sin(phi) * cos(phi));
        l.tilt += BENDS[i].k * (beyond + s / PI * (cos(phi) - psi * sin(phi)));
    }
    const double tip = (cos(v) / 2 - cos(3 * v) / 6) - (cos(u) / 2 - cos(3 * u) / 6);
    l.M =
        m * l.P -
        s * s / 2 * (-(sin(2 * u) + sin(2 * v)) / 2 + m / 2 * (sin(2 * v) - sin(2 * u)) + s * tip);
    return l;
}

double eccentric_pressure(eccentric_patch patch, double x)
{
    if (fabs(x - patch.middle) >= patch.half)
        return 0;
    const double v = angle_of(patch, x);
    double p = 0;
    for (int i = 0; i < 2; i++) {
        const double phi = angle_of(patch, BENDS[i].x), psi = PI / 2 - phi;
        const double L = log(fabs(sin((phi - v) / 2) / cos((phi + v) / 2)));
        const double away = sin(v) - sin(phi);
        p += BENDS[i].k * patch.half / PI * ((away == 0 ? 0 : away * L) - psi * cos(v));
    }
    return p;
}

typedef double (*second_load)(patch_loads l);

static double moment(patch_loads l)
{
    return l.M;
}

static double tilt(patch_loads l)
{
    return l.tilt;
}

/* Newton's method with differences for derivatives, from the middle. */
static eccentric_patch patch_of(double P, double other, second_load second)
{
    eccentric_patch patch = {0, P / 2 + sqrt(P)};
    for (int step = 0; step < 100; step++) {
        const patch_loads l = eccentric_loads(patch);
        const double off = P - l.P, off_other = other - second(l), h = 1e-6 * patch.half;
        if (fabs(off) + fabs(off_other) < 1e-12 * (P + fabs(other)))
            return patch;
        const patch_loads by_m = eccentric_loads((eccentric_patch){patch.middle + h, patch.half});
        const patch_loads by_s = eccentric_loads((eccentric_patch){patch.middle, patch.half + h});
        const double a = (by_m.P - l.P) / h, b = (by_s.P - l.P) / h;
        const double c = (second(by_m) - second(l)) / h, d = (second(by_s) - second(l)) / h;
        const double dm = (off * d - b * off_other) / (a * d - b * c);
        const double ds = (a * off_other - c * off) / (a * d - b * c);
        const double most = 0.3 * patch.half / fmax(fabs(dm), fabs(ds));
        patch.middle += fmin(1, most) * dm;
        patch.half += fmin(1, most) * ds;
    }
    fail_msg("no patch for P = %g and %g", P, other);
    return patch;
}

eccentric_patch patch_of_moment(double P, double M)
{
    return patch_of(P, M, moment);
}

eccentric_patch patch_of_tilt(double P, double delta)
{
    return patch_of(P, delta, tilt);
}
