#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Computes every constant of stdlib/elementary.h with mpmath, which is the source of those tables.

    coefficients.py            prints the tables, as C
    coefficients.py --check    fails unless stdlib/elementary.h and docs/elementary.md contain all of them

A polynomial is a minimax polynomial: Remez's exchange finds the one whose largest error is smallest.
"""
import re
import sys

from mpmath import mp, mpf

mp.prec = 1400


def bits(x):
    """The bits of the binary64 nearest to x."""
    if x == 0:
        return 0
    sign, x = (1 << 63, -x) if x < 0 else (0, x)
    e = int(mp.floor(mp.log(x, 2)))
    m = int(mp.nint(x * mpf(2) ** (52 - e)))
    if m == 1 << 53:
        m, e = m >> 1, e + 1
    return sign | (e + 1023) << 52 | (m - (1 << 52))


def value(u):
    m, e = u & ((1 << 52) - 1) | 1 << 52, (u >> 52) & 0x7FF
    return (-1 if u >> 63 else 1) * mpf(m) * mpf(2) ** (e - 1075)


def head(x, n):
    """x truncated to n significant bits."""
    e = int(mp.floor(mp.log(abs(x), 2)))
    return mp.floor(x * mpf(2) ** (n - 1 - e)) * mpf(2) ** (e + 1 - n)


def remez(f, lo, hi, n):
    """The n coefficients of the polynomial p for which the largest |f - p| on [lo, hi] is smallest, and that error."""
    lo, hi = mpf(lo), mpf(hi)
    points = [(lo + hi) / 2 - (hi - lo) / 2 * mp.cos(mp.pi * (2 * i + 1) / (2 * n + 2)) for i in range(n + 1)]
    grid = [(lo + hi) / 2 - (hi - lo) / 2 * mp.cos(mp.pi * i / (40 * n)) for i in range(40 * n + 1)]
    points, grid = [[x if abs(x) > mpf(2) ** -60 else mpf(2) ** -60 for x in xs] for xs in (points, grid)]    # f is not defined at 0
    values = [f(x) for x in grid]
    for _ in range(8):
        a = mp.matrix(n + 1, n + 1)
        b = mp.matrix(n + 1, 1)
        for i, x in enumerate(points):
            for j in range(n):
                a[i, j] = x ** j
            a[i, n] = (-1) ** i
            b[i] = f(x)
        c = mp.lu_solve(a, b)
        error = [y - mp.polyval(list(c)[n - 1::-1], x) for x, y in zip(grid, values)]
        runs, best = [], None                        # the largest error of each run of errors of one sign
        for x, e in zip(grid, error):
            if best is not None and (e > 0) == (best[1] > 0):
                best = max(best, (x, e), key=lambda p: abs(p[1]))
                runs[-1] = best
            else:
                best = (x, e)
                runs.append(best)
        if len(runs) < n + 1:
            break
        while len(runs) > n + 1:
            runs.pop(0 if abs(runs[0][1]) < abs(runs[-1][1]) else -1)
        points = [x for x, _ in runs]
    return list(c)[:n], max(abs(e) for e in error)


def polynomial(f, lo, hi, n):
    """The bits of the coefficients, and the largest error before they are rounded."""
    c, error = remez(f, lo, hi, n)
    return [bits(a) for a in c], error


def tables():
    ln2, pi2 = mp.log(2), mp.pi / 2
    quarter, middle = mp.pi / 4 + mpf(2) ** -20, (mp.sqrt(2) - 1) / (mp.sqrt(2) + 1)
    t = {}
    report = {}

    def poly(name, f, lo, hi, n):
        t[name], error = polynomial(f, lo, hi, n)
        report[name] = float(mp.log(error, 2))

    root = mp.sqrt
    poly("sm_exp_table", lambda r: (mp.exp(r) - 1 - r) / r ** 2, -ln2 / 2 - mpf(2) ** -20, ln2 / 2 + mpf(2) ** -20, 12)
    poly("sm_log_table", lambda z: (2 * mp.atanh(root(z)) / root(z) - 2 - z * 2 / 3) / z ** 2,
         0, middle ** 2 * (1 + mpf(2) ** -20), 8)
    poly("sm_sin_table", lambda z: (mp.sin(root(z)) / root(z) - 1) / z, 0, quarter ** 2, 8)
    poly("sm_tan_table", lambda z: ((mp.sin(root(z)) / root(z) - 1) / z + mpf(1) / 6) / z, 0, quarter ** 2, 6)
    poly("sm_cos_table", lambda z: (mp.cos(root(z)) - 1 + z / 2) / z ** 2, 0, quarter ** 2, 6)
    poly("sm_atan_table", lambda z: (mp.atan(root(z)) / root(z) - 1) / z, 0, mpf("0.164") ** 2, 8)
    t["sm_arc_table"] = []
    for c in (0, mpf(1) / 4, mpf(1) / 2, 1):
        high = value(bits(mp.atan(c))) if c else mpf(0)
        t["sm_arc_table"] += [bits(high), bits(mp.atan(c) - high)]
    turns = 2 / mp.pi
    t["sm_turn_table"] = [int(mp.floor(turns * mpf(2) ** (32 * i))) & 0xFFFFFFFF if i > 0 else 0 for i in range(-1, 38)]

    def pair(name, x, n):
        high = head(x, n)
        t[name] = [bits(high), bits(x - high)]

    pair("ln2", ln2, 42)
    pair("log10(2)", mp.log(2, 10), 42)
    pair("1/ln10", 1 / mp.log(10), 26)
    pair("pi/2", pi2, 26)
    pair("2/3", mpf(2) / 3, 53)
    sixth = value(bits(-mpf(1) / 6))
    t["-1/6"] = [bits(sixth), bits(-mpf(1) / 6 - sixth)]
    t["1/ln2"] = [bits(1 / ln2)]
    t["1/ln10 rounded"] = [bits(1 / mp.log(10))]
    t["pi/2 rounded"] = [bits(pi2), bits(pi2 - value(bits(pi2)))]
    t["pi rounded"] = [bits(mp.pi), bits(mp.pi - value(bits(mp.pi)))]
    return t, report


def text(u, wide):
    return "0x%016X" % u if wide else "0x%08X" % u


def check(t, path):
    found = set(re.findall(r"0x[0-9A-F]+", open(path).read()))
    missing = [n for n, row in t.items() for u in row if text(u, n != "sm_turn_table") not in found and u != 0]
    for n in missing:
        print("%s: a constant of %s is missing" % (path, n))
    return not missing


def main():
    t, report = tables()
    if "--check" in sys.argv:
        ok = all([check(t, p) for p in ("stdlib/elementary.h", "docs/elementary.md")])
        print("%d constants" % sum(len(row) for row in t.values()))
        sys.exit(not ok)
    for name, row in t.items():
        wide = name != "sm_turn_table"
        print("// %s%s" % (name, ": error 2^%.1f" % report[name] if name in report else ""))
        step = 4 if wide else 8
        for i in range(0, len(row), step):
            print("    " + " ".join(text(u, wide) + ("u," if wide else "u,") for u in row[i:i + step]))


if __name__ == "__main__":
    main()
