# SPDX-License-Identifier: GPL-3.0-or-later
"""The contact of a wedge with a rounded apex and an elastic half-plane.

Formulas are NumPy ufuncs that take arguments by name too: they broadcast, take ``out=`` and ``where=``, and release the GIL.
Outside its domain a formula gives NaN and NumPy's warning "invalid value encountered", as ``numpy.sqrt(-1)`` does
(``numpy.errstate(invalid="raise")`` makes an exception of it); NaN among the arguments gives NaN without a warning.

``Contact`` is a contact with a history of loads, ``Cycle`` what it undergoes in a cycle of them, ``StressHistory`` the stresses
through loads, ``Series`` the paper's series.
``stresses()`` is the ufunc ``stress``, but raises. These raise ValueError outside the domain, and warn of doubtful results
(``ValidityWarning``). NaN among points gives NaN; as a parameter, a load or a sample it is refused.

Natural units in the formulas of alpha = a/b: lengths in b, stresses in theta/A; compression is negative; k is the yield stress
in pure shear. "Eq. (n)" is the numbering of M. Ciavarella, D. A. Hills, G. Monno, "Contact problems for a wedge with rounded
apex", Int. J. Mech. Sci. 40 (1998) 977-988; "E1" ... are its errata as listed in the library's lib/README.md; "new" marks
what the paper does not have.
"""
from ._optional import need as _need

_need("numpy", "rwedge")

from . import _made  # noqa: E402
from ._contact import Contact, YieldFactor
from ._criteria import Damage, Plane
from ._cycle import Cycle, Friction, Growth
from ._files import Case, read_case
from ._library import AbsentError, Error, PathError, SlidingError
from ._library import function as _function
from ._loads import Loads
from ._loop import Loop, loop
from ._made import *  # noqa: F403
from ._named import NAMED as _NAMED
from ._named import Named as _Named
from ._renamed import now_called as _now_called
from ._series import Series
from ._stress_history import StressHistory
from ._tests import Tests, series
from ._ufuncs import UFUNCS as _UFUNCS
from ._ufuncs import Formula as _Formula
from ._ufuncs import Points as _Points
from ._validity import ValidityWarning

_CLASSES = (AbsentError, Case, Contact, Cycle, Damage, Error, Friction, Growth, Loads, Loop, PathError, Plane, Series, SlidingError, StressHistory,
            Tests, ValidityWarning, YieldFactor)
for _class in _CLASSES:
    _class.__module__ = __name__
__version__ = _function("version")().decode()

# All functions of the header that take and give nothing but numbers.
globals().update({name: _Formula(ufunc) for name, ufunc in _UFUNCS.items()})
globals().update({name: _Named(name) for name in _NAMED})
__all__ = [*(_class.__name__ for _class in _CLASSES), "loop", "read_case", "series", "stresses", *_UFUNCS, *_NAMED, *_made.__all__]

_stresses = _Points("stress")


def stresses(alpha, f, c, x, y):
    """Stresses sxx, syy, txy in the broadcast shape of the arguments, as the ufunc ``stress``. A ValueError says which
    arguments are outside the domain; NaN gives NaN. Source: Eq. (28), (32), (33) with E4, E8; new."""
    return _stresses(alpha, f, c, x, y)


def __getattr__(name):
    raise AttributeError(_now_called(name) or f"module 'rwedge' has no attribute '{name}'")
