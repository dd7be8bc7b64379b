# SPDX-License-Identifier: GPL-3.0-or-later
"""What a line of the header says of an argument: its conditions as texts, and as bounds. README.md has the forms they take."""
from __future__ import annotations

import dataclasses
import math
import re
from dataclasses import dataclass, field

NUMBER = r"-?[\d.]+(?:e-?\d+)?|pi/2|2\^\d+|\S+"
WITHIN = re.compile(rf"({NUMBER}) (<=?) (.+?) (<=?) ({NUMBER})")
BEYOND = re.compile(rf"(\|?\w*\|?) ?([<>]=?) ({NUMBER})(?: .*)?")
TO = re.compile(rf"(0,? or )?({NUMBER}) to ({NUMBER})(?: .*)?")
AT_LEAST = re.compile(rf"(0,? or )?at least ({NUMBER})( of the .*)?")
AT_MOST = re.compile(rf"(?:of )?at most ({NUMBER})(?: in magnitude)")
SMALLEST, LARGEST = 1e-60, 1e60  # the domain of whatever has a size


@dataclass
class Domain:
    """What is said of an argument. text is the header's; conditions are those of its clauses that can be checked."""

    text: str
    conditions: list[str] = field(default_factory=list)
    any: bool = False  # not a number, too
    between: bool = False  # some of them are between arguments: no bound by itself
    low: float = -math.inf
    high: float = math.inf
    low_open: bool = False
    high_open: bool = False
    or_zero: bool = False  # 0 is allowed too, though below low
    finite: bool = True  # HUGE_VAL is outside
    smallest: float = 0.0  # but for 0, nothing smaller in magnitude is inside

    def of_a_size(self) -> Domain:
        """This domain within what the header's first page says of whatever has a size."""
        text = " ".join(self.conditions)
        if self.any or "e60" in text or "e-60" in text:
            return self  # it says so itself
        if self.or_zero and SMALLEST < self.low <= self.high < LARGEST:
            return dataclasses.replace(self, smallest=SMALLEST)  # narrower than that
        signed, zero = self.low < 0, self.or_zero or self.low < 0 or self.low == 0 and not self.low_open
        least = self.or_zero and self.low or SMALLEST
        words = [f"0, or {least:g} to {LARGEST:g}" if math.isinf(self.high) else f"0 or at least {least:g}"]
        words = words if zero else [words[0].removeprefix("0, or ").removeprefix("0 or ")]
        words += ["in magnitude"] * signed + [", or infinite"] * (not self.finite)
        size = " ".join(words).replace("e+", "e").replace(" ,", ",")
        own = [c for c in self.conditions if c != "finite" and not re.fullmatch(r"(\w+ )?>=? 0|0, or at least \S+", c)]
        both = [size] + own if math.isinf(self.high) else own + [size]
        if len(own) == 1 and (match := re.fullmatch(r"0 <= \w+ <= (\S+)", own[0])):
            both = [f"0, or {SMALLEST:g} to {match[1]}"]
        return dataclasses.replace(self, conditions=both, low=max(self.low, -LARGEST), high=min(self.high, LARGEST), smallest=SMALLEST)


def number(text: str) -> float | None:
    """A bound, where it is one number."""
    if text == "pi/2":
        return math.pi / 2
    if match := re.fullmatch(r"2\^(\d+)", text):
        return 2.0 ** int(match[1])
    if match := re.fullmatch(r"(\d+)/(\d+)", text):
        return int(match[1]) / int(match[2])
    try:
        return float(text)
    except ValueError:
        return None


def clauses(text: str) -> list[str]:
    """The parts of a domain's line between commas, up to its first remark; and a remark that begins with "not" or "0 where"."""
    before, *remarks = re.split(r"[;:] ", text)
    parts = before.replace("0, or ", "0\0or ").split(", ")
    return [p.replace("\0", ", ").strip() for p in parts] + [r for r in remarks if r.startswith(("not ", "0 where "))]


def bound(domain: Domain, sign: str, value: float | None, factor: int) -> None:
    """Narrows the domain; a bound that is no number is between arguments."""
    domain.between |= value is None
    if value is None:
        return
    value *= factor
    if sign[0] == ">" and value >= domain.low:
        domain.low, domain.low_open = value, sign == ">"
    if sign[0] == "<" and value <= domain.high:
        domain.high, domain.high_open = value, sign == "<"


def meaning_of(domain: Domain) -> str:
    """What stands before the first condition: "a/b, rounding over contact half-width"."""
    end = min((domain.text.find(condition) for condition in domain.conditions), default=len(domain.text))
    return domain.text[:end].rstrip(" ,;")


def domain_of(text: str, name: str, others: set[str]) -> Domain:
    """The conditions on one argument in the line that it shares with others."""
    domain = Domain(text, finite="HUGE_VAL" not in text)
    for clause in clauses(text):
        limits: list[tuple[str, str, int]] = []  # sign, bound, and its factor
        if clause in ("finite", "any integer", "any number") or clause.startswith(("not ", "0 where ")):
            domain.between |= clause.startswith(("not ", "0 where "))
            domain.any |= clause == "any number"
        elif match := WITHIN.fullmatch(clause):
            if match[3] in others:
                continue
            limits = [(match[2].replace("<", ">"), match[1], 1), (match[4], match[5], 1)]
        elif match := TO.fullmatch(clause):
            domain.or_zero |= bool(match[1])
            limits = [(">=", match[2], 1), ("<=", match[3], 1)]
        elif match := AT_LEAST.fullmatch(clause):
            domain.between |= bool(match[3])
            domain.or_zero |= bool(match[1]) and not match[3]
            limits = [(">=", "0" if match[3] else match[2], 1)]
        elif match := AT_MOST.fullmatch(clause):
            limits = [("<=", match[1], 1), (">=", match[1], -1)]
        elif match := BEYOND.fullmatch(clause):
            if match[1].strip("|") in others:
                continue
            limits = [(match[2], match[3], 1)]
            if match[1].startswith("|"):
                limits.append((match[2].replace("<", ">"), match[3], -1))
        elif not re.search(r"[<>]=|[<>] ", clause):
            continue  # a meaning or a unit
        for sign, limit, factor in limits:
            bound(domain, sign, number(limit), factor)
        domain.conditions.append(clause)
    return domain
