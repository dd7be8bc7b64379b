#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The reader of the header: what it finds, and that it refuses what breaks a convention, with the number of the line.

The conventions are also those that MATLAB's loadlibrary and clib take, by MathWorks' pages "Limitations to Shared Library
Support", "Pass Arguments to Shared C Library Functions" and "Limitations to C/C++ Support": numbers, arrays of doubles and
pointers to structures that are not defined, and no callbacks, structures by value, variadic functions or macros with arguments.
"""
import math
import tempfile
import unittest
from pathlib import Path

import write_matlab
import write_python
from header import Refused, read

HEADER = Path(__file__).resolve().parents[2] / "include" / "rwedge.h"
# In place of the last function.
REFUSED = """\
RWEDGE_API double rwedge_v(double (*function)(double));
RWEDGE_API double rwedge_v(double _Complex x);
RWEDGE_API double rwedge_v(int32_t n, ...);
RWEDGE_API double rwedge_v(unsigned n);
RWEDGE_API double rwedge_v(double **x);
RWEDGE_API double rwedge_v(rwedge_contact contact);
RWEDGE_API double *rwedge_v(double x);
RWEDGE_API double rwedge_v(const char **text);
RWEDGE_API double rwedge_v();
typedef struct { double x; } rwedge_v;
static double rwedge_v(double x) { return x; }
#define RWEDGE_V(x) (x)
RWEDGE_API double rwedge_v(double unheard_of);
RWEDGE_API double rwedge_v(double x, double *y);
RWEDGE_API int32_t rwedge_v(const double x[], double *y);
RWEDGE_API int32_t rwedge_v(const rwedge_contact *contact, double *y);
RWEDGE_API int32_t rwedge_contact_v(size_t n, const double x[], size_t m, const double y[], double p[]);
RWEDGE_API double rwedge_load(double alpha);
""".splitlines()


def declared(comment, declaration):
    """The description of a function that is added to the header."""
    text = HEADER.read_text(encoding="ascii")
    before, after = text.split("\n#ifdef __cplusplus\n}\n")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "rwedge.h"
        path.write_text(f"{before}\n{comment}\n{declaration}\n\n#ifdef __cplusplus\n}}\n{after}", encoding="ascii")
        return read(path).functions[-1], before.count("\n") + 1 + comment.count("\n") + 1


class Objects(unittest.TestCase):
    def test_an_object_may_be_made_of_one_of_another_kind(self):
        interface = read(HEADER)
        made, copied, friction = (interface[name] for name in ("cycle_create", "contact_copy", "cycle_friction"))
        self.assertEqual((made.family, made.object, made.is_copy), ("cycle", "contact", False))
        self.assertEqual((copied.family, copied.object, copied.is_copy), ("contact", "contact", True))
        self.assertEqual((friction.family, friction.object), ("cycle", "cycle"))
        self.assertEqual(list(interface.objects), ["contact", "cycle", "series"])


class Texts(unittest.TestCase):
    def test_an_argument_says_what_it_is_where_a_function_narrows_its_domain(self):
        """A line such as "alpha  0, or at least 1e-14" stands for the domain alone: the meaning is that of the list for all."""
        interface = read(HEADER)
        texts = {f.name: {p.name: p.domain.text for p in f.parameters if p.domain} for f in interface.functions}
        of_ratio = "a/b, rounding over contact half-width"
        self.assertEqual(texts["yield_point"]["alpha"], f"{of_ratio}, 0, or at least 1e-14")
        self.assertTrue(texts["elastic_limit"]["alpha"].startswith(f"{of_ratio}, 0, or at least 1e-14: "))
        self.assertTrue(texts["load"]["alpha"].startswith(f"{of_ratio}, finite, "))

    def test_the_help_speaks_of_its_own_language(self):
        """C's places in memory, statuses, and arguments that only C has, are not in it."""
        interface = read(HEADER)
        for name, text in write_matlab.texts(interface).items():
            self.assertIn("\n%   ", text)
            self.assertNotRegex(text, r"\[i n \+ j\]|loads \* n|receives? n|% +loads  |rwedge_(contact|cycle|series)_\w+\(\)|NULL|rwedge:null"
                                r"|_destroy\(\)|Unless|RWEDGE_(E[A-Z]+|OK|(MEASURE|FACES)_\w+)\b")
            self.assertTrue(name in ("rwedge_contact.m", "rwedge_cycle.m", "rwedge_series.m") or "rwedge:handle" not in text)
        for f in interface.functions:
            doc = write_python.docstring(f, "new")
            if f.name not in ("version", "strerror") and not f.name.endswith("_destroy"):
                self.assertNotRegex(doc, r"RWEDGE_(E[A-Z]+|OK|(MEASURE|FACES)_\w+)\b|rwedge_|NULL|HUGE_VAL|Free with", f.name)
                self.assertNotRegex(doc.split("\n\n")[1], "^(NaN|Relative) ")  # what it is, first
                for p in f.inputs:
                    self.assertRegex(doc, rf"\n{p.name} : .*\n    \S", f.name)

    def test_the_help_of_python_has_its_types_and_exceptions(self):
        interface = read(HEADER)
        doc = {name: write_python.docstring(interface[name], "new") for name in ("validity", "contact_edges", "load", "criterion")}
        self.assertIn("theta : float\n", doc["validity"])
        self.assertIn("Raises\n------\nAbsentError\n    when separated\n", doc["contact_edges"])
        self.assertIn("alpha : array_like\n", doc["load"])
        self.assertIn("sxx : array_like, (..., n)\n", doc["criterion"])


class Reader(unittest.TestCase):
    def test_what_breaks_a_convention_is_refused_with_its_line(self):
        for declaration in REFUSED:
            with self.subTest(declaration), self.assertRaises(Refused) as refused:
                declared("/* V. */", declaration)
            line = HEADER.read_text(encoding="ascii").split("\n#ifdef __cplusplus\n}\n")[0].count("\n") + 3
            self.assertIn(f"rwedge.h:{line}: ", str(refused.exception))

    def test_no_function_has_more_than_a_dozen_parameters(self):
        listed = ", ".join(f"double x{i}" for i in range(13))
        with self.assertRaisesRegex(Refused, "13 parameters"):
            declared("/* A value. */", f"RWEDGE_API double rwedge_v({listed});")

    def test_comments_that_break_a_convention_are_refused(self):
        for comment in ("", "/* V.\n *   z  not an argument of it */", "/* V.\n *   v  receives m numbers */"):
            with self.subTest(comment), self.assertRaises(Refused):
                declared(comment, "RWEDGE_API int32_t rwedge_v(double x, size_t n, const double y[], double v[]);")

    def test_all_that_is_said_of_a_function_is_found(self):
        stress = read(HEADER)["stress"]
        self.assertEqual([p.role for p in stress.parameters], ["in"] * 5 + ["out"] * 3)
        self.assertEqual((stress.result, stress.section, stress.family), ("status", "Interior stresses", ""))
        self.assertEqual(stress.equation, "Eq. (28), (32), (33) with E4, E8; new")
        self.assertEqual(stress.errors, ["RWEDGE_EDOMAIN", "RWEDGE_ENULL"])
        self.assertEqual(len(stress.accuracy), 1)
        y = stress.parameters[4].domain
        self.assertEqual((y.low, y.low_open, y.finite), (0, False, True))
        self.assertEqual(y.conditions, ["0, or 1e-60 to 1e60", "not the apex (0, 0) of the sharp wedge"])
        stresses = read(HEADER)["stresses"]
        self.assertEqual((stresses.array_of, stresses.equation, stresses.errors), ("stress", stress.equation, stress.errors))
        self.assertEqual(stresses.parameters[4].size, ("n",))

    def test_domains_become_bounds(self):
        for text, expected in {  # low, high, low_open, high_open, or_zero, finite
                "0, or 1e-3 to 2^4: remark": (1e-3, 16, False, False, True, True), "at least 3": (3, 1e60, False, False, False, True),
                "|p| <= 1/2": (-0.5, 0.5, False, False, False, True),
                "|p| < pi/2": (-math.pi / 2, math.pi / 2, True, True, False, True), "> 0; HUGE_VAL too": (0, 1e60, True, False, False, False),
                "-1 < p <= 0.5, finite": (-1, 0.5, True, False, False, True)}.items():
            d = declared(f"/* V.\n *   p  {text} */", "RWEDGE_API double rwedge_v(double p);")[0].parameters[0].domain
            with self.subTest(text):
                self.assertEqual((d.low, d.high, d.low_open, d.high_open, d.or_zero, d.finite), expected)

    def test_what_has_a_size_has_the_domain_of_the_first_page(self):
        interface = read(HEADER)
        alpha, x = (p.domain for p in interface["pressure"].inputs)
        self.assertEqual((alpha.low, alpha.high, alpha.smallest, alpha.conditions), (0, 1e60, 1e-60, ["0, or 1e-60 to 1e60"]))
        self.assertEqual((x.low, x.high, x.smallest, x.conditions), (-1e60, 1e60, 1e-60, ["0, or 1e-60 to 1e60 in magnitude"]))
        E1, nu1, *_ = (p.domain for p in interface["compliance"].inputs)
        self.assertEqual((E1.conditions, nu1.conditions, nu1.smallest), (["1e-60 to 1e60, or infinite"], ["-1 < nu <= 0.5"], 0))
        self.assertEqual(interface["elastic_limit"].inputs[0].domain.conditions, ["0, or 1e-14 to 1e60"])
        function, _ = declared("/* V.\n *   sxx  of at most 1e60 in magnitude */", "RWEDGE_API double rwedge_v(double sxx);")
        self.assertEqual(function.inputs[0].domain.smallest, 0)  # it says so itself

    def test_what_else_is_refused_and_what_may_be_infinite_is_found(self):
        interface = read(HEADER)
        refusing = [f.name for f in interface.functions if f.refuses_more]
        self.assertLessEqual({"pressure", "stress", "stresses", "half_width", "contact_load", "contact_slip"}, set(refusing))
        self.assertFalse({"load", "coefficient", "elastic_limit", "contact_half_width", "series_pressure"} & set(refusing))
        self.assertLessEqual({"yield_load", "series_residual"}, {f.name for f in interface.functions if f.may_be_infinite})
        self.assertFalse(interface["load"].may_be_infinite or interface["compliance"].may_be_infinite)

    def test_only_what_takes_arrays_is_a_formula_of_arrays(self):
        """A maker of a contact, "the same" of another one, once stood in for it."""
        interface = read(HEADER)
        self.assertIn("The same", interface["contact_create_flat"].text)
        pairs = {f.array_of: f.name for f in interface.functions if f.array_of}
        self.assertLessEqual({("stress", "stresses"), ("elastic_limit", "elastic_limits")}, set(pairs.items()))
        self.assertEqual([name for name in pairs.values() if not interface[name].of("in array")], [])


if __name__ == "__main__":
    unittest.main()
