# SPDX-License-Identifier: GPL-3.0-or-later
"""The mutants of a C source: small faults that a programmer might make, one at a time; README.md says which, and why not
others."""

import re
from collections import namedtuple

Token = namedtuple("Token", "kind text start end")
Mutant = namedtuple("Mutant", "start end text")  # replaces source[start:end]

TOKEN = re.compile(
    r"(?P<skipped>/\*.*?\*/|//[^\n]*|^[ \t]*\#(?:[^\n]*\\\n)*[^\n]*|\s+)"
    r"|(?P<text>\"(?:\\.|[^\"\\])*\"|'(?:\\.|[^'\\])*')"
    r"|(?P<number>0[xX][0-9a-fA-F.]+(?:[pP][+-]?\d+)?|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)"
    r"|(?P<name>[A-Za-z_]\w*)"
    r"|(?P<operator><<=|>>=|\.\.\.|->|\+\+|--|&&|\|\||[-+*/%&|^=!<>]=|<<|>>|[^\w\s])",
    re.DOTALL | re.MULTILINE,
)

BINARY = {
    "+": "-", "-": "+", "*": "/", "/": "*", "%": "*", "+=": "-=", "-=": "+=", "*=": "/=", "/=": "*=",
    "<": ">=", "<=": ">", ">": "<=", ">=": "<", "==": "!=", "!=": "==",
    "&&": "||", "||": "&&", "<<": ">>", ">>": "<<",
}
ANYWHERE = {"++": "--", "--": "++", "!": ""}
UNARY = {"-": ""}
FUNCTIONS = {"fmin": "fmax", "fmax": "fmin", "sin": "cos", "cos": "sin", "fabs": ""}
KEYWORDS = {"return", "case", "sizeof", "else", "do", "goto"}
DECLARATIONS = {"const", "static", "double", "int", "bool", "size_t", "struct", "typedef", "enum", "void", "int32_t",
                "uint32_t", "uint64_t", "char", "case", "default"}


def tokens(source):
    found = [Token(m.lastgroup, m.group(), m.start(), m.end()) for m in TOKEN.finditer(source)]
    return [token for token in found if token.kind != "skipped"]


def ends_a_value(token):
    return token.kind in ("number", "name") and token.text not in KEYWORDS or token.text in (")", "]")


def of_operators(all_tokens):
    for before, token in zip(all_tokens, all_tokens[1:]):
        if token.kind != "operator":
            continue
        replacements = ANYWHERE | (BINARY if ends_a_value(before) else UNARY)
        if token.text in replacements:
            yield Mutant(token.start, token.end, replacements[token.text])


def of_names(all_tokens):
    """Another function, the other part of a complex number."""
    for token in all_tokens:
        if token.kind != "name":
            continue
        if token.text in FUNCTIONS:
            yield Mutant(token.start, token.end, FUNCTIONS[token.text])
        elif token.text in ("re", "im") or token.text.endswith(("_re", "_im")):
            yield Mutant(token.start, token.end, token.text[:-2] + ("im" if token.text.endswith("re") else "re"))


def of_numbers(all_tokens):
    """Off by one; not in static const and enum, where the house names what steers an algorithm."""
    steering, before = False, None
    for token in all_tokens:
        steering = token.text != ";" and (steering or token.text == "enum" or (before, token.text) == ("static", "const"))
        before = token.text
        if token.kind == "number" and not steering:
            yield Mutant(token.start, token.end, f"({token.text} + 1)")


def closing(all_tokens, opening):
    """Where the parenthesis that opens there is closed."""
    depth = 0
    for i in range(opening, len(all_tokens)):
        depth += {"(": 1, ")": -1}.get(all_tokens[i].text, 0)
        if depth == 0:
            return i
    raise ValueError("parenthesis without end")


def of_conditions(all_tokens):
    for i, token in enumerate(all_tokens):
        if token.text == "if":
            start, end = all_tokens[i + 1].end, all_tokens[closing(all_tokens, i + 1)].start
            yield Mutant(start, end, "0")
            yield Mutant(start, end, "1")


def statements(all_tokens):
    """First and last token of each that ends in a semicolon."""
    controls = {closing(all_tokens, i + 1) for i, t in enumerate(all_tokens) if t.text in ("if", "for", "while", "switch")}
    depth, first = 0, 0
    for i, token in enumerate(all_tokens):
        depth += {"(": 1, ")": -1}.get(token.text, 0)
        if depth > 0:
            continue
        if token.text == ";":
            yield all_tokens[first], token
        if token.text in (";", "{", "}", ":", "else", "do") or i in controls:
            first = i + 1


def of_statements(all_tokens):
    for first, last in statements(all_tokens):
        if first.text == "return":
            for value in "0", "1":
                yield Mutant(first.end, last.start, " " + value)
        elif first.text != ";" and first.text not in DECLARATIONS:
            yield Mutant(first.start, last.start, "")


def mutants(source):
    """All that differ from the source and from each other, in their order in it."""
    all_tokens, found = tokens(source), {}
    for make in of_operators, of_names, of_numbers, of_conditions, of_statements:
        for mutant in make(all_tokens):
            found[applied(mutant, source)] = mutant
    found.pop(source, None)
    return sorted(found.values())


def applied(mutant, source):
    return source[:mutant.start] + mutant.text + source[mutant.end:]


def described(mutant, source):
    """Line number, the line as it was, and as it is; of a longer change the first line."""
    number = source.count("\n", 0, mutant.start) + 1
    changed = applied(mutant, source)
    return number, source.splitlines()[number - 1].strip(), changed.splitlines()[number - 1].strip()
