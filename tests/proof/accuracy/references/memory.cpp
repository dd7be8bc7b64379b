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

/* A linear function of load and shear is not negative at the origin. */
template <typename Linear> void path::cut_off(const ball &scale, const Linear &inside)
{
    int last = count() - 1;
    while (last > 0 && sign_beside(inside((*this)[last]), scale) < 0)
        last--;
    const corner before = (*this)[last], after = last + 1 < count() ? (*this)[last + 1] : before;
    const ball depth = inside(before);
    const bool is_crossed = last + 1 < count() && sign_beside(depth, scale) > 0;
    corners.resize((size_t)last + 1);
    if (is_crossed) {
        const ball run = (after.load - before.load) * depth / (depth - inside(after));
        push(before.load + run, before.shear + run * after.ratio);
    }
}

/* Beyond the load nothing is left, nor beyond the line of slope 1 or -1 that ends there. */
void path::advance(const ball &load, const ball &shear)
{
    cut_off(load, [&](const corner &c) { return load - c.load; });
    const ball run = load - end().load, rise = shear - end().shear;
    if (sign_beside(abs(rise) - run, load) > 0) {
        const int slip = sign(rise);
        cut_off(load, [&](const corner &c) { return slip * (c.shear - shear) + load - c.load; });
    }
    push(load, shear);
}
