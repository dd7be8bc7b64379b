# SPDX-License-Identifier: GPL-3.0-or-later
"""Pieces of formulas that several cells share, as texts.

The table of yield has a row for each of 51 tips, and 16 blocks of Poisson's ratio with 21 columns of f: the same f at the next
nu is 21 columns on. A piece that stands at three nu takes a function of this shift."""

THREE_NU = ("", "+21", "+42")


# ---- Conditions and texts; each of a list begins with "; ", which the first one loses ----

def ok(value):
    return f'IF(rwt_ok=1,{value},"")'


def not_above_0(cell):
    return f"OR({cell}<1E-60,{cell}>1E+60)"


def not_poisson(cell):
    return f"OR({cell}<0,{cell}>0.5)"


def when(condition, text):
    return f'IF({condition},"; {text}","")'


def listed(*texts):
    return 'MID(""&' + "&".join(texts) + ",3,2000)"


def give_one(one, other):
    return f'IF(OR(rw_{one}="",rw_{other}=""),"","; {one} and {other}: give one of the two")'


def one_missing(one, other):
    return f'IF(AND(rw_{one}="",rw_{other}=""),"; {one} or {other} is missing","")'


def wrong_input(cell):
    """The text about what is typed into an input."""
    missing = f'IF({cell.needed}="","; {cell.column} is missing","")' if cell.needed else '""'
    return f'IF({cell.name}="",{missing},IF({cell.wrong},"; {cell.column} must be {cell.must}",""))'


def short(cell, digits):
    """So many significant digits of a text; spreadsheets round to 20 places at most."""
    return f"ROUND({cell},MAX(-20,MIN(20,{digits}-1-INT(LOG10(MAX(1E-99,ABS({cell})))))))"


# ---- a/b from x = theta a/(A P): Newton on a^2/(phi0 + a c0) = x, nearly a straight line; the parabola that it starts from is
# exact at both ends ----

def cosine(tip):
    return f"SQRT((1-{tip})*(1+{tip}))"


def first_guess(x):
    return f"{x}*(2-(4/PI()-1)*PI()^2/4*{x})"


def newton(tip, x):
    load = f"(ASIN({tip})+{tip}*{cosine(tip)})"
    return f"MIN(1,{tip}-({tip}^2*{load}-{x}*{load}^2)/(2*ASIN({tip})*{tip}))"


# ---- Weights of a parabola; the three nodes of nu and of f ----

def lagrange(x, node, second, third):
    return f"({x}-{second})*({x}-{third})/(({node}-{second})*({node}-{third}))"


def m_at(step):
    return f"INDEX(rwt_ms,rwt_kn+{step})"


def f2_at(step):
    return f"INDEX(rwt_f,rwt_fn+{step})^2"


def weigh(piece):
    return "+".join(f"rwt_wn{i}*{piece(nu)}" for i, nu in enumerate(THREE_NU, 1))


def product(piece):
    return "*".join(piece(nu) for nu in THREE_NU)


def total(piece):
    return "+".join(piece(nu) for nu in THREE_NU)


# ---- Cells of the table: three f of one row; of three rows; of all rows ----

def row(table, number, nu):
    return f"INDEX({table},{number},rwt_col{nu}):INDEX({table},{number},rwt_col+2{nu})"


def rows(table, number, nu):
    return f"INDEX({table},{number},rwt_col{nu}):INDEX({table},{number}+2,rwt_col+2{nu})"


def every_row(table, nu):
    columns = [f"INDEX({table},0,rwt_col{step}{nu})" for step in ("", "+1", "+2")]
    return "(" + "+".join(f"rwt_wf{i}*{column}" for i, column in enumerate(columns, 1)) + ")"


def every_there(table, nu):
    return "*".join(f"INDEX({table},0,rwt_col{step}{nu})" for step in ("", "+1", "+2"))


def at_row(table, number):
    return weigh(lambda nu: f"SUMPRODUCT({row(table, number, nu)}*rwt_wf)")


def at_rows(weights, table, number):
    """Three tips, weighted. MMULT takes no empty cells, but those plus 0."""
    return weigh(lambda nu: f"SUMPRODUCT(MMULT({weights},{rows(table, number, nu)}+0)*rwt_wf)")


def if_row(number, value):
    """0 where the branch below the surface is not whole."""
    there = total(lambda nu: f"SUMPRODUCT(--({row('rwt_below', number, nu)}>0))")
    return f"IF({there}=9,{value},0)"


def if_rows(value):
    there = total(lambda nu: f"SUMPRODUCT(--({rows('rwt_below', 'rwt_node', nu)}>0))")
    return f"IF({there}=27,{value},0)"


# ---- All f, or the one at a node, at this a/b and nu: J2, and whether the branch is whole ----

def every_f(table, nu):
    return f"INDEX({table},rwt_node,rwt_col-rwt_fn+1{nu}):INDEX({table},rwt_node+2,rwt_col-rwt_fn+21{nu})"


def at_every_f(table):
    return weigh(lambda nu: f"MMULT(rwt_wt,{every_f(table, nu)}+0)")


def column(table, node, nu):
    return f"INDEX({table},rwt_node,rwt_col-rwt_fn+{node}{nu}):INDEX({table},rwt_node+2,rwt_col-rwt_fn+{node}{nu})"


def at_f(table, node, nu):
    return f"SUMPRODUCT(MMULT(rwt_wt,{column(table, node, nu)}+0))"


def gap(node):
    return weigh(lambda nu: f"({at_f('rwt_surface', node, nu)}-{at_f('rwt_below', node, nu)})")


def is_there(node):
    return f"SUMPRODUCT({product(lambda nu: f'''({column('rwt_below', node, nu)}>0)''')})"


# ---- A table of limits: 10 rows of a/b, three blocks of nu with 65 columns of f, 1/80 apart ----

LIMIT_NU = ("", "+65", "+130")


def limit_at(table, weights, node):
    """P/(bk) at the f and nu of the case, by parabolas through three rows, three f and three nu."""
    return "+".join(
        f"rwt_lwm{i}*SUMPRODUCT(MMULT({weights},INDEX({table},{node},rwt_lf{nu}):INDEX({table},{node}+2,rwt_lf+2{nu}))*rwt_lwf)"
        for i, nu in enumerate(LIMIT_NU, 1))


def of_material(constant):
    """A constant of the material that is chosen; empty where it has none."""
    value = f"INDEX({constant},MATCH(rw_material,rw_material_names,0))"
    return f'IF(rw_material="","",IFERROR(IF({value}="","",{value}),""))'
