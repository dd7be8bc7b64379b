# SPDX-License-Identifier: GPL-3.0-or-later
from typing import Any

from numpy import ufunc
from numpy.typing import ArrayLike, NDArray

from ._contact import Contact as Contact
from ._contact import YieldFactor as YieldFactor
from ._library import Error as Error
from ._library import SlidingError as SlidingError
from ._series import Series as Series

__version__: str
__all__ = [
    "Contact", "Error", "Series", "SlidingError", "YieldFactor", "stresses",
    "compliance", "dundurs_beta", "load", "a_over_b", "pressure", "peak_pressure", "transition_pressure", "coefficient",
    "stick_width", "shear_ratio", "shear", "stress", "max_tension", "elastic_limit", "yield_point", "subsurface_yield",
    "surface_yield", "critical_friction", "radius", "rounding", "half_width", "normal_load", "yield_load",
]

# (E1, nu1, E2, nu2)
compliance: ufunc
dundurs_beta: ufunc
# (alpha), but for the inverse: (AP_over_theta_a)
load: ufunc
a_over_b: ufunc
peak_pressure: ufunc
transition_pressure: ufunc
max_tension: ufunc
# (alpha, ...)
pressure: ufunc
coefficient: ufunc
stick_width: ufunc
shear_ratio: ufunc
shear: ufunc
critical_friction: ufunc
# (alpha, f, c, x, y) -> (sxx, syy, txy)
stress: ufunc
# (alpha, f, nu), the last three -> (limit, x, y), (limit, x, y), (limit, x)
elastic_limit: ufunc
yield_point: ufunc
subsurface_yield: ufunc
surface_yield: ufunc
# (theta, ...)
radius: ufunc
rounding: ufunc
half_width: ufunc
normal_load: ufunc
yield_load: ufunc

def stresses(
    alpha: ArrayLike, f: ArrayLike, c: ArrayLike, x: ArrayLike, y: ArrayLike
) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any]]: ...
