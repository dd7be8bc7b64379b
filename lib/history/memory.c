/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The memory diagram as a path in the plane of load and shear.
 *
 * A load adds two corners at most: where its line meets the path, and where it ends. A corner
 * stays until the line of a later load passes beyond it. So the corners are what the state still
 * depends on: rises of different slopes, and extremes of T + s or T - s that no later load has
 * exceeded. Their number grows only with loads that curve, and with reversals each smaller than
 * all that remain. In a repeated cycle the lines meet the path at corners that are there already.
 * Rounding must not leave a sliver at each pass: hence the tolerance. */
#include "history/memory.h"

#include "base/always.h"
#include "base/array.h"
#include "base/domain.h"

#include <float.h>
#include <string.h>

/* A corner is where two lines meet whose ends are rounded by epsilon/2 of the load: four
 * roundings. */
static const double ROUNDINGS = 4 * DBL_EPSILON;

double rw_memory_tolerance(double load)
{
    return ROUNDINGS * load;
}

static const rw_patch NONE = {0, 0}, UNKNOWN = {NAN, NAN};

bool rw_memory_create(rw_memory *memory)
{
    *memory = (rw_memory){.level = 1};
    if (!rw_memory_reserve(memory, 4))
        return false;
    memory->corners[memory->count++] = rw_corner_at((rw_memory_loads){0}, NONE);
    return true;
}

rw_memory rw_memory_copy(const rw_memory *memory, bool *is_whole)
{
    rw_memory copy = *memory;
    copy.corners = rw_copied(memory->corners, memory->count, sizeof *copy.corners, is_whole);
    copy.capacity = memory->count;
    return copy;
}

void rw_memory_destroy(rw_memory *memory)
{
    free(memory->corners);
    *memory = (rw_memory){0};
}

bool rw_memory_reserve(rw_memory *memory, size_t more)
{
    rw_corner *corners =
        rw_grown(memory->corners, memory->count, &memory->capacity, more, sizeof *corners);
    if (corners)
        memory->corners = corners;
    return corners != NULL;
}

rw_path rw_memory_path(const rw_memory *memory)
{
    static const rw_slip_origin WHOLE = {0};
    return (rw_path){memory->corners, &WHOLE, 0, memory->count};
}

size_t rw_memory_common(const rw_memory *memory, const rw_path *earlier)
{
    const size_t most = memory->count < earlier->count ? memory->count : earlier->count;
    size_t i = 1;
    while (i < most && memory->corners[i].load == rw_path_corner(earlier, i)->load &&
           memory->corners[i].ratio == rw_path_corner(earlier, i)->ratio)
        i++;
    return i;
}

static double clipped(double ratio)
{
    return fmax(-1, fmin(1, ratio));
}

static double chord(const rw_corner *from, double load, double shear)
{
    return clipped((shear - from->shear) / (load - from->load));
}

/* Whether the path can go straight from the corner before its end to (load, shear), and leave the
 * end out. Every corner that was left out has narrowed the slopes that are allowed. Otherwise a
 * slow bend in many small steps would be straightened away. */
static bool is_straight(const rw_memory *memory, double load, double shear, double *least,
                        double *most)
{
    if (memory->count < 2)
        return false;
    const rw_corner *end = rw_memory_end(memory), *from = end - 1;
    const double tolerance = rw_memory_tolerance(load);
    const double run = end->load - from->load, rise = end->shear - from->shear;
    *least = fmax(end->least, (rise - tolerance) / run);
    *most = fmin(end->most, (rise + tolerance) / run);
    const double slope = (shear - from->shear) / (load - from->load);
    return *least <= slope && slope <= *most;
}

/* The slope of the straight line that replaces a corner. If the longer part slipped, all did: |D|
 * = 1 tells the zone of slip from that of stick, and a sliver of rounding must not hide it. */
static double joint_ratio(const rw_memory *memory, double load, double shear, double ratio)
{
    const rw_corner *end = rw_memory_end(memory), *from = end - 1;
    if (ratio == end->ratio)
        return ratio;
    const double longer = load - end->load > end->load - from->load ? ratio : end->ratio;
    return fabs(longer) == 1 ? longer : chord(from, load, shear);
}

/* The corners from this one on change. */
static void alter(rw_memory *memory, size_t first)
{
    if (memory->shared > first)
        memory->shared = first;
}

/* A corner is new, or has another tilt. */
static void note_level(rw_memory *memory, size_t i)
{
    const rw_corner *corner = &memory->corners[i];
    if (memory->level >= i)
        memory->level =
            corner->tilt == 0 && corner->stretch == memory->corners[0].stretch ? i + 1 : i;
}

void rw_memory_relevel(rw_memory *memory)
{
    memory->level = 1;
    for (size_t i = 1; i < memory->count; i++)
        note_level(memory, i);
}

static void append(rw_memory *memory, rw_corner corner)
{
    memory->corners[memory->count] = corner;
    note_level(memory, memory->count++);
}

/* A new end of the path. */
static void push(rw_memory *memory, rw_memory_loads to, double ratio)
{
    const double load = to.load, shear = to.shear;
    rw_corner corner = rw_corner_at(to, UNKNOWN);
    corner.ratio = ratio;
    if (load <= rw_memory_end(memory)->load) /* within rounding of the corner that is there */
        return;
    double least, most;
    if (!is_straight(memory, load, shear, &least, &most)) {
        append(memory, corner);
        return;
    }
    corner.ratio = joint_ratio(memory, load, shear, ratio);
    corner.least = least;
    corner.most = most;
    alter(memory, memory->count - 1);
    memory->count--;
    append(memory, corner);
}

double rw_path_shear(const rw_path *path, double load)
{
    size_t low = 0, high = path->count - 1;
    while (low + 1 < high) { /* invariant: corners[low].load <= load <= corners[high].load */
        const size_t middle = low + (high - low) / 2;
        if (rw_path_corner(path, middle)->load <= load)
            low = middle;
        else
            high = middle;
    }
    const rw_corner *after = rw_path_corner(path, high);
    return after->shear - after->ratio * (after->load - load);
}

/* Which way the edge slips in the end on the way to (load, shear); 0 where it does not. */
static int sign_of_slip(const rw_path *path, double load, double shear)
{
    const rw_corner *end = rw_path_end(path);
    const double tolerance = rw_memory_tolerance(fmax(load, end->load));
    const double rise = load < end->load ? shear - rw_path_shear(path, load) : shear - end->shear;
    const double shell = fmax(0, load - end->load); /* takes as much without slip */
    if (fabs(rise) <= shell + tolerance)
        return 0;
    return rise > 0 ? 1 : -1;
}

/* How far the corner lies inside the line of slope `slip` that ends at (load, shear). It falls
 * along the path. */
static double inside(const rw_corner *corner, int slip, rw_memory_loads to)
{
    return (to.load - corner->load) - slip * (to.shear - corner->shear);
}

double rw_memory_missing_tilt(const rw_corner *corner, int slip, rw_memory_loads to)
{
    return (to.tilt - corner->tilt) - slip * (to.stretch - corner->stretch);
}

static rw_corner between(const rw_corner *before, const rw_corner *after, double fraction,
                         double tilt)
{
    const double run = fraction * (after->load - before->load);
    return (rw_corner){.load = before->load + run,
                       .shear = before->shear + run * after->ratio,
                       .tilt = tilt,
                       .stretch = before->stretch + (tilt - before->tilt) * after->ratio,
                       .ratio = after->ratio,
                       .least = after->least,
                       .most = after->most,
                       .patch = UNKNOWN};
}

/* A path that does not slip is cut off there, or goes on from there. */
static rw_departure stuck_departure(const rw_path *path, rw_memory_loads to)
{
    const double load = to.load;
    size_t last = path->count - 1;
    while (rw_path_corner(path, last)->load > load)
        last--;
    const rw_corner *before = rw_path_corner(path, last);
    if (last + 1 == path->count || before->load == load)
        return (rw_departure){*before, last + 1, 0};
    const rw_corner *after = rw_path_corner(path, last + 1);
    const double fraction = (load - before->load) / (after->load - before->load);
    return (rw_departure){between(before, after, fraction, to.tilt), last + 1, 0};
}

rw_departure rw_memory_departure(const rw_memory *memory, rw_memory_loads to)
{
    const rw_path path = rw_memory_path(memory);
    return rw_departure_from(&path, to);
}

rw_departure rw_departure_from(const rw_path *path, rw_memory_loads to)
{
    const double load = to.load;
    const int slip = sign_of_slip(path, load, to.shear);
    if (slip == 0)
        return stuck_departure(path, to);
    const double tolerance = rw_memory_tolerance(fmax(load, rw_path_end(path)->load));
    size_t last = path->count - 1; /* the last corner inside the line; the origin always is */
    while (last > 0 && (rw_path_corner(path, last)->load > load ||
                        inside(rw_path_corner(path, last), slip, to) < -tolerance))
        last--;
    const rw_corner *before = rw_path_corner(path, last);
    const rw_departure at_corner = {*before, last + 1, slip};
    const double depth = inside(before, slip, to);
    /* never: the end of the path is outside the line, or nothing would slip */
    if (NEVER(last + 1 == path->count) || depth <= tolerance)
        return at_corner;
    const rw_corner *after = rw_path_corner(path, last + 1);
    const double beyond = inside(after, slip, to);
    /* what is missing shrinks by 1 -+ D on the way; the line meets no slope that is its own */
    const double shrinks = fmax(1 - slip * after->ratio, DBL_EPSILON);
    const double tilt = before->tilt + rw_memory_missing_tilt(before, slip, to) / shrinks;
    const rw_corner corner = between(before, after, depth / (depth - beyond), tilt);
    /* the line meets the path before it ends, but for rounding */
    return corner.load < load ? (rw_departure){corner, last + 1, slip} : at_corner;
}

/* A step that changes less than the tolerance leaves the path as it is. It does not take over the
 * new values, or many small steps could shift it unnoticed. */
void rw_memory_advance(rw_memory *memory, const rw_departure *departure, rw_memory_loads to)
{
    const double load = to.load, shear = to.shear;
    const rw_corner end = *rw_memory_end(memory);
    const int slip = departure->slip;
    memory->count = departure->kept;
    alter(memory, memory->count);
    if (departure->corner.load > memory->corners[memory->count - 1].load)
        append(memory, departure->corner);
    if (slip != 0) {
        push(memory, to, slip);
    } else if (load < end.load && load > 0) {
        alter(memory, memory->count - 1);
        memory->corners[memory->count - 1].load = load; /* to the last bit */
        memory->corners[memory->count - 1].tilt = to.tilt;
        note_level(memory, memory->count - 1);
    } else if (load > end.load) {
        const double rise = shear - end.shear, run = load - end.load;
        /* a ring of rounding alone, without shear, is not */
        const bool steepest = fabs(fabs(rise) - run) <= fmin(rw_memory_tolerance(load), run / 2);
        push(memory, to, steepest ? (rise > 0 ? 1 : -1) : clipped(rise / run));
    }
}

bool rw_memory_slides(const rw_memory *memory)
{
    return memory->count == 2 && fabs(memory->corners[1].ratio) == 1;
}

void rw_memory_restart(rw_memory *memory, rw_memory_loads to, double ratio)
{
    memory->corners[0] =
        rw_corner_at((rw_memory_loads){.tilt = to.tilt, .stretch = to.stretch}, NONE);
    memory->count = 1;
    alter(memory, 0);
    if (to.load > 0)
        push(memory, to, ratio);
}
