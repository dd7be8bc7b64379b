/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The register of the tuned constants of computed loads and of cracks: lib/traction, fronts,
 * numerical, computed, crack, and lib/cycle/parts.c. Each has what it buys. A constant is here if
 * its value was found by trying, on random loads of tests/random. Sizes of arrays, distances at
 * which rounding counts, and limits of which half and twice as much moves nothing there, stand
 * where they are used. A number "over the tolerance" counts times that of a load. Whoever changes
 * one runs `ctest -C Long -R long_tuned`, which halves and doubles each and prints what
 * moves.
 *
 * No guard: tuned.h includes it, and the test does so once more. */

/* ---- Tractions (lib/traction) ---- */

/* Coefficients at the end of a series that are none, over the tolerance. Shorter series. */
RW_NUMBER(RW_LOST, 1e-4)

/* What a fit may be off at a kink that it has lost, over its tolerance: next to the kink it errs by
 * more than its last coefficients. Fewer kinks, of which each adds elements. */
RW_NUMBER(RW_AT_KINK, 5)

/* The fit of what a shear adds to a pressure (bounded_inverse.c), over the tolerance of a sum.
 * Fewer places where that is computed. */
RW_NUMBER(RW_FIT_OF_INVERSE, 3)

/* ---- One step (lib/fronts) ---- */

/* The fit of friction over the tolerance, a tenth of that of a traction, whose elements have other
 * ends. */
RW_NUMBER(RW_FIT_OF_FRICTION, 1e-3)

/* The ratio of neighbouring panels of the quadrature towards a front: fewer points, or better
 * ones. */
RW_NUMBER(RW_PANEL_RATIO, 0.12)

/* Terms of a gap that are left out, over the tolerance and the largest. Fewer terms. */
RW_NUMBER(RW_LEAST_TERM, 1e-7)

/* A step of Newton's method that leaves more than this of the residual asks for a new Jacobian. */
RW_NUMBER(RW_POOR, 0.1)

/* A front that would move by more than this angle is not moved by its slope. */
RW_NUMBER(RW_FLAT, 1)

/* Violations of Coulomb's law and of the sense of slip that count as none, over the tolerance. */
RW_NUMBER(RW_ALLOWED, 0.2)

/* ---- The search for zones (lib/numerical/search.c) ---- */

/* Residuals that may be spent front by front, by Newton's method for each unknown and one more, and
 * on the zones of a step; what each outcome counts of the last. It succeeds with fewer, if at all:
 * beyond that a shorter step is better. */
RW_COUNT(RW_RELAX_BUDGET, 120)
RW_COUNT(RW_NEWTON_TURNS, 10)
RW_COUNT(RW_SEARCH_BUDGET, 500)
RW_COUNT(RW_OUTCOME_COUNTS, 20)

/* The residual at which Newton's method ends, over the tolerance. */
RW_NUMBER(RW_RESIDUAL, 1e-5)

/* Changes of D at the beginning that count as none, over the tolerance; how often it is looked
 * at. */
RW_NUMBER(RW_SAME_RATIO, 0.1)
RW_COUNT(RW_RATIO_TURNS, 4)

/* An old front as near as this, in angles of the grid, gives the start of a new one, so far inside
 * what stuck, where the residual is steep. */
RW_NUMBER(RW_NEAR_OLD_FRONT, 2.5)
RW_NUMBER(RW_BESIDE_OLD_FRONT, 0.05)

/* The angle of a zone that is too narrow to be determined, over the tolerance to the power 2/3. */
RW_NUMBER(RW_SLIVER, 0.1)

/* ---- Passes of unlike bodies (coupled.c) ---- */

/* Passes go on until the shear changes by less than this part of the tolerance. */
RW_NUMBER(RW_SAME_SHEAR, 0.1)

/* What a pass costs, for an element of both tractions each, over what a residual costs for a value
 * and a zone that sticks each. Measured over the nine cases of tests/data/unlike_loads.csv and 30
 * random histories of three loads: 1590 ns and 27 ns. One by one it was 11 to 190, of half of them
 * 73 to 107; long loads, whose effort may end, weigh most. */
RW_COUNT(RW_EFFORT_OF_PASS, 60)

/* Traction beyond friction, over the scale, at new places in contact that slip in passing. */
RW_NUMBER(RW_RIM, 5e-3)

/* ---- The state after a step (outcome.c, rates.c) ---- */

/* Places between two breaks at which Coulomb's law is looked at; places of a zone at which the
 * rates are. */
RW_COUNT(RW_CHECKS, 24)
RW_COUNT(RW_RATE_POINTS, 24)

/* The fit of a traction over the tolerance. Steps with a change of the loads below RW_SMALL_STEP
 * over friction are fitted better, but not more than by RW_BEST_FIT. */
RW_NUMBER(RW_FIT, 0.03)
RW_NUMBER(RW_SMALL_STEP, 0.1)
RW_NUMBER(RW_BEST_FIT, 0.1)

/* Jumps of an old fit that a new one does not follow, over the tolerance of the fit. Fewer
 * elements. */
RW_NUMBER(RW_FIT_NOISE, 30)

/* ---- One step, and its error (step.c) ---- */

/* A step with a larger change of its loads, over friction, is looked at half-way too. */
RW_NUMBER(RW_LARGE_STEP, 0.25)

/* The excess at the beginning that counts as none, over RW_ALLOWED. It tells too little of an
 * error. */
RW_NUMBER(RW_LITTLE_EXCESS, 0.05)

/* Tractions are not compared nearer to a front, over the half-width: q rises there like a root. The
 * header promises the error beyond it. */
RW_NUMBER(RW_AT_FRONT, 0.01)

/* The error over the difference of a step from its halves; where the contact changes; at places
 * that are new in contact. They make the told error one in 99 of 100 loads. */
RW_NUMBER(RW_DOUBT, 2)
RW_NUMBER(RW_DOUBT_IF_CHANGED, 3)
RW_NUMBER(RW_DOUBT_IF_NEW, 0.75)

/* Where that error is largest: the part of the way from the edge to where it was. */
RW_NUMBER(RW_WORST_PLACE, 0.2)

/* What a difference of D half-way, and one of shear over friction at the end, makes of the traction
 * on average: (1/4)(2/3), and 1/3, of differences that are quadratic in time. */
RW_NUMBER(RW_OF_RATIO, 1.0 / 6)
RW_NUMBER(RW_OF_RATIO_AT_END, 1.0 / 3)

/* Where shear over friction is read at an edge, over the width of the new ring. Nearer the fit
 * counts, farther the change of D. */
RW_NUMBER(RW_BESIDE_EDGE, 0.01)

/* Energies may differ by this many times the tolerance of tractions: theirs is of second order. */
RW_NUMBER(RW_ENERGY_APART, 30)

/* ---- The onset of slip (onset.c) ---- */

/* A step is not cut nearer to its ends; slip begins where |D| is 1 less RW_ONSET_CLOSE, found to
 * this part of the step, in so many turns, or halvings where slip turns round. */
RW_NUMBER(RW_ONSET_NEAREST, 0.02)
RW_NUMBER(RW_ONSET_CLOSE, 1e-3)
RW_NUMBER(RW_ONSET_EXACT, 1e-3)
RW_COUNT(RW_ONSET_TURNS, 12)
RW_COUNT(RW_ONSET_HALVINGS, 6)

/* ---- Energy (energy.c) ---- */

/* What the energy by slip errs by, over its doubt, of a step as a whole and of halves; the relative
 * error beyond which the power is looked at, that of its rules with which it ends, and how often a
 * part of the way is halved for it: the power jumps where slip passes marks of earlier loads. */
RW_NUMBER(RW_ENERGY_OF_WHOLE, 0.2)
RW_NUMBER(RW_ENERGY_OF_HALVES, 0.04)
RW_NUMBER(RW_ENERGY_ENOUGH, 0.03)
RW_NUMBER(RW_ENERGY_EXACT, 0.01)
RW_COUNT(RW_ENERGY_HALVINGS, 8)

/* The violation, over RW_ALLOWED, up to which zones at a moment may be like those of the next
 * moment that is known. With more the power would jump too early. */
RW_NUMBER(RW_LIKE_GUESS, 0.1)

/* ---- Steps of a load (lib/numerical, lib/computed) ---- */

/* The fit of slip, and the error of fits that is told, over the tolerance. */
RW_NUMBER(RW_FIT_OF_SLIP, 0.03)
RW_NUMBER(RW_FIT_AT_MOST, 0.1)

/* The next step, over this one: at least, at most, where the error is not known, and over what a
 * second order says. */
RW_NUMBER(RW_SHORTER, 0.1)
RW_NUMBER(RW_LONGER, 2)
RW_NUMBER(RW_IF_UNKNOWN, 0.5)
RW_NUMBER(RW_CAREFUL, 0.8)

/* The largest tolerance to which a part of a load, or a load that is tried again, is computed. */
RW_NUMBER(RW_LOOSEST, 1e-2)

/* P grows or falls so many times at most in one step. */
RW_NUMBER(RW_FOLD, 4)

/* How far loads may be off a straight line, as a traction over friction; the error of the fit where
 * all has stuck since the bodies touched; both over the tolerance. */
RW_NUMBER(RW_STRAY, 0.1)
RW_NUMBER(RW_TOUCH_ERROR, 0.01)

/* What is left of the load at the end of the way to separation. */
RW_NUMBER(RW_LAST_TOUCH, 0.01)

/* ---- Cycles (lib/cycle/parts.c) ---- */

/* What an edge moves by in a part of a load, over the half-width, in closed form, and computed.
 * Slip of places that the contact leaves. */
RW_NUMBER(RW_EDGE_MOVE, 0.003)
RW_NUMBER(RW_COMPUTED_EDGE_MOVE, 0.005)

/* ---- Cracks (lib/crack) ---- */

/* Lengths an octave at which the range of K is looked at, so that no dip is missed. */
RW_COUNT(RW_CRACK_STEPS, 16)

/* The relative error of a life where faces press on each other: K has a kink wherever a place
 * closes. */
RW_NUMBER(RW_CLOSING_LIFE_ERROR, 1e-6)

/* Parts of a crack's line for its overlap. */
RW_COUNT(RW_OVERLAP_PARTS, 16)

/* Places nearer to the mouth than this, over the length, do not press on each other. Fewer
 * openings. */
RW_NUMBER(RW_NEXT_TO_MOUTH, 1e-3)
