# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes entries.h: every function that has numbers as a call of one form, with what its arguments and results are. The MEX
file and the tests that go through all functions are loops over this table."""
from __future__ import annotations

import math
import textwrap

from header import Function, Interface, Parameter

TOP = """\
/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Written by bindings/interface/generate.py from include/rwedge.h: change that, not this.
 *
 * Every function of the header that has a number among its arguments or results, or makes an
 * object, as a call of one form. Not here are rwedge_version() and those that free. */
/* clang-format off */
#ifndef RWEDGE_ENTRIES_H
#define RWEDGE_ENTRIES_H

#include "rwedge.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum {{
    ENTRY_ARGUMENTS = {arguments}, /* the most that a function has */
    ENTRY_RESULTS = {results},
    ENTRY_SIZES = {sizes}
}};

/* v: the numbers, each a pointer to one or to an array; n: the sizes; r: the results likewise. An
 * integer is a double that is whole and fits. A function with a value has the status RWEDGE_OK. The
 * value of a function with a text is the text's length. */
typedef int32_t entry_call(void *object, const size_t n[], const double *const v[],
                           double *const r[], void **made);
typedef const char *entry_text(const void *object, const double *const v[]);

typedef struct {{
    const char *name;
    const char *allowed; /* the header's conditions */
    double low, high;
    double smallest; /* but for 0, nothing smaller in magnitude is inside */
    char low_open, high_open; /* the bound itself is outside */
    char or_zero;             /* 0 is inside, though below low */
    char finite;              /* infinity is outside */
    char whole;               /* an int32_t */
    char any;                 /* any double, not a number too */
    signed char sizes[2];     /* of an array, as of a result */
}} entry_argument;

typedef struct {{
    const char *name;
    signed char sizes[2]; /* of an array, or of two dimensions: which of the sizes; -1 for none */
    char optional;        /* may be NULL */
}} entry_result;

/* A size that is no argument of the function: fixed, or told by another function from the numbers
 * v. */
typedef size_t entry_count(const double *const v[]);

typedef struct {{
    const char *name;
    const char *teller; /* the function that tells the size, or NULL where an array does */
    const char *allowed;
    entry_count *count; /* or NULL */
}} entry_size;

typedef struct {{
    const char *name;
    const char *family; /* "contact", "cycle", "series", or "": what it makes, or else takes */
    const char *object; /* the kind that it takes, or "" */
    entry_call *call;
    entry_text *text; /* or NULL where there is none */
    char takes_object, changes_object, makes_object, has_status;
    char pointwise;       /* all its arrays are of one size, point by point */
    char refuses_more;    /* arguments too of which each by itself is inside */
    char may_be_infinite; /* its value, or a result */
    unsigned errors;      /* 1 << status, for those that the header names */
    const char *array_of; /* the function whose results it gives for many points, or NULL */
    int arguments, results, sizes;
    const entry_argument *argument;
    const entry_result *result;
    const entry_size *size;
    const char *path; /* when there is no closed form, or NULL where nothing is said */
}} entry;

/* An integer, or one that no function takes. */
static inline int32_t entry_whole(double v)
{{
    return v >= INT32_MIN && v <= INT32_MAX && v == floor(v) ? (int32_t)v : INT32_MIN;
}}

/* Whether a number is inside the domain of an argument, by itself. */
static inline int entry_allows(const entry_argument *a, double v)
{{
    if (a->any)
        return 1;
    if (isnan(v) || isinf(v))
        return !isnan(v) && !a->finite && v > 0;
    if (a->whole && (v != floor(v) || v < INT32_MIN || v > INT32_MAX))
        return 0;
    if (v == 0 && a->or_zero)
        return 1;
    return v >= a->low && v <= a->high && !(a->low_open && v == a->low) &&
           !(a->high_open && v == a->high) && (v == 0 || fabs(v) >= a->smallest);
}}

#define ENTRY(name, statements)                                                                    \\
    static int32_t entry_##name(void *object, const size_t n[], const double *const v[],           \\
                                double *const r[], void **made)                                    \\
    {{                                                                                              \\
        (void)object, (void)n, (void)v, (void)r, (void)made;                                       \\
        statements;                                                                                \\
    }}

#define TEXT_ENTRY(name, value)                                                                    \\
    static const char *text_##name(const void *object, const double *const v[])                    \\
    {{                                                                                              \\
        (void)object, (void)v;                                                                     \\
        return value;                                                                              \\
    }}                                                                                              \\
    ENTRY(name, const char *const text = text_##name(object, v);                                   \\
          r[0][0] = text ? (double)strlen(text) : NAN; return RWEDGE_OK)
"""
FOUND = """\
/* By its name, or NULL. */
static inline const entry *entry_named(const char *name)
{
    for (int i = 0; i < ENTRY_COUNT; i++)
        if (strcmp(name, entries[i].name) == 0)
            return &entries[i];
    return NULL;
}

/* The function that gives the results of this one for many points, or NULL. */
static inline const entry *entry_of_arrays(const char *name)
{
    for (int i = 0; i < ENTRY_COUNT; i++)
        if (entries[i].array_of && strcmp(entries[i].array_of, name) == 0)
            return &entries[i];
    return NULL;
}
"""


def number(value: float) -> str:
    if math.isinf(value):
        return "INFINITY" if value > 0 else "-INFINITY"
    return repr(value)


def argument(f: Function, p: Parameter) -> str:
    d, sizes = p.domain, [q.name for q in f.sizes]
    whole = p.kind == "int32_t"
    allowed = ", ".join((["whole"] if whole else []) + d.conditions)
    own_sizes = [*(sizes.index(n) for n in p.size), -1, -1][:2]
    flags = [d.low_open, d.high_open, d.or_zero, d.finite, whole, d.any or f.result == "text"]  # a text refuses nothing
    bounds, marks = map(number, (d.low, d.high, d.smallest)), (str(int(x)) for x in flags)
    return f'{{"{p.name}", "{allowed}", {", ".join([*bounds, *marks])}, {{{own_sizes[0]}, {own_sizes[1]}}}}}'


def result(f: Function, name: str, size: tuple[str, ...], optional: bool = False) -> str:
    sizes = [q.name for q in f.sizes]
    own_sizes = [*(sizes.index(n) for n in size), -1, -1][:2]
    return f'{{"{name}", {{{own_sizes[0]}, {own_sizes[1]}}}, {int(optional)}}}'


def size(f: Function, p: Parameter) -> str:
    allowed = ", ".join(p.domain.conditions) if p.domain else ""
    teller = "" if p.given_from else p.given_by
    return f'{{"{p.name}", {quoted(teller)}, "{allowed}", {f"{f.name}_{p.name}" if p.role == "implied" else "NULL"}}}'


def counts(f: Function) -> str:
    """How many numbers there are of each size that is no argument."""
    names = [q.name for q in f.inputs]
    return "".join(f"static size_t {f.name}_{p.name}(const double *const v[])\n{{\n    (void)v;\n    return "
                   + (str(p.fixed) if p.fixed else f"(size_t)rwedge_{p.given_by}(entry_whole(v[{names.index(p.given_from)}][0]))")
                   + ";\n}\n" for p in f.implied)


def quoted(text: str) -> str:
    return f'"{text}"' if text else "NULL"


def call(f: Function) -> str:
    passed = []
    sizes = f.of("size")
    for p in f.parameters:
        k = (f.inputs if p in f.inputs else f.outputs if p in f.outputs else sizes if p in sizes else [p]).index(p)
        passed.append({
            "in": f"v[{k}][0]" if p.kind == "double" else f"entry_whole(v[{k}][0])", "in array": f"v[{k}]", "size": f"n[{k}]",
            "out": f"r[{k}]", "out array": f"r[{k}]", "handle": f"(const rwedge_{p.kind} *)object",
            "changed": f"(rwedge_{p.kind} *)object", "created": f"(rwedge_{p.kind} **)made"}[p.role])
    text = f"rwedge_{f.name}({', '.join(passed)})"
    if f.result == "text":
        return text
    if f.result == "status":
        return f"return {text}"
    conversion = "" if f.returns == "double" else "(double)"
    return f"r[0][0] = {conversion}{text}; return RWEDGE_OK"


def adapter(f: Function) -> str:
    return textwrap.fill(f"{'TEXT_' if f.result == 'text' else ''}ENTRY({f.name}, {call(f)})", 100, subsequent_indent="      ", break_long_words=False) + "\n"


def row(f: Function, statuses: dict[str, int]) -> str:
    arguments, sizes = f.inputs, f.sizes
    flags = [bool(f.of("handle", "changed")), bool(f.of("changed")), bool(f.of("created")), f.result == "status", f.pointwise,
             f.refuses_more, f.may_be_infinite]
    text = f"text_{f.name}" if f.result == "text" else "NULL"
    errors = sum(1 << statuses[e] for e in f.errors)
    lists = [f"{f.name}_{part}" if count else "NULL"
             for part, count in (("arguments", arguments), ("results", f.results), ("sizes", sizes))]
    return (f'    {{"{f.name}", "{f.family}", "{f.object}", entry_{f.name}, {text}, {", ".join(str(int(x)) for x in flags)}, {errors:#x},\n'
            f"     {quoted(f.array_of)}, {len(arguments)}, {len(f.results)}, {len(sizes)}, {', '.join(lists)},\n"
            f"     {quoted(f.path)}}},")


def tables(f: Function) -> str:
    results = [result(f, p.name, p.size, p.optional) for p in f.outputs] or [result(f, name, ()) for name in f.results]
    return counts(f) + "".join(f"static const entry_{kind} {f.name}_{kind}s[] = {{\n    " + ",\n    ".join(items) + "};\n"
                   for kind, items in (("argument", [argument(f, p) for p in f.inputs]), ("result", results),
                                       ("size", [size(f, p) for p in f.sizes])) if items)


def reason(status: str) -> str:
    """A word for it: RWEDGE_EDOMAIN -> domain."""
    return "memory" if status == "RWEDGE_ENOMEM" else status.removeprefix("RWEDGE_").removeprefix("E").lower()


def entries(interface: Interface) -> list[Function]:
    return [f for f in interface.functions if f.result in ("value", "status") or f.result == "text" and f.parameters]


def texts(interface: Interface) -> dict[str, str]:
    listed = entries(interface)
    most = {"arguments": max(len(f.inputs) for f in listed), "results": max(len(f.outputs) for f in listed),
            "sizes": max(len(f.sizes) for f in listed)}
    lines = [TOP.format(**most), *(adapter(f) + tables(f) for f in listed),
             "static const entry entries[] = {", *(row(f, interface.statuses) for f in listed), "};",
             "enum { ENTRY_COUNT = sizeof entries / sizeof entries[0] };", "", FOUND,
             "/* By its number: the reason in an identifier of an error, rwedge:domain. */",
             f"static const char *const entry_reasons[] = {{{', '.join(quoted(reason(s)) for s in interface.statuses)}}};",
             "", "#endif", ""]
    return {"entries.h": "\n".join(lines)}
