/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "references/memory.hpp"

int sign_beside(const ball &value, const ball &scale)
{
    return is_small(value, scale, bits / 2) ? 0 : sign(value);
}

void path::push(const ball &load, const ball &shear)
{
    const ball run = load - end().load;
    if (sign_beside(run, load) > 0) /* else it is there already */
        corners.push_back({load, shear, (shear - end().shear) / run});
}

/* The last corner with a load that is not above. */
int path::corner_below(const ball &load) const
{
    int i = count() - 1;
    while (i > 0 && sign_beside((*this)[i].load - load, load) > 0)
        i--;
    return i;
}

ball path::shear_at(const ball &load) const
{
    const int i = corner_below(load);
    const corner &below = (*this)[i];
    return i + 1 < count() ? below.shear + (load - below.load) * (*this)[i + 1].ratio : below.shear;
}

/* Beyond the load nothing is left. */
void path::cut_off(const ball &load)
{
    const ball shear = shear_at(load);
    corners.resize(is_zero(load) ? 1 : (size_t)corner_below(load) + 1);
    if (!is_zero(load))
        push(load, shear);
}

/* (load' - s) - slip (shear' - T(s)) at a corner: how far inside the line of slope `slip` that
 * ends at the new load. */
static ball depth_inside(const corner &c, int slip, const ball &load, const ball &shear)
{
    return slip * (c.shear - shear) + load - c.load;
}

/* Back along the path, which ends at the load, to where it meets the line. */
void path::forget(int slip, const ball &load, const ball &shear)
{
    int last = count() - 1;
    while (last > 0 && sign_beside(depth_inside((*this)[last], slip, load, shear), load) < 0)
        last--;
    const corner before = (*this)[last];
    const ball depth = depth_inside(before, slip, load, shear);
    const bool meets = last + 1 < count() && sign_beside(depth, load) > 0;
    const corner after = meets ? (*this)[last + 1] : before;
    corners.resize((size_t)last + 1);
    if (!meets)
        return;
    const ball run =
        (after.load - before.load) * depth / (depth - depth_inside(after, slip, load, shear));
    push(before.load + run, before.shear + run * after.ratio);
}

void path::advance(const ball &load, const ball &shear)
{
    ball run = load - end().load;
    if (sign_beside(run, load) < 0) {
        cut_off(load);
        run = 0;
    }
    const ball rise = shear - end().shear;
    if (sign_beside(abs(rise) - run, load) > 0)
        forget(sign(rise), load, shear);
    push(load, shear);
}
