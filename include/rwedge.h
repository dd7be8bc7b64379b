/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rwedge: the contact of a wedge with a rounded apex, and of any convex pad, with an elastically
 * similar half-plane.
 *
 * Source: M. Ciavarella, D. A. Hills, G. Monno, "Contact problems for a wedge with rounded
 * apex", Int. J. Mech. Sci. 40 (1998) 977-988. "Eq. (n)" is that paper's numbering, "E1" ... its
 * errata as listed in lib/README.md, where every formula is written out; "new" marks what the
 * paper does not have.
 *
 * Geometry and units. Plane strain. x runs along the surface, y >= 0 into the half-plane. The
 * flanks of the wedge leave the surface at the small angle theta. Its apex is rounded over |x| <
 * a with the radius R = a/theta. The contact is |x| < b. The functions of a/b use natural units:
 * lengths in b, stresses in theta/A, where A is the composite compliance, Eq. (2). Stresses and
 * pressures are negative in compression. P and Q are positive forces per unit length. k is the
 * yield stress in pure shear. In sliding q = f p: the half-plane is dragged towards +x, and the
 * trailing edge is x = -b. For plane stress take nu = 0 in the functions of strength, and A =
 * 2/E1 + 2/E2.
 *
 * Domain. Lengths, loads, moduli, stresses, the compliance, friction, the angle theta, and ratios
 * of lengths such as a/b and x/b have a size: they are 0, where that is allowed, or 1e-60 to 1e60
 * in magnitude. A result that would leave this range is an error. These arguments have no size:
 * nu, nu1, nu2, angle, Q_over_fP, AP_over_theta_a.
 *
 * Arguments that many functions share:
 *   alpha  a/b, rounding over contact half-width, finite, >= 0; 0 is the sharp wedge, >= 1 is
 *          Hertz' contact
 *   f      coefficient of friction, 0 <= f <= 1e6
 *   nu     Poisson's ratio of the half-plane, 0 <= nu <= 0.5
 *   c      half-width of the stick zone over b, 0 <= c <= 1; 0 is full sliding
 *   x      place along the surface, in b, finite
 *   y      depth below it, in b, finite, >= 0
 *
 * Errors, two rules. A pure formula returns its value, and NaN outside its domain, like sqrt().
 * A function that iterates, allocates or has several results returns a status: RWEDGE_OK or a
 * reason. It leaves its outputs untouched on failure. RWEDGE_OK implies finite outputs. No
 * function prints, exits, aborts, sets errno or keeps state between calls. A function allocates
 * only if RWEDGE_ENOMEM is among its errors; rwedge_contact_obstacle() allocates too.
 *
 * Threads: every function may be called from any number of threads. A handle may be read by many
 * at a time. Output arrays may be the same as input arrays, but may not overlap them in part. */
#ifndef RWEDGE_H
#define RWEDGE_H

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32) && defined(RWEDGE_BUILD_SHARED)
#define RWEDGE_API __declspec(dllexport)
#elif defined(__GNUC__)
#define RWEDGE_API __attribute__((visibility("default")))
#else
#define RWEDGE_API
#endif

#define RWEDGE_VERSION "2.0.0"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Status ---------------------------------------------------------------------------------- */

/* Values never change; new ones are added at the end. */
enum {
    RWEDGE_OK = 0,
    RWEDGE_EDOMAIN = 1,  /* an argument is outside its domain, or not a number */
    RWEDGE_ENULL = 2,    /* a pointer that is needed is NULL */
    RWEDGE_ERANGE = 3,   /* a size is too large, or too small, for the operation */
    RWEDGE_ENOCONV = 4,  /* an iteration did not converge */
    RWEDGE_ENOMEM = 5,   /* out of memory */
    RWEDGE_ESLIDING = 6, /* |Q| exceeds f P: no equilibrium */
    RWEDGE_ERANK = 7,    /* the samples do not determine that many coefficients */
    RWEDGE_EABSENT = 8,  /* what was asked for does not exist for these arguments */
    RWEDGE_EPATH = 9     /* no closed form on this path of loads: rwedge_contact_allow_error() */
};

/* The library's version, "MAJOR.MINOR.PATCH"; RWEDGE_VERSION is that of the header. Static text. */
RWEDGE_API const char *rwedge_version(void);

/* What a status means, in English. Static text, never NULL.
 *   status  any integer */
RWEDGE_API const char *rwedge_strerror(int32_t status);

/* ---- Materials ------------------------------------------------------------------------------- */

/* Composite compliance A = 2(1-nu1^2)/E1 + 2(1-nu2^2)/E2, in 1/unit of E.                   Eq. (2)
 *   E1, E2    Young's moduli, > 0; HUGE_VAL is a rigid body (one of the two at most)
 *   nu1, nu2  Poisson's ratios, -1 < nu <= 0.5
 * NaN outside the domain, or where A leaves it. Relative error below 4 epsilon. */
RWEDGE_API double rwedge_compliance(double E1, double nu1, double E2, double nu2);

/* Dundurs' second constant for plane strain. It couples the normal and the tangential problem: the
 * theory with friction is exact where it is 0 (elastically similar bodies). Its sign changes when
 * the bodies are exchanged; |beta| <= 1/2 for nu >= 0.            Dundurs (1969), see lib/README.md
 *   others  as in rwedge_compliance()
 * NaN where rwedge_compliance() is. Error below 4 epsilon, absolutely. */
RWEDGE_API double rwedge_dundurs_beta(double E1, double nu1, double E2, double nu2);

/* The same constant for plane stress. The compliance of plane stress is that of nu = 0. The strain
 * per tension is 1/E1: rwedge_contact_set_strain(); rwedge_contact_set_bodies() is for plane
 * strain.                                                         Dundurs (1969), see lib/README.md
 *   others  as in rwedge_compliance()
 * NaN where the compliance for nu = 0 is. |beta| < 1; |beta| <= 1/2 for nu >= 0. Error below 4
 * epsilon, absolutely. */
RWEDGE_API double rwedge_dundurs_beta_plane_stress(double E1, double nu1, double E2, double nu2);

/* ---- Contact law ----------------------------------------------------------------------------- */

/* Load of a contact of half-width b, as A P/(theta b): 2 for the sharp wedge, (pi/2)/alpha for
 * Hertz.                                                                  Eq. (7), (11), (13), (15)
 * NaN outside the domain of alpha. Relative error below 4 epsilon. Inverse: rwedge_a_over_b(). */
RWEDGE_API double rwedge_load(double alpha);

/* Derivative of rwedge_load() by alpha, 0 for the sharp wedge.                                  new
 * NaN outside the domain of alpha. Relative error below 1e-14. */
RWEDGE_API double rwedge_load_derivative(double alpha);

/* The contact law solved for its half-width: a/b from A P/(theta a), over the whole range, Hertz
 * (a/b >= 1) included.                                                       Eq. (7), (11), inverse
 *   AP_over_theta_a  > 0, finite
 * NaN outside the domain, or where a/b leaves it. Relative error below 1e-14. */
RWEDGE_API double rwedge_a_over_b(double AP_over_theta_a);

/* ---- Pressure -------------------------------------------------------------------------------- */

/* Contact pressure A p/theta at x, compression negative; 0 for |x| >= 1.        Eq. (8), (12), (14)
 * NaN outside the domain, and at the apex of the sharp wedge (alpha = 0, x = 0), where it is
 * infinite. Relative error below 1e-12, up to the zeros at x = +-1. */
RWEDGE_API double rwedge_pressure(double alpha, double x);

/* Magnitude of the peak pressure, at x = 0, as A p0/theta.                           Eq. (10), (16)
 * NaN outside the domain, and for alpha = 0, where it is infinite. Relative error below 1e-14. */
RWEDGE_API double rwedge_peak_pressure(double alpha);

/* Magnitude of the pressure where the rounding meets the flank, x = +-a, as A p/theta; 0 for
 * alpha >= 1, where x = a is not inside the contact.                                        Eq. (9)
 * NaN outside the domain, and for alpha = 0, where it is infinite. Relative error below 1e-14. */
RWEDGE_API double rwedge_transition_pressure(double alpha);

/* Coefficient b_n of the paper's series p = -sqrt(1-x^2) sum b_n U_2n(x).
 *                                                                       Eq. (29), (31) with E1; new
 *   n  index of the coefficient, >= 0
 * NaN outside the domain; 0 for alpha >= 1 and n >= 1. Error below the larger of 1e-14,
 * relatively, and 1e-22 of the values around: this counts next to a zero of b_n. */
RWEDGE_API double rwedge_coefficient(double alpha, int32_t n);

/* ---- Partial slip ---------------------------------------------------------------------------- */

/* Half-width of the stick zone c/b, under a tangential force Q < fP that grew from zero under
 * constant P.                                                                              Eq. (25)
 *   Q_over_fP  0 <= Q/(fP) <= 1; 0 sticks everywhere (1), 1 slides (0)
 * NaN outside the domain. Relative error below 1e-14. Inverse: rwedge_shear_ratio(). */
RWEDGE_API double rwedge_stick_width(double alpha, double Q_over_fP);

/* Q/(fP) from the half-width of the stick zone.                                            Eq. (25)
 * NaN outside the domain. Relative error below 1e-14, also where it goes to 0 (c near 1). */
RWEDGE_API double rwedge_shear_ratio(double alpha, double c);

/* Shear traction A q/(f theta) at x, with a stick zone |x| < c; it has the sign of the pressure
 * (q = f p where it slips); 0 for |x| >= 1.                                    Eq. (23), (26), (27)
 * NaN outside the domain, and for alpha = c = x = 0. Error below 1e-14 (1 + |A p/theta|). */
RWEDGE_API double rwedge_shear(double alpha, double c, double x);

/* ---- Interior stresses ----------------------------------------------------------------------- */

/* Stresses at the point (x, y), in theta/A, tension positive; closed form.
 *                                                             Eq. (28), (32), (33) with E4, E8; new
 *   x, y           in b, finite, y >= 0; not the apex (0, 0) of the sharp wedge
 *   sxx, syy, txy  each receives one number
 * RWEDGE_EDOMAIN, RWEDGE_ENULL.
 * Error below 1e-13 of the larger of the tensor's norm and max(1, f)/(1+|z|), z = x + iy. */
RWEDGE_API int32_t rwedge_stress(double alpha, double f, double c, double x, double y, double *sxx,
                                 double *syy, double *txy);

/* The same at n points: x[i], y[i] -> sxx[i], syy[i], txy[i]. Nothing is written unless every
 * point is in the domain. */
RWEDGE_API int32_t rwedge_stresses(double alpha, double f, double c, size_t n, const double x[],
                                   const double y[], double sxx[], double syy[], double txy[]);

/* How the stresses change with the place: d/dx and d/dy of them, in theta/(A b); closed form.   new
 *   x, y                 in b, finite, y >= 0; not on the surface at an edge, where |x| is 1, c or
 *                        alpha, nor the apex of the sharp wedge: there one of them is infinite
 *   sxx_x, syy_x, txy_x  d/dx, each receives one number
 *   sxx_y, syy_y, txy_y  d/dy, each receives one number
 * RWEDGE_EDOMAIN where x is such an edge and y is 0; RWEDGE_ENULL. Error below 1e-12 of the
 * parts that add up: lib/README.md, "Accuracy". */
RWEDGE_API int32_t rwedge_stress_gradient(double alpha, double f, double c, double x, double y,
                                          double *sxx_x, double *syy_x, double *txy_x,
                                          double *sxx_y, double *syy_y, double *txy_y);

/* How the stresses change with the contact: d/dalpha, d/df and d/dc of them at a place of which x
 * and y, in b, stay, in theta/A; closed form.                                                   new
 *   x, y     as in rwedge_stress_gradient()
 *   d_alpha  receives 3 numbers: d/dalpha of sxx, syy and txy; 0 for the sharp wedge
 *   d_f      receives 3 numbers: d/df of them
 *   d_c      receives 3 numbers: d/dc of them; that of a growing c for c = 0
 * RWEDGE_EDOMAIN where x is such an edge and y is 0; RWEDGE_ENULL. Error as that of
 * rwedge_stress_gradient(). */
RWEDGE_API int32_t rwedge_stress_sensitivity(double alpha, double f, double c, double x, double y,
                                             double d_alpha[3], double d_f[3], double d_c[3]);

/* ---- Strength -------------------------------------------------------------------------------- */

/* Maximum tension b s1/(fP), at the trailing edge in full sliding: 1 for the sharp wedge, 4/pi
 * for Hertz.                                                                          Eq. (38); new
 * NaN outside the domain. Relative error below 1e-14. */
RWEDGE_API double rwedge_max_tension(double alpha);

/* Derivative of rwedge_max_tension() by alpha. At alpha = 1 it jumps from 4/pi to 0, which it is
 * there.                                                                                        new
 * NaN outside the domain. Relative error below 1e-14. */
RWEDGE_API double rwedge_max_tension_derivative(double alpha);

/* Elastic limit P/(bk): the load at first yield (von Mises, plane strain) in full sliding, or
 * under a normal load (f = 0).                                                         Figs. 3 to 5
 * It belongs to the global maximum of J2 over the half-plane. It is 0 for the sharp wedge, whose
 * stresses are infinite; but pi for nu = 0.5 and f = 0.
 *   alpha  0, or at least 1e-14: the J2 of smaller tips can be too flat for its maximum to be found
 * NaN outside the domain. Relative error below 1e-12. */
RWEDGE_API double rwedge_elastic_limit(double alpha, double f, double nu);

/* The same for n pairs alpha[i], f[i]. Nothing is written unless every pair is in the domain. */
RWEDGE_API int32_t rwedge_elastic_limits(size_t n, const double alpha[], const double f[],
                                         double nu, double limit[]);

/* How the elastic limit changes with alpha, f and nu, and on which branch it is. At the critical
 * friction the gradient jumps. At alpha = 1 d_alpha does, to 0: beyond, the limit is constant.
 *                                                                                               new
 *   alpha       at least 1e-14
 *   d_alpha     d/dalpha of the limit
 *   d_f         d/df, 0 for f = 0
 *   d_nu        d/dnu
 *   at_surface  1 where it yields at the surface, 0 where below it
 * RWEDGE_EDOMAIN, RWEDGE_ENULL. Error below 1e-11 of the larger of the derivative and the limit,
 * for d_alpha over alpha, where the maximum is not flat and f <= 100. */
RWEDGE_API int32_t rwedge_elastic_limit_gradient(double alpha, double f, double nu, double *d_alpha,
                                                 double *d_f, double *d_nu, double *at_surface);

/* The elastic limit and where it yields: y = 0 is at the surface.                            Fig. 5
 *   alpha  0, or at least 1e-14
 *   limit  the elastic limit, P/(bk)
 * The sharp wedge yields at its apex. For nu = 0.5 and alpha >= 1 the whole surface of the
 * contact is equally stressed.
 * RWEDGE_EDOMAIN, RWEDGE_ENULL. Error of the place about 1e-12 where the maximum is not flat. */
RWEDGE_API int32_t rwedge_yield_point(double alpha, double f, double nu, double *limit, double *x,
                                      double *y);

/* The elastic limit has two branches, below the surface and at it. It is the smaller of the two,
 * and the cusps of Fig. 4 are where they cross. Each branch is smooth in alpha, f and nu, so that
 * each can be interpolated.                                                             Fig. 4; new
 *
 * Below the surface: the local maximum of J2 that is on the axis for f = 0. Large f and small
 * alpha have none: RWEDGE_EABSENT.
 *   alpha  0, or at least 1e-14
 *   limit  P/(bk) at which this place yields
 * RWEDGE_EDOMAIN, RWEDGE_ENULL. */
RWEDGE_API int32_t rwedge_subsurface_yield(double alpha, double f, double nu, double *limit,
                                           double *x, double *y);

/* At the surface: the maximum of J2 over y = 0. It is at 0 <= x <= min(alpha, 1). RWEDGE_EABSENT
 * for nu = 0.5 and f = 0, where J2 is 0 on the surface.
 *   alpha  0, or at least 1e-14
 *   limit  P/(bk) at which this place yields
 * RWEDGE_EDOMAIN, RWEDGE_ENULL.                                                      Fig. 4; new */
RWEDGE_API int32_t rwedge_surface_yield(double alpha, double f, double nu, double *limit,
                                        double *x);

/* Shakedown limit P/(bk): the load that a pad or stylus carries pass after pass. Below it the
 * half-plane may yield in the first passes, and is elastic from then on, because residual stresses
 * stay. Von Mises, plane strain, perfect plasticity, small strain; the contact slides from far to
 * far, again and again, in one direction or both, with the same P and f. For such passes Melan's
 * theorem is exact: lib/README.md, "Shakedown".                                                 new
 *   alpha  0, or at least 1e-3
 *   limit  receives P/(bk)
 *   y      depth that governs, in b; 0 is the surface
 * The sharp wedge has the limit 0, but for f = 0 with nu = 0.5. For Hertz' contact Johnson's limit
 * at the surface, k over f, is 4 to 10 % too high for von Mises with nu = 0.3: szz does not follow
 * the residual stress.
 * RWEDGE_EDOMAIN; RWEDGE_ENULL. The limit is exact to 1e-10, the depth to 1e-6. It takes as long as
 * some 25 elastic limits. */
RWEDGE_API int32_t rwedge_shakedown_limit(double alpha, double f, double nu, double *limit,
                                          double *y);

/* The shakedown limit of the highest local maximum below the surface. With that of the surface it
 * makes two branches, which interpolate better than the smaller of them.                        new
 *   alpha  as above
 *   limit  receives P/(bk)
 *   y      its depth, in b; deeper than 0.01 b and 0.01 a
 * RWEDGE_EABSENT where there is no such maximum: the surface governs. RWEDGE_EDOMAIN; RWEDGE_ENULL.
 * The limit is exact to 1e-10. */
RWEDGE_API int32_t rwedge_subsurface_shakedown(double alpha, double f, double nu, double *limit,
                                               double *y);

/* The shakedown limit of the surface.                                                           new
 *   alpha  as above
 *   limit  receives P/(bk)
 * RWEDGE_EABSENT for f = 0 with nu = 0.5: there is no deviator. RWEDGE_EDOMAIN; RWEDGE_ENULL.
 * The limit is exact to 1e-10. */
RWEDGE_API int32_t rwedge_surface_shakedown(double alpha, double f, double nu, double *limit);

/* Critical friction: the f at which yield jumps from below to the surface. It is 0 where yield is
 * at the surface without friction already. (The smallest of these tips, a/b < 0.0026, yield
 * below the surface again in an interval of f: lib/README.md.)                          Fig. 4; new
 *   alpha  0, or at least 1e-14; the sharp wedge yields at its apex: 0
 * NaN outside the domain. Error below 1e-11 f, or 1e-14/f next to its zero, from which it rises
 * like a square root. */
RWEDGE_API double rwedge_critical_friction(double alpha, double nu);

/* ---- Unlike bodies --------------------------------------------------------------------------- */

/* Where the bodies are unlike, friction acts on the pressure. The contact of a wedge in full
 * sliding, in its own half-width b, depends on alpha and the product of beta and f, for Q > 0: for
 * Q < 0 it is the mirror image of that with -beta_f. lib/README.md, "Unlike bodies in full
 * sliding".
 *   alpha   0, or 1e-3 to 1000: a/b
 *   beta_f  |beta_f| <= 1: rwedge_dundurs_beta() of half-plane and wedge, in this order, times f
 *   held    0 <= held <= 1: 1 where a rig holds the wedge's rotation, its tilt being 0; 0 where it
 *           turns until it has no moment about x = 0 */

/* The contact law of unlike bodies that slide.                                                  new
 *   AP_over_theta_b  receives the load; rwedge_load() for beta_f = 0
 *   middle           receives the middle of the contact, in b: below 0 on the side of the trailing
 *                    edge
 *   tilt             receives the tilt over theta, as rwedge_contact_tilt() has it: 0 where it is
 *                    held
 *   tension          receives b s1/(fP) at the trailing edge; rwedge_max_tension() for beta_f = 0
 * RWEDGE_EDOMAIN; RWEDGE_ENULL. In the tests it was right to 1e-13. */
RWEDGE_API int32_t rwedge_sliding_law(double alpha, double beta_f, int32_t held,
                                      double *AP_over_theta_b, double *middle, double *tilt,
                                      double *tension);

/* The elastic limit P/(bk) of unlike bodies that slide, and where they yield.                   new
 *   f      0 <= f <= 1e6; |beta_f| <= f/2
 *   limit  receives P/(bk); rwedge_elastic_limit() for beta_f = 0; 0 for the sharp wedge
 *   x, y   each receives one number: the place, in b from the apex
 * RWEDGE_EDOMAIN where |beta_f| is above f/2; RWEDGE_ENULL; RWEDGE_ENOMEM; RWEDGE_ERANGE. In the
 * tests the limit was right to 1e-12 for beta_f = 0; the place is that of a search, to about 1e-7.
 * It takes as long as rwedge_contact_yield_factor(). */
RWEDGE_API int32_t rwedge_sliding_limit(double alpha, double beta_f, double f, double nu,
                                        int32_t held, double *limit, double *x, double *y);

/* An estimate of what neglecting beta costs in partial slip: that of a contact that slides under Q,
 * as if friction were Q/P. In cycles of Q under constant P fully coupled boundary elements find a
 * change of the tension of the same sign: 0.5 to 1.3 times the estimate for a wedge or a cylinder
 * that is held, 1.4 to 3 times for one that is free. Under other loads, such as a bulk tension out
 * of phase, and with other pads it may be far larger: lib/README.md.                            new
 *   beta       |beta| <= 1/2: rwedge_dundurs_beta() of half-plane and wedge
 *   f          0 <= f <= 1e6; |beta f| Q/(fP) <= 1
 *   Q_over_fP  0 <= Q_over_fP <= 1
 *   swing      receives how far the contact moves, in b; below 0 to the side of the trailing edge
 *   tension    receives by which part sxx beside the trailing edge is higher, 0.06 b from where the
 *              contact ends at most
 * RWEDGE_EDOMAIN where |beta f| Q/(fP) is above 1; RWEDGE_ENULL. */
RWEDGE_API int32_t rwedge_coupling(double alpha, double beta, double f, double Q_over_fP,
                                   int32_t held, double *swing, double *tension);

/* ---- Validity -------------------------------------------------------------------------------- */

/* What makes results doubtful: the bits of rwedge_validity(). Values never change; new ones are
 * added at the end. */
enum {
    RWEDGE_DOUBT_ANGLE = 1,    /* theta above 0.1 rad: the wedge is hardly a half-plane */
    RWEDGE_DOUBT_COUPLING = 2, /* dissimilar bodies with friction, whose coupling is neglected */
    RWEDGE_DOUBT_YIELD = 4,    /* a load above that of first yield */
    RWEDGE_DOUBT_ROUNDING = 8, /* a/b below 0.01 or above 10000: mixed units? */
    RWEDGE_DOUBT_STRENGTH = 16 /* k/E below 0.00001 or above 0.1: mixed units? */
};

/* What makes the results for such a contact doubtful, as a sum of bits: rwedge_validity_text()
 * says what each means. The sum is 0 where nothing is doubtful. For what is not known give NaN,
 * which adds no doubt; 0 adds none either, except as safety.                                    new
 *   theta     any number; the angle between flank and surface, rad
 *   alpha     a/b under the load, any number; 0 is the sharp wedge
 *   beta      any number; rwedge_dundurs_beta(), or 0 where rwedge_contact_set_beta() has been told
 *   f         any number; the coefficient of friction
 *   k_over_E  any number; yield stress in pure shear over Young's modulus of the half-plane
 *   safety    any number; rwedge_yield_load() over P, or that of rwedge_contact_yield_factor() */
RWEDGE_API int32_t rwedge_validity(double theta, double alpha, double beta, double f,
                                   double k_over_E, double safety);

/* What one bit of rwedge_validity() means, in English: a line for messages. Empty for any other
 * number. To list all bits, go through 1, 2, 4 ... until the text is empty.
 * Static text, never NULL.
 *   doubt  any integer */
RWEDGE_API const char *rwedge_validity_text(int32_t doubt);

/* ---- Dimensional quantities ------------------------------------------------------------------ */

/* From here to the series, units are any consistent set. Arguments that many functions share:
 *   theta  angle between flank and surface, rad, 0 < theta < pi/2; the theory is that of small
 *          angles
 *   a      half-width of the rounding, length, finite, >= 0; 0 is the sharp wedge
 *   A      composite compliance, 1/stress, finite, > 0: rwedge_compliance()
 *   f      coefficient of friction, 0 <= f <= 1e6
 *   k      yield stress in pure shear, stress, finite, > 0
 *   P      normal force per unit length
 *   Q      tangential force per unit length
 * The functions that return a double give NaN outside the domain, and where the result or a/b
 * leaves it. */

/* Radius of the rounding, R = a/theta, length.                                            Sec. 2 */
RWEDGE_API double rwedge_radius(double theta, double a);

/* Half-width of the rounding from its radius, a = R theta, length.                           Sec. 2
 *   R  radius, length, finite, >= 0 */
RWEDGE_API double rwedge_rounding(double theta, double R);

/* Half-width b of the contact under the load P, length.                Eq. (7), (11), (15), inverse
 *   P  finite, >= 0; 0 gives 0
 * Relative error below 1e-14. Inverse: rwedge_normal_load(). */
RWEDGE_API double rwedge_half_width(double theta, double a, double A, double P);

/* The load P whose contact has the half-width b, force/length.                  Eq. (7), (11), (15)
 *   b  length, finite, >= 0; 0 gives 0
 * Relative error below 1e-14. Inverse: rwedge_half_width(). */
RWEDGE_API double rwedge_normal_load(double theta, double a, double A, double b);

/* The load P at which a given contact first yields in full sliding, or under a normal load (f =
 * 0), force/length. The contact grows with P, and the elastic limit depends on a/b: P is the root
 * of an equation.                                                                      Figs. 3 to 5
 *   nu  Poisson's ratio of the half-plane, 0 <= nu <= 0.5
 * It is 0 for the sharp wedge. It is HUGE_VAL where the contact does not yield before it is 1e14
 * a wide. For f = 0 and nu = 0.5 it never yields if k > (2/pi) theta/A: the deviator stays
 * bounded however large the load. Relative error below 1e-11, and 1e-15 dlnP/dlnk, which is large
 * for f = 0 and nu near 0.5. */
RWEDGE_API double rwedge_yield_load(double theta, double a, double A, double f, double nu,
                                    double k);

/* The load P up to which a given contact in full sliding shakes down, force/length: at it P/(bk) is
 * the shakedown limit of its a/b.                                                               new
 *   nu  Poisson's ratio of the half-plane, 0 <= nu <= 0.5
 * It is 0 for the sharp wedge, and HUGE_VAL where the contact is 1000 a wide before it is reached.
 * For f = 0 and nu = 0.5 it is infinite if k > 0.386 theta/A. To 1e-9 of the load, times dlnP/dlnk.
 */
RWEDGE_API double rwedge_shakedown_load(double theta, double a, double A, double f, double nu,
                                        double k);

/* ---- Profiles that were measured ------------------------------------------------------------- */

/* The convex hull of a profile by its heights: the largest convex profile that is nowhere above
 * them. Heights that are convex to rounding stay as they are.                                  new
 *   n       number of places, 2 to 2^24
 *   x       length, finite: of each place, from left to right, no two equal
 *   height  length, finite: of the pad above the half-plane
 *   hull    receives n numbers, length
 * RWEDGE_EDOMAIN where a place is not right of the one before; RWEDGE_ENULL; RWEDGE_ENOMEM. */
RWEDGE_API int32_t rwedge_profile_hull(size_t n, const double x[], const double height[],
                                       double hull[]);

/* The slopes of a profile by its heights, of their convex hull, as rwedge_contact_create_profile()
 * takes them: the slope of the line between two places is the slope in their middle. The last place
 * is the last of x, with the slope before it: there are n, and the profile is the same.         new
 *   n       as above
 *   x       as above
 *   height  as above
 *   place, slope  each receives n numbers: length; number
 * Where a slope is pi/2 or more, no contact can be made of them.
 * RWEDGE_EDOMAIN where a place is not right of the one before; RWEDGE_ENULL; RWEDGE_ENOMEM. */
RWEDGE_API int32_t rwedge_profile_slopes(size_t n, const double x[], const double height[],
                                         double place[], double slope[]);

/* How many places rwedge_profile_fit() gives: one more than arcs, where these are 1 to 16, else 17.
 *                                                                                               new
 *   arcs  any integer */
RWEDGE_API size_t rwedge_profile_places(int32_t arcs);

/* The convex profile that is nearest to heights in least squares. It is made of arcs, each of one
 * curvature, between places that are looked for too; their number is the one for which Schwarz's
 * criterion (BIC) is lowest, unless it is given.
 *                            Lawson and Hanson, Solving Least Squares Problems (1974), ch. 23; new
 *   n       number of heights, 8 to 2^24
 *   x       length, finite: of each height, from left to right; two may be equal
 *   height  length, finite: of the pad above the half-plane
 *   arcs    how many arcs, 0 <= arcs <= 16; 0 for as many as the heights ask for
 *   m       number of places, rwedge_profile_places() or fewer, 2 to 17: there are fewer arcs
 *   place, slope  each receives m numbers: where arcs begin and end, length; the slope there.
 *                 Places that are not needed repeat the last one: they may stay in a profile,
 *                 and there are as many arcs as other places
 *   level   receives the height at the first place, length
 *   rms     receives the root of the mean square of what is left of the heights, length: the noise
 * The slope between places is linear: level, place and slope give the height everywhere.
 * RWEDGE_EDOMAIN where a place is left of the one before, where all heights or all places are
 * equal, and where arcs >= m; RWEDGE_EABSENT where the heights are those of no one pad: of a plane,
 * of one that points down, or of two contacts with a pocket between them that is deeper than the
 * noise; RWEDGE_ENULL; RWEDGE_ENOMEM; RWEDGE_ENOCONV. A place is found to 1/8192 of the length. */
RWEDGE_API int32_t rwedge_profile_fit(size_t n, const double x[], const double height[],
                                      int32_t arcs, size_t m, double place[], double slope[],
                                      double *level, double *rms);

/* ---- A contact with a load history ----------------------------------------------------------- */

/* One contact and what it remembers of its loads. It is exact for any history of P and Q: see
 * lib/README.md, "Load histories". Lengths are not in b here: x and y are in the unit of a,
 * stresses in that of 1/A, and 0 is the centre of the contact. rwedge_contact_create() and _copy()
 * make a handle, rwedge_contact_destroy() frees it. Different handles are independent. One handle
 * may be read by many threads at a time. While one thread loads it, no other may use it.
 *
 * Accuracy. The half-width b has a relative error below 1e-14. A remembered load has the rounding
 * error of the largest load. Where Q/f changed by D times the change of P, it has that error over
 * (1 - |D|). The half-width that belongs to the load, such as c, has the same relative error. The
 * functions below promise their accuracy for these half-widths as they are. Next to an edge, the
 * error of a half-width changes tractions and stresses too. Where two loads differ by less than
 * 1 %, the errors of q, of the stresses and of the slip are larger in proportion. */
typedef struct rwedge_contact rwedge_contact;

/* A contact without load, separated.
 *   contact  receives the handle
 * RWEDGE_EDOMAIN where theta/A leaves the domain too; RWEDGE_ENULL; RWEDGE_ENOMEM. */
RWEDGE_API int32_t rwedge_contact_create(double theta, double a, double A, double f,
                                         rwedge_contact **contact);

/* The same for a flat pad with rounded edges: flat over |x| < a, of the radius R beyond. It is a
 * cylinder for a = 0.                                                                           new
 *   a  half-width of the flat, length, finite, >= 0
 *   R  radius of the edges, length, > 0, at most 1e60
 * Its slope is (|x| - a)/R beyond the flat, as far as |x| = a + R: a load that would bring the
 * contact farther is refused with RWEDGE_ERANGE. Where a function below names theta, it is 1 for
 * this pad. All functions serve it as they serve the wedge. The errors are those of the wedge, over
 * the root of 1 - a/b.
 * RWEDGE_EDOMAIN; RWEDGE_ENULL; RWEDGE_ENOMEM. */
RWEDGE_API int32_t rwedge_contact_create_flat(double a, double R, double A, double f,
                                              rwedge_contact **contact);

/* The same for any convex profile, given by its slopes: linear between the places, constant beyond.
 * The contact of an asymmetric profile is off the centre, and tilted, under P alone. The stresses
 * at a point take 3 times as long as a wedge's with 4 arcs in contact, 40 times with 100.       new
 *   x      length, finite: of each place, from left to right; equal places are a kink
 *   slope  finite, |slope| < pi/2: the slope there, positive where the profile rises to the right
 * RWEDGE_EDOMAIN where a place or a slope is less than the one before, where all slopes are equal,
 * and unless 2 <= n <= 1000; RWEDGE_ENULL; RWEDGE_ENOMEM. */
RWEDGE_API int32_t rwedge_contact_create_profile(size_t n, const double x[], const double slope[],
                                                 double A, double f, rwedge_contact **contact);

/* Kinds of pads. */
enum {
    RWEDGE_PAD_WEDGE = 0,    /* theta, a: rwedge_contact_create() */
    RWEDGE_PAD_CYLINDER = 1, /* R: rwedge_contact_create_flat() with a = 0 */
    RWEDGE_PAD_FLAT = 2,     /* a, R: rwedge_contact_create_flat() */
    RWEDGE_PAD_PROFILE = 3   /* places: rwedge_contact_create_profile() */
};

/* The kind of the contact's pad, RWEDGE_PAD_WEDGE and so on; -1 for NULL.                   new */
RWEDGE_API int32_t rwedge_contact_kind(const rwedge_contact *contact);

/* The numbers with which a contact was created, to the same bits; 0 for one that its kind of pad
 * does not have.                                                                                new
 *   theta  angle of the flanks, rad: of a wedge
 *   a      half-width of the rounding or of the flat, length: of a wedge and of a flat pad
 *   R      radius, length: of a cylinder and of the edges of a flat pad
 *   A      composite compliance, 1/stress
 *   f      coefficient of friction
 * RWEDGE_ENULL. */
RWEDGE_API int32_t rwedge_contact_pad(const rwedge_contact *contact, double *theta, double *a,
                                      double *R, double *A, double *f);

/* How many places rwedge_contact_places() gives; 0 for NULL.                                 new */
RWEDGE_API size_t rwedge_contact_place_count(const rwedge_contact *contact);

/* The pad, of any kind, as places with slopes: rwedge_contact_create_profile() takes them.      new
 *   n      rwedge_contact_place_count()
 *   x      receives n numbers, length: the places, from left to right; equal places are a kink
 *   slope  receives n numbers: the slopes there
 * Places inside a part of one slope are left out.
 * RWEDGE_ERANGE where n is another number; RWEDGE_ENULL. x has the bits that were given; the slopes
 * are sums, each rounded. */
RWEDGE_API int32_t rwedge_contact_places(const rwedge_contact *contact, size_t n, double x[],
                                         double slope[]);

/* How much a bulk tension stretches the surface of the half-plane against that of the wedge: A/4 of
 * the tension unless it is set. That is right for bodies of equal compliance. For others it is
 * (1 - nu1^2)/E1 of the tension, E1 and nu1 being those of the half-plane.                      new
 *   strain_per_tension  strain over tension, 1/stress, finite, >= 0, also over A
 * RWEDGE_EDOMAIN where the bodies touch: it is set before the first load, or when they are
 * separated; RWEDGE_ENULL. */
RWEDGE_API int32_t rwedge_contact_set_strain(rwedge_contact *contact, double strain_per_tension);

/* The strain per bulk tension, 1/stress: A/4, or that of rwedge_contact_set_strain(), to rounding.
 *                                                                                               new
 * NaN for NULL. */
RWEDGE_API double rwedge_contact_strain(const rwedge_contact *contact);

/* From now on the contact has unlike bodies, whose shear acts on the pressure. A new contact
 * neglects that: beta is 0. Without friction beta changes nothing. Full sliding, |Q| = f P, is
 * exact. Other loads are computed where rwedge_contact_allow_error() allows it, and are refused
 * with RWEDGE_EPATH where it does not.                                                          new
 *   beta  |beta| <= 1/2: rwedge_dundurs_beta() of the half-plane and the pad, in this order
 * With mu = -beta f, or beta f where Q < 0, and N = -p, the contact solves
 *     (1/pi) PV int N/(x-s) ds - mu N = (A/theta) (slope of the pad less the tilt).
 * N falls to the left edge like the distance to the power 1/2 - atan(mu)/pi, to the right one like
 * 1/2 + atan(mu)/pi. The tension beside the trailing edge is 2 f (slope of the pad less the
 * tilt)/A, as for similar bodies.
 * In full sliding slip, energy and displacement are not known, RWEDGE_EPATH or NaN, as of any
 * contact off the centre. Edges, tilt, pressure and stresses then err by less than 1e-12 of the
 * values for |mu| <= 1 and arcs longer than 1/100 of the half-width; a shorter arc that ends nearer
 * to an edge of the contact than 16 times its length multiplies the error by the half-width over
 * its length.
 * In partial slip, with a tolerance of 1e-3 and |beta| <= 0.2, edges err by less than 1e-3 of the
 * half-width, q by 5e-4 of f times the peak pressure in the mean, the stress beside the contact by
 * 0.5 % of its largest value, the energy of a cycle by 1 %; rwedge_contact_error() estimates how
 * much q errs at most away from fronts: in the tests it erred by more at 2 of 181 places, 1.3 times
 * as much. A load takes a tenth of a second to one, some seconds where P rises as Q turns round.
 * The first load, in whatever proportion of P, M or tilt, Q and sigma, is summed up on 160 cells
 * from touching on, with what slips meanwhile, in an eighth of a second; q then errs by 1e-4 to
 * 1e-3 of f times the peak pressure in the mean, whatever the tolerance. Of 350 random ones, |beta|
 * <= 1/4, 0.15 <= f <= 0.9, |Q| <= 0.95 f P, all converged. A symmetric pad that is not tilted and
 * is pressed along P alone is known in closed form where that errs by less than the tolerance:
 * by 0.1 |beta|^3/f + exp(-pi f/|beta|) in the mean. RWEDGE_ENOCONV for a first load of which M/P
 * would tilt the pad off a small contact, or sigma drags nearly all of it.
 * rwedge_contact_edge_asymptotes() gives RWEDGE_EABSENT; rwedge_contact_permanent_stick(),
 * rwedge_contact_worn_zone() and rwedge_contact_full_wear() give RWEDGE_EPATH. All other functions
 * serve such a contact.
 * RWEDGE_EDOMAIN where the bodies touch: it is set before the first load, or when they are
 * separated; RWEDGE_ENULL; RWEDGE_ENOMEM. */
RWEDGE_API int32_t rwedge_contact_set_beta(rwedge_contact *contact, double beta);

/* The beta of rwedge_contact_set_beta(), 0 unless it is set.                                    new
 * NaN for NULL. */
RWEDGE_API double rwedge_contact_beta(const rwedge_contact *contact);

/* Sets what follows from the bodies, beside the compliance: rwedge_contact_set_beta() and
 * rwedge_contact_set_strain(), so that neither is forgotten.                                    new
 *   E1, nu1, E2, nu2  as for rwedge_compliance(): of the half-plane, of the pad
 * RWEDGE_EDOMAIN where the bodies touch, where their compliance is not that of the contact, to
 * 1e-6, and as the two functions have it; RWEDGE_ENULL; RWEDGE_ENOMEM. The contact is then as
 * before. */
RWEDGE_API int32_t rwedge_contact_set_bodies(rwedge_contact *contact, double E1, double nu1,
                                             double E2, double nu2);

/* Takes a layer on a rigid base without friction for the half-plane: of the thickness t, or of 2 t
 * between two opposite pads under equal loads. Under a constant P it is as if the pad had the slope
 * 0.3317 A1 P x/t^2 besides, A1 being twice the strain of rwedge_contact_set_strain(), which is set
 * before. The pad is of the kind RWEDGE_PAD_PROFILE from then on.                               new
 *   t  length, > 0: at least twice the half-width under P
 *   P  > 0: the load, which is not to change
 * The half-width errs by 0.2 to 0.3 (b/t)^4 A1/A. Left out: P stretches the surface as a bulk
 * tension of 0.4893 P/t does; Q tilts the surface by 0.2446 A1 Q/t, and changes its strain by
 * 0.0871 A1 Q x/t^2 beside what it does to a half-plane.
 * RWEDGE_EDOMAIN where the bodies touch, where the pad is held, and where a slope becomes pi/2;
 * RWEDGE_ERANGE where t is less than twice the half-width; RWEDGE_ENULL; RWEDGE_ENOMEM. */
RWEDGE_API int32_t rwedge_contact_set_thickness(rwedge_contact *contact, double t, double P);

/* An independent copy, history and all: to try a load and go back.
 * RWEDGE_ENULL, RWEDGE_ENOMEM. */
RWEDGE_API int32_t rwedge_contact_copy(const rwedge_contact *contact, rwedge_contact **copy);

/* Frees; NULL is allowed. */
RWEDGE_API void rwedge_contact_destroy(rwedge_contact *contact);

/* The next point of the history, reached in a straight line of the (P, Q) plane from the last one.
 *                                                                                     Sec. 3.2; new
 *   P  0, or 1e-60 to 1e60; not below 1e-8 of the last P: but 0 may follow any load. 0 separates
 *      the bodies (Q must then be 0 too): all but the dissipated energy is forgotten
 *   Q  |Q| <= f P; equality is full sliding, to 8 epsilon of f times the larger of P and the last
 *      P, or the largest P since it slides: a ramp may be interpolated in any number of steps
 * RWEDGE_ESLIDING where |Q| > f P. RWEDGE_EDOMAIN. RWEDGE_ERANGE where the half-width, a/b, the
 * peak pressure or the energy leaves the domain. RWEDGE_ERANGE too where P is not 0 but below 1e-8
 * of the last P, because the rounding of the last P would blur Q/(fP): go there in two loads.
 * RWEDGE_EPATH after a moment or another tension, as rwedge_contact_apply(). RWEDGE_ENOCONV after
 * rwedge_contact_allow_error(). RWEDGE_ENULL;
 * RWEDGE_ENOMEM. Unless RWEDGE_OK, the contact is as before. It remembers at most two points of the
 * history per load, and only while its tractions or its slip depend on them. */
RWEDGE_API int32_t rwedge_contact_load(rwedge_contact *contact, double P, double Q);

/* The next point of the history with a moment and a bulk tension, reached in a straight line in all
 * four loads.                                                                                   new
 *   P      0, or 1e-60 to 1e60; not below 1e-8 of the last P: as for rwedge_contact_load()
 *   M      moment about x = 0 per unit length, a force, finite; positive presses the right side; 0
 *          where P is 0
 *   Q      |Q| <= f P, as for rwedge_contact_load()
 *   sigma  bulk tension of the half-plane, stress, finite: added to its sxx. It stretches the
 *          surface against the wedge's, by A sigma/4 or as rwedge_contact_set_strain() says, and
 *          so makes it slip. Apply it while P is 0 to have it without slip
 * rwedge_contact_load() keeps M and sigma as they are, and drops M where P is 0. A load has a
 * closed form, and the result is exact: without friction; where |Q| = f P; without moment and under
 * one sigma, whatever P and Q do; under constant P and M, where both edges slip the same way, that
 * is |d sigma| <= 4 |dQ|/(pi s), s being the half-width of the contact, for a strain of A/4; where
 * both edges of the contact move outwards, or both inwards, and both slip the same way or stick;
 * where Q and sigma stay and the contact keeps the part that carries shear, or no part does. A
 * straight line may consist of such pieces. Other loads have no closed form. Two kinds of the loads
 * named have none either: the front of slip ends between two patches of the memory at one edge and
 * between two others at the other edge; or a part beyond the front sticks: lib/README.md, "Moment
 * and bulk tension". A line may pass such loads and end where there is a closed form. P and M count
 * as unchanged where they differ from the last ones by rounding: 4 epsilon of P, and of P |x| at
 * the edges. RWEDGE_EPATH where no closed form is shown: rwedge_contact_obstacle() says why.
 * RWEDGE_EDOMAIN where M tilts the wedge by theta (1 - 1e-9) or more, so that a flank nearly lies
 * on the surface. Other errors as those of rwedge_contact_load(): RWEDGE_ESLIDING; RWEDGE_ERANGE;
 * RWEDGE_ENOCONV; RWEDGE_ENULL; RWEDGE_ENOMEM. */
RWEDGE_API int32_t rwedge_contact_apply(rwedge_contact *contact, double P, double M, double Q,
                                        double sigma);

/* Holds the pad at its present tilt, as a rig does that guides it, or lets it turn again. M of the
 * loads of a held pad is ignored: rwedge_contact_loads() gives the moment that holds it. While the
 * bodies are apart, a pad is held as its profile was given, at the tilt 0.                      new
 *   held  0 <= held <= 1: 0 lets it turn, as a new contact does; 1 holds it
 * RWEDGE_EDOMAIN also where a profile without a load has no tilt 0, because all its slopes have one
 * sign; RWEDGE_ENULL; RWEDGE_ENOMEM. */
RWEDGE_API int32_t rwedge_contact_set_rotation(rwedge_contact *contact, int32_t held);

/* The next load of a held pad, at a tilt, which it keeps. It is reached in a straight line in P,
 * tilt, Q and sigma; a pad that touches has the tilt before. Load and tilt determine the contact as
 * load and moment do, just as smoothly. The pad keeps its tilt where P is 0.                    new
 *   P      0, or 1e-60 to 1e60; not below 1e-8 of the last P: as for rwedge_contact_load()
 *   tilt   rad, |tilt| < pi/2; as rwedge_contact_tilt() gives it: less than theta (1 - 1e-9) in
 *          magnitude, and of a profile between its outermost slopes
 *   Q      |Q| <= f P, as for rwedge_contact_load()
 *   sigma  finite, as for rwedge_contact_apply()
 * RWEDGE_EDOMAIN where the contact is not held by rwedge_contact_set_rotation(), or where the tilt
 * is too large. Loads that have a closed form at a changing tilt are those of
 * rwedge_contact_apply(); at a constant one, also those that touch or grow with Q in proportion to
 * P. Other errors as those of rwedge_contact_apply(): RWEDGE_EPATH; RWEDGE_ESLIDING; RWEDGE_ERANGE;
 * RWEDGE_ENOCONV; RWEDGE_ENULL; RWEDGE_ENOMEM. */
RWEDGE_API int32_t rwedge_contact_guide(rwedge_contact *contact, double P, double tilt, double Q,
                                        double sigma);

/* From now on, loads that have no closed form are computed instead of refused. The tolerance is the
 * error of q over f times the peak pressure. The closed form is used wherever it holds, to the same
 * bits. Where tractions have one of which slip or energy have none, these are computed beside it.
 * It holds again after full sliding, after separation, and, if P and M have not changed since,
 * after a load that slips past all that was computed.                                           new
 *   tolerance  0, or 1e-6 to 1e-2: 0, which a new contact has, refuses such loads with RWEDGE_EPATH
 * A load that adds twice the tolerance to the error is tried once more with ten times the
 * tolerance, and the better answer is taken. A load that adds more than ten times the tolerance
 * fails with RWEDGE_ENOCONV and leaves the contact as before: a larger tolerance may succeed. A
 * profile of n arcs in contact takes n times as long as a wedge. rwedge_contact_error() tells the
 * error that was reached.
 * RWEDGE_EDOMAIN; RWEDGE_ENULL. */
RWEDGE_API int32_t rwedge_contact_allow_error(rwedge_contact *contact, double tolerance);

/* The tolerance of loads that have no closed form: as rwedge_contact_allow_error() has it.      new
 * NaN for NULL. */
RWEDGE_API double rwedge_contact_tolerance(const rwedge_contact *contact);

/* Estimated error of q over f times the peak pressure; 0 while the state is in closed form. It
 * grows with the loads that the tractions still depend on, and may pass the tolerance. The estimate
 * leaves out places nearer than a hundredth of the half-width to an edge of a slip zone, present or
 * past, even within a load: q rises there like a root. At other places q erred by less than the
 * estimate in 99 of 100 random loads of P, M, Q and sigma, of 16,000 on four pads. In most of the
 * others it erred by up to 2.5 times as much, in one by 5 times. The worst known is 7 times.    new
 * NaN for NULL. */
RWEDGE_API double rwedge_contact_error(const rwedge_contact *contact);

/* Why rwedge_contact_apply() would return RWEDGE_EPATH for these loads, in English; empty where it
 * would not. The text also names loads that lead there, or near, another way. They were tried on a
 * copy: the contact stays as it is. These trials take as long as some loads. Another way is
 * another history.                                                                              new
 *   others  as in rwedge_contact_apply()
 * Static text, never NULL. */
RWEDGE_API const char *rwedge_contact_obstacle(const rwedge_contact *contact, double P, double M,
                                               double Q, double sigma);

/* The largest |d sigma| with which the present Q may change to another under constant P and M,
 * stress: 4 |dQ|/(pi s), for a strain of A/4 per tension. HUGE_VAL without friction, and where a
 * tension stretches nothing.                                                                    new
 *   Q  finite
 * NaN outside the domain; NaN for NULL; 0 when separated. Relative error as that of the edges. */
RWEDGE_API double rwedge_contact_largest_tension_step(const rwedge_contact *contact, double Q);

/* The present loads.                                                                            new
 *   P, M, Q, sigma  each receives one number
 * RWEDGE_ENULL. */
RWEDGE_API int32_t rwedge_contact_loads(const rwedge_contact *contact, double *P, double *M,
                                        double *Q, double *sigma);

/* The edges of the contact, left < x < right.                                                   new
 *   left, right  length
 * RWEDGE_EABSENT when separated; RWEDGE_ENULL. Error below 1e-14 of the width, or of |x| where that
 * is larger, over 1 - |tilt|/theta. */
RWEDGE_API int32_t rwedge_contact_edges(const rwedge_contact *contact, double *left, double *right);

/* How far the contact reaches beyond the corners of its flat, |x| = a of
 * rwedge_contact_create_flat(); below 0 where a corner is lifted. It keeps its digits where it is
 * small. Without a flat, how far the contact reaches from x = 0.                                new
 *   left, right  length
 * RWEDGE_EABSENT when separated; RWEDGE_ENULL. Relative error below 1e-14 without a moment; else
 * that of the edges. */
RWEDGE_API int32_t rwedge_contact_beyond_flat(const rwedge_contact *contact, double *left,
                                              double *right);

/* The outermost edges of the zones that stick. Friction is exhausted, |q| = f |p|, between these
 * edges and those of the contact. Without a closed form several zones may stick, and slip lies
 * between them: rwedge_contact_zones() has them all. The edges are those of the contact where it
 * slips nowhere.                                                                                new
 *   left, right  length
 * RWEDGE_EABSENT in full sliding, and when separated; RWEDGE_ENULL. After one step of Q and sigma
 * the error is that of the contact's edges, over the root of the part of P that the zone carries,
 * and with the zone's tilt where that is larger. */
RWEDGE_API int32_t rwedge_contact_stick_zone(const rwedge_contact *contact, double *left,
                                             double *right);

/* How many zones rwedge_contact_zones() gives for the contact as it is; 0 for NULL.          new */
RWEDGE_API size_t rwedge_contact_zone_count(const rwedge_contact *contact);

/* The zones of the contact that stick and slip, from left to right. Without a closed form there may
 * be several of each kind.                                                                      new
 *   n            rwedge_contact_zone_count()
 *   left, right  each receives n numbers, length: the edges of the zones
 *   slip         receives n numbers: 0 where it sticks, else -1 or 1, the sign of slip and of q,
 *                with which friction is exhausted
 * RWEDGE_ERANGE where n is another number; RWEDGE_ENULL. */
RWEDGE_API int32_t rwedge_contact_zones(const rwedge_contact *contact, size_t n, double left[],
                                        double right[], double slip[]);

/* The angle by which the moment tilts the wedge, rad: |tilt| < theta. Of a profile, the slope that
 * is taken off it, between its outermost slopes.                                                new
 * 0 without a moment, and when separated unless it is held; NaN for NULL. Error below 1e-14 theta,
 * where the edges have their relative error. */
RWEDGE_API double rwedge_contact_tilt(const rwedge_contact *contact);

/* How pressure and shear behave at the edges, at the distance r: |p| ~ K_N sqrt(r), and, as long as
 * slip is short, q ~ -K_T/sqrt(r), which slips over the length 2 |K_T|/(f K_N): to 0.1 % at Q/(fP)
 * = 0.001, 9 % at 0.1, 35 % at 0.5. Two contacts of the same K_N and K_T are alike at their edges:
 * this is how a pad is matched to a specimen.                                                   new
 *   normal_left, normal_right  K_N, stress over the root of a length
 *   shear_left, shear_right    K_T, stress times the root of a length, of the present Q and of
 *                              the strain by sigma less what it was when the bodies touched
 * RWEDGE_EABSENT when separated; RWEDGE_ENULL. K_N to 1e-14 of the larger one, of the edges that
 * rwedge_contact_edges() gives. */
RWEDGE_API int32_t rwedge_contact_edge_asymptotes(const rwedge_contact *contact,
                                                  double *normal_left, double *normal_right,
                                                  double *shear_left, double *shear_right);

/* The zone that never slips while loads go to and fro between two points in a straight line, once
 * the first cycles are over, whatever was before. It is all of the smaller contact where the ring
 * that opens and closes carries the change of Q and sigma.                                      new
 *   P1, P2          finite, >= 0, as for rwedge_contact_apply()
 *   M1, M2          finite; 0 where P is 0
 *   Q1, Q2          |Q| <= f P, as for rwedge_contact_load()
 *   sigma1, sigma2  finite
 *   left, right     its edges, length
 * It has the pad, the friction and the strain per tension of the contact, whose own loads do not
 * count.
 * RWEDGE_EABSENT where all slides at times, or separates; RWEDGE_EPATH where the edges slip in
 * opposite directions, or the contacts at the two points pass each other at one edge;
 * RWEDGE_ESLIDING, RWEDGE_EDOMAIN, RWEDGE_ERANGE, RWEDGE_ENULL, RWEDGE_ENOMEM. Error as that of
 * rwedge_contact_stick_zone(). */
RWEDGE_API int32_t rwedge_contact_permanent_stick(const rwedge_contact *contact, double P1,
                                                  double M1, double Q1, double sigma1, double P2,
                                                  double M2, double Q2, double sigma2, double *left,
                                                  double *right);

/* Half-width b of the contact, length; 0 when separated; NaN for NULL. Off the centre it is half of
 * the width.
 *                                                                   Eq. (7), (11), (15), inverse */
RWEDGE_API double rwedge_contact_half_width(const rwedge_contact *contact);

/* Half-width c of the stick zone, length: half of the distance between the edges that
 * rwedge_contact_stick_zone() gives. Outside it, c < |x| < b, friction is exhausted: |q| = f |p|. A
 * ring that came into contact with |dQ| = f dP, to rounding, counts as outside too, though
 * it has not slipped. c is b where all sticks, 0 in full sliding and when separated; NaN for NULL.
 *                                                                                  Eq. (25); new */
RWEDGE_API double rwedge_contact_stick_half_width(const rwedge_contact *contact);

/* How many points of its history the contact remembers: those that its tractions depend on, and
 * those that its slip is measured from. At most two per load, and some tens after any number of
 * loads that dither around one point; 0 when separated, and for NULL. The heap that the contact
 * takes grows in proportion. The time of its functions for a point of the half-plane grows at most
 * in proportion. */
RWEDGE_API size_t rwedge_contact_memory(const rwedge_contact *contact);

/* Pressure p and shear traction q at n points of the surface, stress: compression negative; q =
 * f p where it slips under Q > 0. Both are 0 for |x| >= b.        Eq. (8), (12), (14), (22) to (27)
 *   x     length, finite; not the apex 0 of a loaded sharp wedge
 *   p, q  each receives n numbers
 * RWEDGE_EDOMAIN; RWEDGE_ENULL. Nothing is written unless every point is in the domain.
 * Error of p as rwedge_pressure(), of q below 1e-13 f (theta/A + |p|). Off the centre that of p is
 * below 1e-13 (theta/A + |p|), and both are over 1 - |tilt|/theta. */
RWEDGE_API int32_t rwedge_contact_tractions(const rwedge_contact *contact, size_t n,
                                            const double x[], double p[], double q[]);

/* The largest pressure of a contact and its place, a magnitude. It is rwedge_peak_pressure(), in
 * the middle of the contact, where a wedge or a cylinder is not tilted or touches with its rounding
 * alone; else it is looked for.                                            Eq. (10), (16); new
 *   pressure  stress: to rounding what rwedge_contact_tractions() gives at x
 *   x         length; where it is looked for, to 1e-7 of the contact's width. Of two tops that are
 *             equal, as a flat pad has them, it is one
 * RWEDGE_EABSENT when separated, and where the pressure is infinite: at the apex of a sharp wedge,
 * and where a kink of a profile touches. RWEDGE_ENULL; RWEDGE_ENOMEM. */
RWEDGE_API int32_t rwedge_contact_peak_pressure(const rwedge_contact *contact, double *pressure,
                                                double *x);

/* The normal load under which the largest pressure of that pad is a given one: the inverse of
 * rwedge_contact_peak_pressure(), of a pad that is pressed alone, without a moment; or, where it is
 * held, at its present tilt. The present loads do not matter.                                   new
 *   pressure  stress, > 0, a magnitude
 *   P         receives one number
 * RWEDGE_EABSENT where no load has it, as with a sharp tip; RWEDGE_EDOMAIN; RWEDGE_ENULL;
 * RWEDGE_ENOMEM; of unlike bodies also what rwedge_contact_apply() says. As exact as that function:
 * in closed form to some 1e-14. */
RWEDGE_API int32_t rwedge_contact_peak_load(const rwedge_contact *contact, double pressure,
                                            double *P);

/* Stresses at n points (x, y) of the half-plane, tension positive.        Eq. (28), (32), (33); new
 *   x, y           length, finite, y >= 0; not the apex (0, 0) of a loaded sharp wedge
 *   sxx, syy, txy  each receives n numbers
 * RWEDGE_EDOMAIN; RWEDGE_ENULL. Nothing is written unless every point is in the domain.
 * Error below 1e-13 of what rwedge_stress() says, for every remembered point of the history, over 1
 * - |tilt|/theta. */
RWEDGE_API int32_t rwedge_contact_stresses(const rwedge_contact *contact, size_t n,
                                           const double x[], const double y[], double sxx[],
                                           double syy[], double txy[]);

/* Stresses at n points while the contact goes on through many loads: as rwedge_contact_apply() and
 * rwedge_contact_stresses() after each, to the same bits. It is faster: what a load leaves as it
 * was is not computed again.                                                                  new
 *   P              0, or 1e-60 to 1e60; not below 1e-8 of the last P: 0 may follow any
 *   M, Q, sigma    finite: loads numbers each, as P
 *   x, y           length, finite, y >= 0: n numbers each
 *   sxx, syy, txy  each receives loads * n numbers, the n of the first load first; not one of the
 *                  inputs
 * The contact then has the last of the loads. After an error the contact is as before and
 * nothing is written. RWEDGE_EDOMAIN where one of both functions has it; RWEDGE_EPATH;
 * RWEDGE_ESLIDING; RWEDGE_ERANGE; RWEDGE_ENOCONV; RWEDGE_ENULL; RWEDGE_ENOMEM. */
RWEDGE_API int32_t rwedge_contact_stress_history(rwedge_contact *contact, size_t loads,
                                                 const double P[], const double M[],
                                                 const double Q[], const double sigma[], size_t n,
                                                 const double x[], const double y[], double sxx[],
                                                 double syy[], double txy[]);

/* How many numbers rwedge_contact_state() gives for the contact as it is; 0 for NULL.        new */
RWEDGE_API size_t rwedge_contact_state_size(const rwedge_contact *contact);

/* The contact as numbers, for restarts and for other processes. A contact that is made of them
 * gives the same bits from then on. They have no other use. Their form has a version: this library
 * reads its own and those of older libraries.                                                   new
 *   n      rwedge_contact_state_size()
 *   state  receives n numbers
 * RWEDGE_ENULL; RWEDGE_ERANGE for another n. */
RWEDGE_API int32_t rwedge_contact_state(const rwedge_contact *contact, size_t n, double state[]);

/* The contact of such numbers.                                                                  new
 *   state    not other than rwedge_contact_state() gave it: HUGE_VAL and NaN may be in it
 *   contact  receives the handle
 * RWEDGE_EDOMAIN where the numbers are not those of a contact, RWEDGE_ENULL, RWEDGE_ENOMEM. Free
 * with rwedge_contact_destroy(). */
RWEDGE_API int32_t rwedge_contact_restore(size_t n, const double state[], rwedge_contact **contact);

/* Slip at n points of the surface, length: how far the half-plane's surface has moved tangentially,
 * relative to the wedge's, since the point last came into contact. It has the sign of q while it
 * grows, so that q d(slip) is the heat. It is 0 where a point has stuck ever since. In full
 * sliding the loads do not determine the rigid displacement. The slip is then the least that the
 * loads need: the centre of the contact is on the verge of slip.
 *                                                                             Eq. (17) to (21); new
 *   x     length, |x| <= b: points outside have no partner
 *   slip  receives n numbers
 * RWEDGE_EPATH off the centre once it has slid fully, unless rwedge_contact_drive() did it; and,
 * unless rwedge_contact_allow_error() allows errors, where rings of contact slipped at once when
 * they came into contact, or slipped after they had been added to others that slipped before.
 * RWEDGE_EDOMAIN; RWEDGE_ENULL. Nothing is written unless every point is in the domain.
 * Error below 1e-12 f theta b, for loads that differ by 1 % or more. */
RWEDGE_API int32_t rwedge_contact_slip(const rwedge_contact *contact, size_t n, const double x[],
                                       double slip[]);

/* The largest magnitude of the slip that rwedge_contact_slip() tells, and its place.            new
 *   slip  length; 0 where nothing has slipped
 *   x     length; the left edge where nothing has slipped
 * RWEDGE_EABSENT when separated; RWEDGE_EPATH as there; RWEDGE_ENULL. */
RWEDGE_API int32_t rwedge_contact_largest_slip(const rwedge_contact *contact, double *slip,
                                               double *x);

/* Energy dissipated by friction since the contact was created, per unit thickness (a force): the
 * time integral of the traction times the rate of slip over the contact, without the rigid
 * displacement in full sliding. It never falls. In a cycle under constant P it is the area of the
 * loop of Q over the rigid displacement.                                                        new
 * NaN for NULL. A load off the centre that slips while P or M change has no single integral: the
 * energy is computed if rwedge_contact_allow_error() allows errors. Otherwise, and after a load off
 * the centre that slides fully without rwedge_contact_drive(), it is NaN until the bodies have
 * separated. From the next load on it counts again, without what was dissipated in between.
 * Relative error of each load's share below 1e-12, plus epsilon times P over the change of Q/f
 * where slip reaches an older layer. Off the centre it is below 1e-12 plus 1e-14 times P over
 * the change of Q/f. Both grow with 1/(1 - |tilt|/theta), and with |x| at the edges over the
 * width where that is above 1. A load without a closed form under which P or M change has no
 * such accuracy: the shares of 99 of 100 random loads were right to 3 % or to 1e-6 of (f P)^2 A,
 * and those of all to 5 %. */
RWEDGE_API double rwedge_contact_dissipated_energy(const rwedge_contact *contact);

/* How far the present state is from first yield (von Mises, plane strain): k over the maximum of
 * sqrt(J2) over the half-plane. Loads times this factor would not just yield, because the contact
 * grows with them: see rwedge_yield_load().
 *   nu      Poisson's ratio of the half-plane, 0 <= nu <= 0.5
 *   factor  receives the factor: above 1 all is elastic; 0 where the stress is infinite, at the
 *           apex of the sharp wedge
 *   x, y    where the maximum is, length; each may be NULL
 * The search is for the global maximum, around each remembered edge of slip, at every scale. It
 * takes as long as the stresses at about 5000 points for a first load, at 20 000 where
 * rwedge_contact_memory() is 250, and at 30 000 where it is 1000. RWEDGE_EABSENT when separated:
 * there is no stress.
 * RWEDGE_EDOMAIN; RWEDGE_ENULL; RWEDGE_ERANGE where the factor leaves the domain. Relative error
 * below 1e-12. */
RWEDGE_API int32_t rwedge_contact_yield_factor(const rwedge_contact *contact, double nu, double k,
                                               double *factor, double *x, double *y);

/* The load P at which a pad of any kind first yields in full sliding, without moment and tension; a
 * pad that is held keeps its tilt. It slides to the side of the contact's present Q, and the
 * contact stays as it is. rwedge_yield_load() is the same for wedges, in less time.           new
 *   nu    Poisson's ratio of the half-plane, 0 <= nu <= 0.5
 *   P     receives the load, force/length: 0 where it yields under any load, as at a kink
 *   x, y  where it yields, length; each may be NULL
 * RWEDGE_EABSENT where no load that can be applied yields: a cylinder or flat pad is known as far
 * as its radius, and a profile with a slope of 0 at one end takes no load. RWEDGE_EDOMAIN;
 * RWEDGE_ENULL; RWEDGE_ENOMEM; RWEDGE_ERANGE. In the tests P was right to 1e-11. It takes the time
 * of rwedge_contact_yield_factor() about ten times. */
RWEDGE_API int32_t rwedge_contact_yield_load(const rwedge_contact *contact, double nu, double k,
                                             double *P, double *x, double *y);

/* How far the present state, in full sliding, is from the shakedown limit of repeated passes: k
 * over the smallest peak of sqrt(J2) that residual stresses can leave. A bulk tension changes
 * nothing.
 * rwedge_shakedown_limit() says what is assumed.                                                new
 *   nu      Poisson's ratio of the half-plane, 0 <= nu <= 0.5
 *   factor  receives the factor on the stresses; 0 where a kink of the profile is in the contact
 *   y       the depth that governs, length; may be NULL
 * RWEDGE_EABSENT unless all of the contact slides, or f is 0. RWEDGE_EDOMAIN; RWEDGE_ENULL;
 * RWEDGE_ERANGE where the factor leaves the domain. In the tests it was right to 1e-9 for wedges
 * and to 1e-10 for cylinders. */
RWEDGE_API int32_t rwedge_contact_shakedown_factor(const rwedge_contact *contact, double nu,
                                                   double k, double *factor, double *y);

/* The load P up to which a pad of any kind in full sliding shakes down, as
 * rwedge_contact_yield_load() has first yield. rwedge_shakedown_load() is the same for wedges.  new
 *   nu  Poisson's ratio of the half-plane, 0 <= nu <= 0.5
 *   P   receives the load, force/length: 0 where a kink of the profile is in every contact
 *   y   the depth that governs, length; may be NULL
 * RWEDGE_EABSENT as there; RWEDGE_EDOMAIN; RWEDGE_ENULL; RWEDGE_ENOMEM; RWEDGE_ERANGE. In the tests
 * P was right to 1e-8 for wedges and to 1e-9 for cylinders. */
RWEDGE_API int32_t rwedge_contact_shakedown_load(const rwedge_contact *contact, double nu, double k,
                                                 double *P, double *y);

/* The end of wear in partial slip: Q goes to and fro by Q_a about any mean, under the present P and
 * tilt, which stay. The zone that sticks in every cycle keeps its profile and in the end carries
 * everything; beside it so much is worn off that nothing presses. It is a limit, an upper bound of
 * this wear: how fast it comes, debris and a friction that changes are not in it. The zone is that
 * of P - Q_a/f under the same tilt, of rwedge_contact_permanent_stick() under constant P and M.
 * With the tilt held, the moment about the zone's middle ends as that zone's own; a pad that is
 * free to tilt keeps M instead, and ends like this only in the middle: lib/README.md, "The fully
 * worn pad".                                                                                    new
 *   Q_a                    force/length, finite, >= 0: half of the range of Q; 0 wears nothing
 *   left, right            edges of the zone that sticks, length
 *   worn_left, worn_right  as far as it wears, length
 *   area                   worn off on both sides, length^2
 * RWEDGE_ESLIDING where Q_a is f P or more: nothing sticks. RWEDGE_EABSENT where the bodies are
 * apart; RWEDGE_EPATH where they are unlike; RWEDGE_EDOMAIN; RWEDGE_ENULL; RWEDGE_ERANGE where it
 * would wear beyond the known profile. In the tests edges and area were right to 1e-10. */
RWEDGE_API int32_t rwedge_contact_worn_zone(const rwedge_contact *contact, double Q_a, double *left,
                                            double *right, double *worn_left, double *worn_right,
                                            double *area);

/* The largest depth that is worn off at the end of wear, and its place.                         new
 *   Q_a    as above
 *   depth  length
 *   x      length: the right one of two that are equal
 * RWEDGE_ESLIDING, RWEDGE_EABSENT, RWEDGE_EPATH as above; RWEDGE_EDOMAIN; RWEDGE_ENULL;
 * RWEDGE_ERANGE. In the tests the depth was right to 1e-10. */
RWEDGE_API int32_t rwedge_contact_deepest_wear(const rwedge_contact *contact, double Q_a,
                                               double *depth, double *x);

/* What is worn off at n places, and the pressure that is left, at the end of wear.             new
 *   Q_a    as above
 *   x      length, finite; not an edge of the zone that sticks, where the pressure is infinite, nor
 *          the apex of a sharp wedge in it
 *   depth  receives n numbers, length
 *   p      receives n numbers, stress, negative as in rwedge_contact_tractions(); 0 outside the
 *          zone
 * RWEDGE_ESLIDING, RWEDGE_EABSENT, RWEDGE_EPATH as above; RWEDGE_EDOMAIN; RWEDGE_ENULL;
 * RWEDGE_ERANGE. In the tests both were right to 1e-10. */
RWEDGE_API int32_t rwedge_contact_full_wear(const rwedge_contact *contact, double Q_a, size_t n,
                                            const double x[], double depth[], double p[]);

/* ---- A cycle of loads ------------------------------------------------------------------------ */

/* What a contact undergoes in a cycle of loads, reached one after the other in straight steps, as
 * by rwedge_contact_apply(). rwedge_cycle_create() goes through the loads once, and keeps of each
 * state what the questions need; rwedge_cycle_destroy() frees it. A cycle does not change: any
 * number of threads may ask it at a time. The contact that it was made from may change or be freed.
 *   loads          number of loads of the cycle, rwedge_cycle_loads()
 *   nu             Poisson's ratio of the half-plane, 0 <= nu <= 0.5
 *   plane_stress   0 <= plane_stress <= 1: 0 for plane strain, 1 for plane stress */

/* A cycle of loads that a contact has gone through. */
typedef struct rwedge_cycle rwedge_cycle;

/* The measures of a cycle. Values never change; new ones are added at the end. */
enum {
    RWEDGE_MEASURE_STRESS_RANGE = 0,
    RWEDGE_MEASURE_SWT = 1,
    RWEDGE_MEASURE_FATEMI_SOCIE = 2,
    RWEDGE_MEASURE_SLIP_RANGE = 3,
    RWEDGE_MEASURE_RUIZ_F1 = 4,
    RWEDGE_MEASURE_RUIZ_F2 = 5,
    RWEDGE_MEASURE_ENERGY_PER_AREA = 6,
    RWEDGE_MEASURE_FINDLEY = 7,
    RWEDGE_MEASURE_MODIFIED_WOHLER = 8,
    RWEDGE_MEASURE_MCDIARMID = 9,
    RWEDGE_MEASURE_CROSSLAND = 10,
    RWEDGE_MEASURE_DANG_VAN = 11,
    RWEDGE_MEASURE_SWT_IN_PLANE = 12,
    RWEDGE_MEASURE_FATEMI_SOCIE_IN_PLANE = 13
};

/* A cycle of a contact, which starts from the contact as it is, and leaves it so. For a steady
 * state load the contact with the cycle first: once under constant P and M, twice where they
 * change, some times more where loads have no closed form.                                      new
 *   loads        number of loads, >= 1
 *   P            0, or 1e-60 to 1e60; not below 1e-8 of the last P: 0 may follow any
 *   M, Q, sigma  finite: loads numbers each, as P
 *   cycle        receives the handle
 * RWEDGE_EDOMAIN, RWEDGE_EPATH, RWEDGE_ESLIDING, RWEDGE_ENOCONV as rwedge_contact_apply() has them;
 * RWEDGE_ERANGE for loads = 0; RWEDGE_ENULL; RWEDGE_ENOMEM. There is a cycle too where only its
 * slip is not known. */
RWEDGE_API int32_t rwedge_cycle_create(const rwedge_contact *contact, size_t loads,
                                       const double P[], const double M[], const double Q[],
                                       const double sigma[], rwedge_cycle **cycle);

/* A cycle of a contact that is held, guided through tilts as rwedge_contact_guide() does it load by
 * load; rwedge_cycle_create() keeps the tilt. The moments are results.                         new
 *   loads     number of loads, >= 1
 *   P         0, or 1e-60 to 1e60; not below 1e-8 of the last P: 0 may follow any
 *   tilt      rad, |tilt| < pi/2; as for rwedge_contact_guide(): loads numbers
 *   Q, sigma  finite: loads numbers each, as P
 *   cycle     receives the handle
 * RWEDGE_EDOMAIN where the contact is not held by rwedge_contact_set_rotation(), or where a tilt is
 * too large. Other errors as those of rwedge_contact_guide() and rwedge_cycle_create():
 * RWEDGE_EPATH; RWEDGE_ESLIDING; RWEDGE_ENOCONV; RWEDGE_ERANGE; RWEDGE_ENULL; RWEDGE_ENOMEM. */
RWEDGE_API int32_t rwedge_cycle_create_guided(const rwedge_contact *contact, size_t loads,
                                              const double P[], const double tilt[],
                                              const double Q[], const double sigma[],
                                              rwedge_cycle **cycle);

/* A cycle of a contact that a rig drives, as rwedge_contact_drive() does it load by load. What the
 * bodies slide in it is slip of every place, and dissipates. rwedge_cycle_forces() tells Q.     new
 *   loads         number of loads, >= 1
 *   P             0, or 1e-60 to 1e60; not below 1e-8 of the last P: 0 may follow any
 *   M, sigma      finite: loads numbers each, as P
 *   displacement  length, finite: loads numbers
 *   compliance    length over a force per unit length, 0, or 1e-60 to 1e60
 *   cycle         receives the handle
 * Errors as those of rwedge_contact_drive() and rwedge_cycle_create(): RWEDGE_EDOMAIN;
 * RWEDGE_EPATH; RWEDGE_ESLIDING; RWEDGE_ENOCONV; RWEDGE_ERANGE; RWEDGE_ENULL; RWEDGE_ENOMEM. */
RWEDGE_API int32_t rwedge_cycle_create_driven(const rwedge_contact *contact, size_t loads,
                                              const double P[], const double M[],
                                              const double sigma[], const double displacement[],
                                              double compliance, rwedge_cycle **cycle);

/* Frees a cycle; NULL is allowed. */
RWEDGE_API void rwedge_cycle_destroy(rwedge_cycle *cycle);

/* How many loads the cycle has; 0 for NULL. */
RWEDGE_API size_t rwedge_cycle_loads(const rwedge_cycle *cycle);

/* The force Q of each load of the cycle.                                                        new
 *   loads  rwedge_cycle_loads()
 *   Q      receives loads numbers, force/length
 * RWEDGE_ERANGE; RWEDGE_ENULL. */
RWEDGE_API int32_t rwedge_cycle_forces(const rwedge_cycle *cycle, size_t loads, double Q[]);

/* How many edges rwedge_cycle_edges() tells; 0 for NULL.                                     new */
RWEDGE_API size_t rwedge_cycle_edge_count(const rwedge_cycle *cycle);

/* The edges of the contact and of each zone that sticks, before the cycle and after each load:
 * there stresses and slip have their peaks. They are in ascending order, each once. Of more than
 * 200 those are left out that are closer than a 200th of the widest contact to the one before. new
 *   n  rwedge_cycle_edge_count()
 *   x  length, receives n numbers
 * RWEDGE_ERANGE; RWEDGE_ENULL. */
RWEDGE_API int32_t rwedge_cycle_edges(const rwedge_cycle *cycle, size_t n, double x[]);

/* How many places rwedge_cycle_places() tells; 0 for NULL.                                   new */
RWEDGE_API size_t rwedge_cycle_place_count(const rwedge_cycle *cycle);

/* Places of the surface at which to measure the cycle: 201 across the widest contact, dense at its
 * edges; 40 beyond each edge, as far as its half-width; and those of rwedge_cycle_edges(). They are
 * in ascending order. There is none where the bodies do not touch.                             new
 *   n  rwedge_cycle_place_count()
 *   x  length, receives n numbers
 * RWEDGE_ERANGE; RWEDGE_ENULL. */
RWEDGE_API int32_t rwedge_cycle_places(const rwedge_cycle *cycle, size_t n, double x[]);

/* Stresses at n points after each load of the cycle: as rwedge_contact_stresses(), to the same
 * bits.                                                                                         new
 *   loads          rwedge_cycle_loads()
 *   x, y           length, finite, y >= 0: n numbers each; not the apex (0, 0) of a loaded sharp
 *                  wedge
 *   sxx, syy, txy  each receives loads * n numbers, the n of the first load first; not one of the
 *                  inputs
 * RWEDGE_EDOMAIN; RWEDGE_ERANGE; RWEDGE_ENULL; RWEDGE_ENOMEM. */
RWEDGE_API int32_t rwedge_cycle_stresses(const rwedge_cycle *cycle, size_t loads, size_t n,
                                         const double x[], const double y[], double sxx[],
                                         double syy[], double txy[]);

/* What friction does at n places of the surface in the cycle. All is 0 where there is no contact.
 * Slip counts from when a place first came into contact. Where the contact leaves it and comes
 * back, slip goes on from where the surfaces are when they meet again: so it is the same for any
 * number of equal cycles.                     Ruiz, Boddington, Chen (1984), see lib/README.md; new
 *   x           length, finite: n numbers; not the apex 0 of a loaded sharp wedge
 *   slip_range  receives n numbers: largest less smallest slip, length
 *   ruiz_f1     receives n numbers: largest |q| times slip range
 *   ruiz_f2     receives n numbers: ruiz_f1 times the largest sxx after a load, 0 where that is not
 *               tensile
 *   energy      receives n numbers: dissipated per area, the integral of q d(slip)
 * RWEDGE_EPATH where the slip has no closed form after one of the loads, or on the way to
 * separation. After rwedge_contact_allow_error() it is computed instead, unless the cycle slides
 * fully off the centre. RWEDGE_EDOMAIN, RWEDGE_ERANGE, RWEDGE_ENULL, RWEDGE_ENOMEM. Under constant
 * P and M slip and energy are those of rwedge_contact_slip() and the tractions. Where P or M
 * change, a step is cut into parts in which no edge moves by more than 0.3 % of the half-width,
 * 0.5 % where the shear is computed, or into the most parts, 128 and 48: the energy of the contact
 * then errs by 0.2 % in usual cycles. Computed slip of places that slip as they come into contact
 * errs by 1 % at a tolerance of 1e-4, and by 0.05 % at 1e-6. */
RWEDGE_API int32_t rwedge_cycle_friction(const rwedge_cycle *cycle, size_t n, const double x[],
                                         double slip_range[], double ruiz_f1[], double ruiz_f2[],
                                         double energy[]);

/* Where a measure of the cycle is largest on a line along x: at one of the given places, or between
 * them, next to the largest values.                                                             new
 *   measure                 0 <= measure <= 13: RWEDGE_MEASURE_STRESS_RANGE and so on
 *   constants               rwedge_criterion_constants(measure) numbers, of at most 1e60 in
 *                           magnitude: as for rwedge_criterion()
 *   x                       length, finite; one after the other: n numbers
 *   value                   at least 0, finite: the measure there, n numbers, 0 where there is none
 *   y                       depth, length, finite, y >= 0; 0 for slip, F1, F2 and energy
 *   worst_x, worst_value    each receives one number
 * RWEDGE_EDOMAIN where rwedge_criterion() has it, and for slip where y is not 0; RWEDGE_ERANGE for
 * n = 0; RWEDGE_EPATH as rwedge_cycle_friction() has it; RWEDGE_ENULL, RWEDGE_ENOMEM. The place is
 * found to about 1e-8 of the distance of its neighbours, or as well as values tell it; the value of
 * a smooth top to rounding. Places where nothing cycles are passed over: those whose amplitude of
 * sqrt(J2) is below a thousandth of the largest at the given places. There a mean stress alone
 * would make Findley's criterion, McDiarmid's, Crossland's and Dang Van's large, and the modified
 * Woehler curve's. */
RWEDGE_API int32_t rwedge_cycle_worst(const rwedge_cycle *cycle, int32_t measure,
                                      const double constants[], size_t n, const double x[],
                                      const double value[], double y, double nu,
                                      int32_t plane_stress, double *worst_x, double *worst_value);

/* The length of the theory of critical distances, (dK_th/ds0)^2/pi.
 *                                         Taylor (1999); El Haddad, Smith and Topper (1979)
 *   dK_th   range of the threshold of long cracks, stress times root of length, 1e-60 to 1e60
 *   ds0     range of the plain fatigue limit, stress, 1e-60 to 1e60; both of one stress ratio
 * NaN outside. Relative error below 4 epsilon. */
RWEDGE_API double rwedge_critical_distance(double dK_th, double ds0);

/* Stresses of the cycle by the theory of critical distances, from a place of the surface into the
 * half-plane: after each load at half of the length L (the point), or their means over 2 L (the
 * line). rwedge_criterion_field() gives the criteria of these stresses. L is a property of the
 * material: rwedge_critical_distance().                      Taylor (1999), see lib/README.md; new
 *   loads          rwedge_cycle_loads()
 *   x              length, finite; not the apex 0 of a loaded sharp wedge
 *   angle          -1.5 <= angle <= 1.5, rad, from the surface's normal towards +x
 *   length         L, length, 1e-60 to 1e60
 *   line           0 <= line <= 1: 0 for the point, 1 for the line
 *   sxx, syy, txy  each receives loads numbers
 * RWEDGE_EDOMAIN, RWEDGE_ERANGE, RWEDGE_ENULL, RWEDGE_ENOMEM; RWEDGE_ENOCONV where the means do not
 * settle to 1e-10 of the stresses, which is their error. */
RWEDGE_API int32_t rwedge_cycle_below(const rwedge_cycle *cycle, size_t loads, double x,
                                      double angle, double length, int32_t line, double sxx[],
                                      double syy[], double txy[]);

/* The displacement that slip adds after each load of the cycle, as rwedge_contact_displacement()
 * has it.                                                                                       new
 *   loads         rwedge_cycle_loads()
 *   b             length, > 0, finite
 *   displacement  receives loads numbers
 * It goes through the loads once more. RWEDGE_EABSENT where the bodies are apart after a load;
 * RWEDGE_EPATH where the slip is not known after one; RWEDGE_EDOMAIN; RWEDGE_ERANGE; RWEDGE_ENULL;
 * RWEDGE_ENOMEM. Error as there. */
RWEDGE_API int32_t rwedge_cycle_displacement(const rwedge_cycle *cycle, size_t loads, double b,
                                             double displacement[]);

/* The zone that never slips in the cycle, nor leaves the contact. In a steady cycle between two
 * loads it is that of rwedge_contact_permanent_stick().                                         new
 *   left, right  its edges, length: of the widest where there are several
 * RWEDGE_EABSENT where no place sticks all the time; RWEDGE_ENULL. Error as that of
 * rwedge_contact_stick_zone(). Where loads are computed, the states after them tell the zone, and
 * it has their error. */
RWEDGE_API int32_t rwedge_cycle_permanent_stick(const rwedge_cycle *cycle, double *left,
                                                double *right);

/* Bounds of the shakedown of a cycle that stays in place: the factor on all its stresses up to
 * which it is elastic after it has yielded at first. At the lower bound residual stresses are in
 * equilibrium and keep it so, by Melan's theorem. Above the upper one none can: the path of the
 * deviator at the place (x, y) fits into no ball of the radius k. That ball alone, as Dang Van's
 * criterion takes it, is the unsafe bound: the balls of all places need not go together. Where the
 * surface governs the two meet. Von Mises, plane strain, perfect plasticity, small strain. Stresses
 * are those after the loads: where they turn in between, add a load. A bulk tension that changes
 * counts.                                                                                       new
 *   nu     0 <= nu <= 0.5
 *   k      yield stress in pure shear, stress, finite, > 0
 *   lower  receives the factor that is sure to be carried
 *   upper  receives the factor above which it goes on yielding
 *   x, y   receive the place of the upper bound, length
 * RWEDGE_EABSENT where there is no contact after any load, or a kink of the profile in it;
 * RWEDGE_EDOMAIN; RWEDGE_ENULL; RWEDGE_ENOMEM; RWEDGE_ERANGE where a bound leaves the domain, as
 * that of a cycle of one load does. Places and depths are searched; in the tests the lower bound
 * was right to 0.5 %. It takes up to a second. */
RWEDGE_API int32_t rwedge_cycle_shakedown(const rwedge_cycle *cycle, double nu, double k,
                                          double *lower, double *upper, double *x, double *y);

/* The displacement that slip adds: how much further remote points of the half-plane have moved
 * tangentially, relative to the wedge's, than if the contact were bonded over |x| < b. Its loop
 * over Q encloses the energy of a cycle under constant P. What rwedge_contact_drive() has slid the
 * bodies is in it.                                                                              new
 *   b  length, > 0, finite
 * NaN when separated; NaN for NULL; NaN off the centre where the slip has no closed form, as in
 * rwedge_contact_slip(). Error below 1e-14 of f theta times the half-width for every remembered
 * point, 1e-6 of it off the centre. */
RWEDGE_API double rwedge_contact_displacement(const rwedge_contact *contact, double b);

/* The next load where a rig prescribes a displacement in place of Q: that of
 * rwedge_contact_displacement(), b being the half-width under the first such load, plus what the
 * rig gives way, its compliance times Q. In full sliding the rest is sliding: it counts in the
 * displacements to come, and its energy, f P times the way, as dissipated. A contact that touches
 * anew begins where the rig was when the bodies were apart. Under a moment, or a tension that
 * changes, slip and energy are known in full sliding too, from the first such load on.          new
 *   P             0, or 1e-60 to 1e60; not below 1e-8 of the last P: as for rwedge_contact_load()
 *   M             finite; 0 where P is 0: as for rwedge_contact_apply()
 *   sigma         finite, as there
 *   displacement  length, finite
 *   compliance    length over a force per unit length, 0, or 1e-60 to 1e60
 *   Q             receives the force
 * It is found by some ten trials on copies. RWEDGE_EPATH also where the displacement is not known:
 * of unlike bodies that slide fully, or off the centre where they slid before the first such load,
 * or without a closed form where no error is allowed; other errors as those of
 * rwedge_contact_apply(): RWEDGE_EDOMAIN; RWEDGE_ERANGE; RWEDGE_ESLIDING; RWEDGE_ENOCONV;
 * RWEDGE_ENULL; RWEDGE_ENOMEM. In the tests Q was right to 1e-10 of f P; off the centre to 1e-4
 * of f P, beside boundary elements, and the energy of a cycle to 7e-4. */
RWEDGE_API int32_t rwedge_contact_drive(rwedge_contact *contact, double P, double M, double sigma,
                                        double displacement, double compliance, double *Q);

/* How the contact of a measured loop slips. Values never change. */
enum {
    RWEDGE_LOOP_STICK = 0,        /* the loop is a line within its noise */
    RWEDGE_LOOP_PARTIAL_SLIP = 1, /* Q does not reach f P */
    RWEDGE_LOOP_GROSS_SLIP = 2    /* the contact slides */
};

/* Friction, the rig's compliance and the offset of its displacement from a measured loop of Q over
 * the displacement: those with which rwedge_contact_drive() through the rows leaves the least of Q,
 * in squares. A log may begin with a contact that has no shear yet, or be whole cycles of a steady
 * loop: it is gone through once, or twice of which the second time counts, as fits better.      new
 *   contact       bodies, pad, tilt and tolerance count; friction and loads do not
 *   n             number of rows, >= 8
 *   P             0, or 1e-60 to 1e60: n numbers
 *   M             finite; 0 where P is 0: n numbers
 *   sigma         finite: n numbers
 *   displacement  length, finite: n numbers
 *   Q             measured, finite: n numbers
 *   value         receives 3 numbers: friction; length over a force per unit length; the
 *                 displacement at which there is no shear
 *   uncertainty   receives 3 numbers: standard deviations of these, by the noise of Q
 *   told          receives 3 numbers: 1 where the loop tells it; 0 where it does not, as the
 *                 friction of a line, whose value is then 0 too
 *   regime        RWEDGE_LOOP_STICK, and so on
 *   fitted        receives n numbers: the forces of the fit
 * RWEDGE_EABSENT where there is no loop: P, Q or the displacement stays 0, or does not change;
 * RWEDGE_ENOCONV where the contact follows these displacements with no friction that is tried;
 * RWEDGE_EDOMAIN; RWEDGE_ERANGE for n < 8; RWEDGE_ENULL; RWEDGE_ENOMEM. With 0.5 % of noise and 500
 * rows f was right to 0.1 % in gross slip in the tests, and to 1 % in partial slip up to 0.9 f P.
 * It takes some hundred times as long as the loads. */
RWEDGE_API int32_t rwedge_contact_loop_fit(const rwedge_contact *contact, size_t n,
                                           const double P[], const double M[], const double sigma[],
                                           const double displacement[], const double Q[],
                                           double value[3], double uncertainty[3], double told[3],
                                           double *regime, double fitted[]);

/* ---- Measures of a stress -------------------------------------------------------------------- */

/* Stresses may be any, of a contact or not, in any unit; tension positive, y into the half-plane.
 *   sxx, syy, txy  stresses, of at most 1e60 in magnitude
 *   nu             Poisson's ratio, 0 <= nu <= 0.5: plane strain, szz = nu (sxx+syy); for plane
 *                  stress, szz = 0, give nu = 0
 * The accuracy holds where the largest of the stresses is at least 1e-60. A measure is finite, but
 * may be above 1e60. */

/* Von Mises' equivalent stress, sqrt(3 J2).                                       von Mises (1913)
 * NaN outside the domain. Relative error below 4 epsilon. */
RWEDGE_API double rwedge_von_mises(double sxx, double syy, double txy, double nu);

/* The stress across the plane of x and y, szz = nu (sxx+syy). It is a principal stress.
 * NaN outside the domain. Relative error below 4 epsilon. */
RWEDGE_API double rwedge_out_of_plane_stress(double sxx, double syy, double nu);

/* The largest shear stress on any plane: half of the difference between the largest and the
 * smallest principal stress, szz among them.                                         Tresca (1864)
 * NaN outside the domain. Relative error below 4 epsilon. */
RWEDGE_API double rwedge_largest_shear(double sxx, double syy, double txy, double nu);

/* Principal stresses in the plane of x and y, s1 >= s2, and the plane on which s1 acts.
 *   s1, s2  each receives one number
 *   angle   receives the angle between that plane's normal and the surface's normal, the y axis,
 *           rad, -pi/2 < angle <= pi/2. The plane's normal is (x, y) = (sin(angle), cos(angle)):
 *           positive angles turn from +y towards +x. 0 where sxx = syy and txy = 0
 * RWEDGE_EDOMAIN, RWEDGE_ENULL. Error of s1 and s2 below 4 epsilon of the larger magnitude of the
 * two, of the angle below 4 epsilon. */
RWEDGE_API int32_t rwedge_principal_stresses(double sxx, double syy, double txy, double *s1,
                                             double *s2, double *angle);

/* ---- Criteria of fatigue --------------------------------------------------------------------- */

/* A criterion of a cycle of stresses at one point has a number, RWEDGE_MEASURE_SWT and so on, and
 * constants: those of the material. The functions below tell which criteria there are, and which
 * constants each has, in which order.
 *
 * Strains are elastic. In plane strain szz = nu (sxx+syy), in plane stress 0. The shear stress on a
 * plane is a path in two dimensions. Its amplitude tau_a is the radius of the smallest circle
 * around the path: half of the range for a straight path. sn_max is the largest normal stress on
 * the plane in the cycle, negative in compression. The order of the loads does not matter.
 *
 * SWT, a stress: the largest sn_max e_a, e_a being the amplitude of the plane's normal strain; 0
 * for planes that are never in tension. Smith, Watson, Topper (1970); on planes Socie (1987)
 * FATEMI_SOCIE, a strain: the largest gamma_a (1 + k sn_max/sy), gamma_a = 2(1+nu)/E tau_a being
 * the amplitude of the shear strain; no plane counts less than 0. Fatemi and Socie (1988)
 * FINDLEY, a stress: the largest tau_a + k sn_max. Findley (1959)
 * MODIFIED_WOHLER, a stress: tau_a + kappa min(rho, rho_lim), rho = sn_max/tau_a, on the plane of
 * the largest tau_a; of several the one of the largest sn_max. rho_lim = lambda/(2 kappa) where it
 * is given as 0. Safe where it is at most lambda. It is 0 where no stress changes: where tau_a is
 * below 1e-12 of the largest stress. The fully reversed limits t_A in torsion and s_A in tension
 * give kappa = t_A - s_A/2 and lambda = t_A. Susmel and Lazzarin (2002), Lazzarin and Susmel (2003)
 * MCDIARMID, a ratio: tau_a/t_A + sn_max/(2 su) on the plane of the largest tau_a, as above. Safe
 * where it is below 1. McDiarmid (1991)
 * CROSSLAND, a stress: the amplitude of sqrt(J2), which is the radius of the smallest sphere around
 * the path of the stress deviator, plus alpha times the largest hydrostatic stress (sxx+syy+szz)/3.
 * The amplitude is not half of the range of sqrt(J2): that is 0 for a deviator that only rotates.
 * Crossland (1956)
 * DANG_VAN, a stress: the largest tau(t) + alpha sH(t) of the loads t. tau is the largest shear
 * stress of the deviator less the centre of the smallest sphere around its path: after shakedown,
 * residual stresses have shifted the path to that centre. sH is the hydrostatic stress, negative in
 * compression, where it lowers the value. Dang Van (1973)
 * STRESS_RANGE, a stress: the largest sxx less the smallest.
 * SWT_IN_PLANE and FATEMI_SOCIE_IN_PLANE: the same as SWT and FATEMI_SOCIE, of the planes that
 * contain z alone. Where szz is an extreme principal stress, other planes may have a larger value.
 *
 * Findley, McDiarmid, Crossland and Dang Van count a mean stress where nothing cycles too: there
 * they say nothing of fatigue.
 *
 * The plane's normal is (x, y, z) = (cos(o) sin(a), cos(o) cos(a), sin(o)), a = angle, -pi/2 < a <=
 * pi/2, o = out_of_plane, 0 <= o <= pi/2, both in rad: the plane contains z where o is 0. The plane
 * with -o is equally bad. The angles are those of one of the planes where several have the value,
 * and 0 for criteria without a plane. Planes are not sampled: no plane exceeds the one that is
 * named by more than the error, or by more than 1e-7 of the value where a whole curve of planes is
 * nearly as bad.
 *
 * Errors, s being the largest stress of the cycle: SWT 1e-14 s^2 (1+nu)/E; Fatemi-Socie 1e-14 (1 +
 * s k/sy) s (1+nu)/E; Findley 1e-14 (1+k) s; Crossland and Dang Van 1e-14 (1+alpha) s. The plane of
 * the largest shear is as uncertain as the root of a rounding: McDiarmid 1e-6 s (1/t_A + 1/su); of
 * the modified Woehler curve tau_a 1e-8 s, and rho 1e-6 s/tau_a.
 *
 *   criterion      0 <= criterion <= 13: RWEDGE_MEASURE_STRESS_RANGE and so on, but not those of
 *                  friction, 3 to 6
 *   j              which of the constants, >= 0, counted from 0
 *   sxx, syy, txy  stresses, of at most 1e60 in magnitude: n each, or as said
 *   nu             Poisson's ratio, 0 <= nu <= 0.5
 *   plane_stress   0 <= plane_stress <= 1: 0 for plane strain, 1 for plane stress */

/* How many measures of a cycle there are. Their numbers are 0, 1, ... up to one less.        new */
RWEDGE_API int32_t rwedge_criterion_count(void);

/* The name of a measure, such as "modified_wohler". Empty for any other number. Static text, never
 * NULL.
 *   criterion  any integer */
RWEDGE_API const char *rwedge_criterion_name(int32_t criterion);

/* The name of a measure for people, such as "Modified Woehler parameter". Empty for any other
 * number. Static text, never NULL.
 *   criterion  any integer */
RWEDGE_API const char *rwedge_criterion_title(int32_t criterion);

/* What a measure is, in a few words. Empty for any other number. Static text, never NULL.
 *   criterion  any integer */
RWEDGE_API const char *rwedge_criterion_text(int32_t criterion);

/* What a measure is counted in: "stress", "none", "length", or "force/length" and the like. Empty
 * for any other number. Static text, never NULL.
 *   criterion  any integer */
RWEDGE_API const char *rwedge_criterion_unit(int32_t criterion);

/* The name of the material's constant below which a criterion is safe, such as "lambda"; "1" where
 * that is the number 1. Empty where there is none. Static text, never NULL.
 *   criterion  any integer */
RWEDGE_API const char *rwedge_criterion_limit(int32_t criterion);

/* The power of the stresses with which a criterion grows: 2 for SWT, a product of two stresses; 1
 * for the range and for those that are sums of stresses. 0 where there is no single one, as of
 * FATEMI_SOCIE and MODIFIED_WOHLER, for measures of friction, and for any other number.         new
 *   criterion  any integer */
RWEDGE_API int32_t rwedge_criterion_degree(int32_t criterion);

/* How many constants a criterion has; 0 for measures without one, and for any other number.     new
 *   criterion  any integer */
RWEDGE_API int32_t rwedge_criterion_constants(int32_t criterion);

/* How many constants its damage and its life have: those of the criterion, and behind them those of
 * its curve of life; 0 where it has none.                                                       new
 *   criterion  any integer */
RWEDGE_API int32_t rwedge_damage_constants(int32_t criterion);

/* The name of a constant, such as "kappa": first those of the criterion, then those of its curve of
 * life. Constants of the same name are the same. Empty where there are not so many. Static text,
 * never NULL.
 *   criterion, j  any integer */
RWEDGE_API const char *rwedge_constant_name(int32_t criterion, int32_t j);

/* What a constant is, in a few words. Empty where there are not so many. Static text, never NULL.
 *   criterion, j  any integer */
RWEDGE_API const char *rwedge_constant_text(int32_t criterion, int32_t j);

/* What a constant is counted in: "stress", "1/stress" or "none". Empty where there are not so many.
 * Static text, never NULL.
 *   criterion, j  any integer */
RWEDGE_API const char *rwedge_constant_unit(int32_t criterion, int32_t j);

/* What a constant may be: from low to high, as whatever has a size 0 or at least 1e-60 in
 * magnitude.                                                                                    new
 *   low, high  each receives one number
 * RWEDGE_EABSENT where there are not so many constants; RWEDGE_EDOMAIN; RWEDGE_ENULL. */
RWEDGE_API int32_t rwedge_constant_range(int32_t criterion, int32_t j, double *low, double *high);

/* What a constant is where a material does not give it.                                         new
 *   criterion, j  any integer
 * NaN where a material has to give it, NaN where there are not so many. */
RWEDGE_API double rwedge_constant_usual(int32_t criterion, int32_t j);

/* A criterion of a cycle of stresses at one point, by its number, and its plane.                new
 *   constants      rwedge_criterion_constants(criterion) numbers, of at most 1e60 in magnitude: as
 *                  rwedge_constant_name() names them, each in its rwedge_constant_range()
 *   n              number of loads of the cycle, >= 1; their order does not matter
 *   value, angle, out_of_plane  each receives one number
 * RWEDGE_EDOMAIN where a constant is outside its range, and for measures of friction; RWEDGE_ERANGE
 * for n = 0; RWEDGE_ENULL; RWEDGE_ENOMEM. The time grows like n; for planes that contain z alone
 * like n^2 where n is above 64 and many loads in turn are the worst for neighbouring planes, as on
 * a circular path: 30 000 take some 10 s. */
RWEDGE_API int32_t rwedge_criterion(int32_t criterion, const double constants[], size_t n,
                                    const double sxx[], const double syy[], const double txy[],
                                    double nu, int32_t plane_stress, double *value, double *angle,
                                    double *out_of_plane);

/* The same at n points.
 *   constants      rwedge_criterion_constants(criterion) numbers, of at most 1e60 in magnitude
 *   loads          number of loads of the cycle, >= 1
 *   sxx, syy, txy  loads * n stresses each: that of load i at point j is at [i n + j]
 *   value, angle, out_of_plane  each receives n numbers
 * Nothing is written unless every stress is in the domain. */
RWEDGE_API int32_t rwedge_criterion_field(int32_t criterion, const double constants[], size_t loads,
                                          size_t n, const double sxx[], const double syy[],
                                          const double txy[], double nu, int32_t plane_stress,
                                          double value[], double angle[], double out_of_plane[]);

/* The factor on the stresses of all loads at a point with which a criterion has a given value, such
 * as the one that it must not exceed. Of a criterion with a rwedge_criterion_degree() it is the
 * root of that degree of limit over value. Of others it is found by doubling or halving, from 1 on.
 *                                                                                               new
 *   constants      rwedge_criterion_constants(criterion) numbers, of at most 1e60 in magnitude
 *   limit          the value, > 0
 *   n              number of loads of the cycle, >= 1
 *   factor         receives one number
 * RWEDGE_EABSENT where no factor from 1e-30 to 1e30 has it, as where the value is 0; RWEDGE_EDOMAIN
 * where a constant is outside its range, and for measures of friction; RWEDGE_ERANGE for
 * n = 0; RWEDGE_ENULL; RWEDGE_ENOMEM. As exact as the criterion. */
RWEDGE_API int32_t rwedge_criterion_factor(int32_t criterion, const double constants[],
                                           double limit, size_t n, const double sxx[],
                                           const double syy[], const double txy[], double nu,
                                           int32_t plane_stress, double *factor);

/* ---- Lives ----------------------------------------------------------------------------------- */

/* Lives and damage are those of SWT and FATEMI_SOCIE. Their constants are those of the criterion,
 * and behind them those of the curve of life:
 * SWT: N where sf^2/E (2N)^(2b) + sf ef (2N)^(b+c) is the parameter. Smith, Watson, Topper (1970)
 * FATEMI_SOCIE: N where tf/G (2N)^b0 + gf (2N)^c0 is the parameter. Fatemi and Socie (1988)
 * Below the limit, a run-out, the life is infinite; a limit of 0 is none.
 *   criterion     1 <= criterion <= 2: RWEDGE_MEASURE_SWT, RWEDGE_MEASURE_FATEMI_SOCIE
 *   nu            Poisson's ratio, 0 <= nu <= 0.5
 *   plane_stress  0 <= plane_stress <= 1: 0 for plane strain, 1 for plane stress */

/* Cycles to failure at a value of a criterion. HUGE_VAL for 0, below the limit, and beyond 1e60.
 *                                                                                               new
 *   constants  rwedge_damage_constants(criterion) numbers, of at most 1e60 in magnitude: as
 *              rwedge_constant_name() names them, each in its rwedge_constant_range()
 *   parameter  the value of the criterion, 0 or 1e-60 to 1e60
 * NaN outside the domain or the ranges, NaN for a life below 1e-60, and NaN for NULL. Relative
 * error below 1e-11. */
RWEDGE_API double rwedge_life(int32_t criterion, const double constants[], double parameter);

/* The cycles of a history by rainflow. A history that repeats is counted from its largest value to
 * its return: no half cycle is left over. In other histories the cycles left over count half.
 *                                                                       ASTM E1049-85 (2017); new
 *   n        number of values, >= 1
 *   value    of at most 1e60 in magnitude: n numbers
 *   repeats  0 <= repeats <= 1: 0 where it happens once (5.4.4), 1 where it repeats (5.4.5)
 *   range    receives n numbers: the largest less the smallest value of the cycle that begins with
 *            the value of this place; 0 where none begins
 *   mean     receives n numbers: the mean of these two
 *   count    receives n numbers: 1, 1/2 for what is left over, 0 where no cycle begins
 * RWEDGE_EDOMAIN; RWEDGE_ERANGE for n = 0; RWEDGE_ENULL; RWEDGE_ENOMEM. A value between its
 * neighbours is no turn. Of equal values in a row only the first may be one. The tolerance is 0:
 * values are compared as they are, and values that differ by rounding are different. */
RWEDGE_API int32_t rwedge_rainflow(size_t n, const double value[], int32_t repeats, double range[],
                                   double mean[], double count[]);

/* Damage of a block of stresses that repeats: Miner's sum on the plane where it is largest, of all
 * planes. 1/value blocks are the life.               Bannantine and Socie (1991), Miner (1945); new
 * The cycles are counted by rwedge_rainflow() of a history that repeats: of SWT those of the
 * plane's normal strain, of FATEMI_SOCIE those of its shear strain in one direction, the direction
 * of the largest sum. Each has the largest normal stress from its first load to where it closes,
 * which may be between two loads. A cycle with the parameter S adds 1/N(S), N being its life. On
 * planes through z, loads with the same shear and another mean stress are counted on either side, a
 * hair beside the plane, and the larger sum is taken.
 *   constants      as in rwedge_life()
 *   n              number of loads of the block, >= 1, in their order; stresses change straight
 *                  between
 *   sxx, syy, txy  stresses, of at most 1e60 in magnitude: n numbers each
 *   value, cycles  each receives one number: the sum; how many cycles there are
 *   plane          receives 2 numbers: angle and out_of_plane of rwedge_criterion()
 * RWEDGE_EDOMAIN, also for a life below 1e-60; RWEDGE_ERANGE for n = 0; RWEDGE_ENULL;
 * RWEDGE_ENOMEM. The sum on a plane errs by 1e-11, plus what 1e-13 of the criterion changes in the
 * lives. Damage is not smooth over the planes: it is sampled at every 5 degrees, and finer around
 * the worst planes. In no random block of the tests was the damage of another plane larger by 1e-4.
 * With a limit, a cycle that is at the limit may be missed. A block of one cycle has the plane of
 * the criterion. */
RWEDGE_API int32_t rwedge_damage(int32_t criterion, const double constants[], size_t n,
                                 const double sxx[], const double syy[], const double txy[],
                                 double nu, int32_t plane_stress, double *value, double *cycles,
                                 double plane[2]);

/* The same at n points.
 *   constants      as in rwedge_life()
 *   loads          number of loads of the block, >= 1
 *   sxx, syy, txy  loads * n stresses each: that of load i at point j is at [i n + j]
 *   value, cycles  each receives n numbers
 *   plane          receives 2 * n numbers: the angle at each point, then out_of_plane at each
 * Nothing is written unless every stress is in the domain. */
RWEDGE_API int32_t rwedge_damage_field(int32_t criterion, const double constants[], size_t loads,
                                       size_t n, const double sxx[], const double syy[],
                                       const double txy[], double nu, int32_t plane_stress,
                                       double value[], double cycles[], double plane[]);

/* ---- Cracks ---------------------------------------------------------------------------------- */

/* A straight crack of the half-plane from a place of its surface. Its faces are free; K_I < 0 would
 * need faces that overlap, and is formal. The contact is taken as if there were no crack. A crack
 * longer than a tenth of the contact's half-width changes the tractions; what that does to K is not
 * measured.
 *   angle   rad, from the normal of the surface towards +x, -1.31 <= angle <= 1.31: 75 degrees
 *   length  of the crack, 1e-60 to 1e60 */

/* How many places rwedge_crack_weights() takes for its error: 97 + 2 |degrees|.                 new
 *   angle  any number; it is 0 for angles that are not in the domain */
RWEDGE_API size_t rwedge_crack_points(double angle);

/* Weights of the stresses along a crack, for any length l: K_I is sqrt(l) times the sum of
 * normal_I[k] s[k] + shear_I[k] t[k], and K_II the same with normal_II and shear_II. s and t are
 * the stresses without the crack at the distance place[k] l from the mouth, s = n.S.n across the
 * crack's line, t = d.S.n along it, with d = (sin angle, cos angle), n = (cos angle, -sin angle): a
 * contact's, residual ones, those of another program.       Bueckner (1970), see lib/README.md; new
 *   m      number of places, rwedge_crack_points() or another one, 2 to 512
 *   place  receives m numbers, in the length; 1, the tip, is the first
 *   normal_I, shear_I, normal_II, shear_II  each receives m numbers
 * RWEDGE_EDOMAIN, RWEDGE_ENULL, RWEDGE_ERANGE for m, RWEDGE_ENOMEM, RWEDGE_ENOCONV. With the m of
 * rwedge_crack_points() K differs from the exact one by less than 1e-9 of sqrt(pi l) times the
 * largest stress on the line up to 60 degrees, 1e-6 beyond. */
RWEDGE_API int32_t rwedge_crack_weights(double angle, size_t m, double place[], double normal_I[],
                                        double shear_I[], double normal_II[], double shear_II[]);

/* What of K_II counts. Friction of the faces lies between the last two. Values never change; new
 * ones are added at the end. */
enum {
    RWEDGE_FACES_MODE_I = 0, /* nothing: mode I alone */
    RWEDGE_FACES_LOCKED = 1, /* its range while K_I > 0: closed faces do not slide */
    RWEDGE_FACES_FREE = 2    /* its range over the whole cycle: closed faces slide freely */
};

/* What a cycle changes of K, for n cracks. K changes straight from load to load, and from the last
 * to the first; K_I < 0 counts as 0 in its range, but not in R.                                 new
 *   loads      number of loads of the cycle, >= 1
 *   K_I, K_II  finite; loads * n numbers each: that of load i and crack j is at [i n + j]
 *   shear      0 <= shear <= 2: RWEDGE_FACES_MODE_I and so on
 *   range_I, range_II, K_max, R  each receives n numbers: K_max is the largest sqrt(K_I^2 + K_II^2)
 *              while K_I > 0; R the least K_I over the largest, 0 where the largest is not positive
 * RWEDGE_EDOMAIN; RWEDGE_ERANGE for loads = 0; RWEDGE_ENULL. */
RWEDGE_API int32_t rwedge_crack_ranges(size_t loads, size_t n, const double K_I[],
                                       const double K_II[], int32_t shear, double range_I[],
                                       double range_II[], double K_max[], double R[]);

/* Threshold of the range of K for a crack that may be short, dK_th sqrt(l/(l + a0)), where a0 is
 * (dK_th/(Y ds0))^2/pi. Y = 1.1215222552310553 is that of an edge crack under uniform tension: so a
 * plain specimen at its fatigue limit stands on the threshold where l goes to 0. The length of
 * rwedge_critical_distance() has no Y: it is Y^2 a0.
 *                                       El Haddad, Topper and Smith (1979), see lib/README.md
 *   length  1e-60 to 1e60
 *   dK_th   range of the threshold of long cracks, stress times root of length, 0 or 1e-60 to 1e60
 *   ds0     range of the plain fatigue limit, stress, 1e-60 to 1e60, or HUGE_VAL: dK_th for any
 *           length; both of one stress ratio
 * NaN outside. Relative error below 4 epsilon. */
RWEDGE_API double rwedge_short_crack_threshold(double length, double dK_th, double ds0);

/* K of cracks of n lengths, from one place and at one angle, after each load of a cycle: stress
 * times root of length. overlap is the share of the line where faces would overlap under that load,
 * 0 where the crack is open everywhere. Where it is not, K is that of faces that pass through each
 * other.                                                                                        new
 *   x        of the mouth, length, finite
 *   loads    rwedge_cycle_loads()
 *   length   1e-60 to 1e60: n numbers
 *   K_I, K_II, overlap  each receives loads * n numbers, the n of the first load first
 * RWEDGE_EDOMAIN where a coordinate on the crack is neither 0 nor of the size that places have;
 * RWEDGE_ERANGE; RWEDGE_ENULL; RWEDGE_ENOMEM; RWEDGE_ENOCONV. Error as that of
 * rwedge_crack_weights(). */
RWEDGE_API int32_t rwedge_cycle_crack(const rwedge_cycle *cycle, double x, double angle,
                                      size_t loads, size_t n, const double length[], double K_I[],
                                      double K_II[], double overlap[]);

/* K of cracks as rwedge_cycle_crack() has it, but of faces that press on each other without
 * friction: they do not overlap, and K_I is never negative. Where no face would overlap, K is that
 * of rwedge_cycle_crack().                                                                      new
 *   x, length  as in rwedge_cycle_crack()
 *   loads      rwedge_cycle_loads()
 *   K_I, K_II, closed  each receives loads * n numbers, the n of the first load first; closed is
 *                      the share of the line where the faces touch
 * RWEDGE_EDOMAIN where rwedge_cycle_crack() has it; RWEDGE_ERANGE; RWEDGE_ENULL; RWEDGE_ENOMEM;
 * RWEDGE_ENOCONV, also where no contact of the faces is found. Where faces touch, K errs by less
 * than 1e-3 of sqrt(pi l) times the largest stress on the line: a closed zone ends at a place of
 * rwedge_crack_weights(). */
RWEDGE_API int32_t rwedge_cycle_closing_crack(const rwedge_cycle *cycle, double x, double angle,
                                              size_t loads, size_t n, const double length[],
                                              double K_I[], double K_II[], double closed[]);

/* What a cycle changes of K of cracks whose faces press on each other, by
 * rwedge_cycle_closing_crack(). Stresses change straight from load to load; K does not, and the
 * instants at which a crack opens and closes between loads are found.                          new
 *   x, length  as in rwedge_cycle_crack()
 *   shear      as in rwedge_crack_ranges()
 *   range_I, range_II, K_max, R  each receives n numbers, as in rwedge_crack_ranges(); R is never
 *              negative
 * RWEDGE_EDOMAIN where rwedge_cycle_crack() has it; RWEDGE_ERANGE; RWEDGE_ENULL; RWEDGE_ENOMEM;
 * RWEDGE_ENOCONV. Error as that of rwedge_cycle_closing_crack(). */
RWEDGE_API int32_t rwedge_cycle_closing_ranges(const rwedge_cycle *cycle, double x, double angle,
                                               int32_t shear, size_t n, const double length[],
                                               double range_I[], double range_II[], double K_max[],
                                               double R[]);

/* Does a crack grow in a cycle from the initial to the final length, and in how many cycles? It
 * grows where dK, the root of the squares of its ranges by rwedge_crack_ranges(), is beyond the
 * threshold of rwedge_short_crack_threshold(), by C (dK^m - threshold^m) a cycle. It breaks where
 * K_max reaches K_c. The constants are those of the stress ratio of the cycle.                  new
 *   x               of the mouth, length, finite
 *   shear           as in rwedge_crack_ranges()
 *   constants       5
 *   law             any number: dK_th, ds0, C, m, K_c. dK_th and ds0 as in
 *                   rwedge_short_crack_threshold(); C in length over K^m, > 0; 0.1 <= m <= 100; K_c
 *                   > 0, HUGE_VAL where it never breaks
 *   initial, final  lengths, 1e-60 to 1e60
 *   arrest          the length where it stops, cycles being HUGE_VAL then, or breaks; the initial
 *                   one where it does not grow at all; HUGE_VAL where it reaches the final length
 *   cycles          to the final length, or to where it breaks; HUGE_VAL beyond 1e60, too
 *   least, least_at  the smallest dK over the threshold from the initial to the final length, and
 *                   that length; HUGE_VAL where dK_th is 0
 * RWEDGE_EDOMAIN where initial is not below final, and for a constant; RWEDGE_ERANGE for constants;
 * RWEDGE_ENULL; RWEDGE_ENOMEM; RWEDGE_ENOCONV. Where K is exact, arrest is to 1e-9, cycles to 1e-6
 * of themselves, with RWEDGE_FACES_LOCKED to 1e-5. */
RWEDGE_API int32_t rwedge_cycle_growth(const rwedge_cycle *cycle, double x, double angle,
                                       int32_t shear, size_t constants, const double law[],
                                       double initial, double final, double *arrest, double *cycles,
                                       double *least, double *least_at);

/* The same, with the ranges of rwedge_cycle_closing_ranges(): faces press on each other without
 * friction.                                                                                     new
 *   cycles  as above, HUGE_VAL too. To 1e-5 of themselves where K is exact */
RWEDGE_API int32_t rwedge_cycle_closing_growth(const rwedge_cycle *cycle, double x, double angle,
                                               int32_t shear, size_t constants, const double law[],
                                               double initial, double final, double *arrest,
                                               double *cycles, double *least, double *least_at);

/* ---- The paper's series ---------------------------------------------------------------------- */

/* A pressure p = -sqrt(1-x^2) sum_k a_k U_k(x), k = 0 ... terms-1, and its stresses. The paper's
 * b_n is a_(2n). A series serves pressures that have no closed form, and checks those that have
 * one. */
typedef struct rwedge_series rwedge_series;

/* The rounded wedge's own series, cut after the first terms coefficients.
 *                                                                       Eq. (29), (31) with E1; new
 *   terms  1 <= terms <= 2^24
 * RWEDGE_EDOMAIN, RWEDGE_ERANGE, RWEDGE_ENULL, RWEDGE_ENOMEM. Free with rwedge_series_destroy(). */
RWEDGE_API int32_t rwedge_series_create(double alpha, int32_t terms, rwedge_series **series);

/* Least-squares fit to samples of any pressure that vanishes at x = +-1, even or not.
 *                                                                               Sec. 4 of the paper
 *   samples  number of samples, >= terms, samples * terms <= 2^27, samples * terms^2 <= 2^33; a
 *            fit takes up to 1 GiB and half a minute
 *   x, p     place and pressure, |x| < 1, finite; samples near Chebyshev's points (x = cos t, t
 *            equally spaced) fit best
 *   terms    >= 1
 * RWEDGE_ERANK where the samples do not determine the coefficients to half the digits of a double
 * (repeated or clustered points, or fewer than terms); RWEDGE_EDOMAIN, RWEDGE_ERANGE,
 * RWEDGE_ENULL, RWEDGE_ENOMEM, RWEDGE_ENOCONV. */
RWEDGE_API int32_t rwedge_series_fit(size_t samples, const double x[], const double p[],
                                     int32_t terms, rwedge_series **series);

/* Frees; NULL is allowed. */
RWEDGE_API void rwedge_series_destroy(rwedge_series *series);

/* How many coefficients it holds; 0 for NULL. */
RWEDGE_API int32_t rwedge_series_terms(const rwedge_series *series);

/* a_k; 0 for k >= terms; NaN outside the domain or NULL.
 *   k  index of the coefficient, >= 0 */
RWEDGE_API double rwedge_series_coefficient(const rwedge_series *series, int32_t k);

/* Error of the series as a pressure. From rwedge_series_fit(): the root mean square of fit minus
 * sample. From rwedge_series_create(): an upper bound of what is cut off, sum |a_k| for k >=
 * terms, valid for the pressure and for |G| anywhere (HUGE_VAL for the sharp wedge, whose
 * coefficients have no finite sum). NaN for NULL. */
RWEDGE_API double rwedge_series_residual(const rwedge_series *series);

/* The pressure at x; 0 for |x| >= 1; NaN outside the domain or NULL.                    Eq. (29) */
RWEDGE_API double rwedge_series_pressure(const rwedge_series *series, double x);

/* Muskhelishvili's potential Phi for q = f p: Phi = -((i+f)/2) sum a_k R^(k+1), R = z -
 * sqrt(z^2-1).                                                           Eq. (30), (34), E2, E3
 * RWEDGE_EDOMAIN, RWEDGE_ENULL. */
RWEDGE_API int32_t rwedge_series_potential(const rwedge_series *series, double f, double x,
                                           double y, double *re, double *im);

/* Stresses for q = f p.                                                              Eq. (32), (33)
 * RWEDGE_EDOMAIN, RWEDGE_ENULL. The derivative converges like the series of R^k at the edges:
 * slowly. */
RWEDGE_API int32_t rwedge_series_stress(const rwedge_series *series, double f, double x, double y,
                                        double *sxx, double *syy, double *txy);

#ifdef __cplusplus
}
#endif
#endif
