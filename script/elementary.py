#!/usr/bin/env python3
"""Derives the numbers of R1/Coefficients.h and prints that file: script/elementary.py > R1/Coefficients.h

Polynomials interpolate at Chebyshev nodes, which comes within a small factor of the best; the error of each, weighted as
its function uses it, is printed next to it. Tables are rounded from 600 digits. Needs mpmath; nothing else of the
project needs this script: a test compares where mpmath is installed.
"""
import mpmath
from mpmath import mp, mpf

mp.dps = 600
LOG_STEPS = 128  # intervals a factor of two: the polynomials stay short and the tables within the nearest cache
EXP_STEPS = 128


def rounded(x):
    """The nearest double: what is left of a rounding to 53 bits."""
    with mp.workprec(53):
        return mpf(x) + 0


def head(x, unit):
    """x rounded to a multiple of 2^unit."""
    return mp.ldexp(mp.nint(mp.ldexp(x, -unit)), unit)


def hexadecimal(x):
    return float(x).hex()


def interpolate(f, low, high, count):
    """Coefficients, lowest power first, of the polynomial through f at `count` Chebyshev nodes. Where low is 0 there is
    one node more, moved to 0: there the weight, a power of x, makes the error zero by itself."""
    with mp.workdps(60):
        total = count + (low == 0)
        nodes = [mp.cos((2 * i + 1) * mp.pi / (2 * total)) for i in range(total)]
        if low == 0:
            nodes = [high * (x - nodes[-1]) / (1 - nodes[-1]) for x in nodes[:-1]]
        else:
            nodes = [(low + high) / 2 + (high - low) / 2 * x for x in nodes]
        powers = mp.matrix(count, count)
        for i, x in enumerate(nodes):
            for j in range(count):
                powers[i, j] = x**j
        return list(mp.lu_solve(powers, mp.matrix([f(x) for x in nodes])))


def polynomial(name, about, f, weight, low, high, count):
    coefficients = [rounded(c) for c in interpolate(f, low, high, count)]
    with mp.workdps(60):
        error = 0
        for i in range(1, 400):
            x = low + (high - low) * i / 400
            error = max(error, abs(weight(x) * (mp.polyval(coefficients[::-1], x) - f(x))))
        print(f"// {about}; error under 2^{float(mp.log(error, 2)):.1f}")
    print(f"inline constexpr double {name}[] = {{" + ", ".join(hexadecimal(c) for c in coefficients) + "};\n")


def log_entry(i):
    """1/c with 12 bits for the middle c of interval i, so that products with it are exact; and -log(1/c) in two parts."""
    one = round(first_below_one * 2)  # intervals below and above 1 differ in width
    position = (2 * i + 1 - one) / mpf(2)
    middle = 1 + position / LOG_STEPS if position > 0 else 1 + position / (2 * LOG_STEPS)
    inverse = mpf(1) if i == one // 2 else head(1 / middle, -11)
    logarithm = -mp.log(inverse)
    high = head(logarithm, -42)
    return inverse, high, logarithm - high


def largest_ratio():
    """The largest |x/c - 1|."""
    worst = 0
    for i in range(LOG_STEPS):
        for edge in (i, i + 1):
            position = edge - first_below_one
            x = 1 + position / LOG_STEPS if position > 0 else 1 + position / (2 * LOG_STEPS)
            worst = max(worst, abs(x * log_entry(i)[0] - 1))
    return worst


def rows(type_name, name, entries, a_line):
    print(f"inline constexpr {type_name} {name}[] = {{")
    for i in range(0, len(entries), a_line):
        print("    " + " ".join(entry + "," for entry in entries[i:i + a_line]))
    print("};\n")


def of_two(x):
    return f"{{{hexadecimal(rounded(x))}, {hexadecimal(rounded(x - rounded(x)))}}}"



# The middle of an interval is 1: x in [low, 2 low) with low = 1 - 75.5/256.
first_below_one = mpf("75.5")

print("""#pragma once

#include <cstdint>

// clang-format off

/// The coefficients of R1/Elementary.h. Derived and printed by script/elementary.py; do not edit.
namespace R1::coefficients {

struct TwoParts { double high, low; };
struct LogEntry { double inverse, high, low; };  // 1/c in 12 bits, and -log(1/c)
""")

quarter = (mp.pi / 4)**2
polynomial("sine", "(sin r - r) / r^3 in z = r^2, |r| <= pi/4",
           lambda z: sum((-1)**k * z**(k - 1) / mp.factorial(2 * k + 1) for k in range(1, 25)), lambda z: z, 0, quarter, 6)
polynomial("cosine", "(cos r - 1 + z/2) / z^2 in z = r^2, |r| <= pi/4",
           lambda z: sum((-1)**k * z**(k - 2) / mp.factorial(2 * k) for k in range(2, 25)), lambda z: z * z, 0, quarter, 6)
polynomial("arctangent", "(atan r - r) / r^3 in z = r^2, |r| <= 1/31",
           lambda z: sum((-1)**k * z**(k - 1) / (2 * k + 1) for k in range(1, 30)), lambda z: z, 0, mpf(1) / 31**2, 5)
reach = mp.log(2) / (2 * EXP_STEPS) * mpf("1.001")
polynomial("exponential", "(exp r - 1 - r) / r^2, |r| <= log(2)/256",
           lambda r: sum(r**(k - 2) / mp.factorial(k) for k in range(2, 30)), lambda r: r * r, -reach, reach, 4)
reach = largest_ratio()
polynomial("logarithm", f"(log(1 + r) - r + r^2/2) / r^3, |r| <= {float(reach):.5f}",
           lambda r: sum((-1)**(k + 1) * r**(k - 3) / k for k in range(3, 60)), lambda r: r * r, -reach, reach, 7)

print("// pi/2 in three parts, the first two of 33 bits: times a whole number under 2^20 they are exact")
first = head(mp.pi / 2, -32)
second = head(mp.pi / 2 - first, -66)
print(f"inline constexpr double half_pi_parts[] = {{{hexadecimal(first)}, {hexadecimal(second)}, "
      f"{hexadecimal(rounded(mp.pi / 2 - first - second))}}};")
print(f"inline constexpr double two_over_pi_rounded = {hexadecimal(rounded(2 / mp.pi))};")
print("// In two parts: pi/2, pi, 2 pi (the first of 26 bits), log 2 (the first a multiple of 2^-42), 1/log 10, 1/3")
print(f"inline constexpr TwoParts half_pi = {of_two(mp.pi / 2)};")
print(f"inline constexpr TwoParts pi = {of_two(mp.pi)};")
for name, value, unit in (("two_pi", 2 * mp.pi, -23), ("log_2", mp.log(2), -42)):
    high = head(value, unit)
    print(f"inline constexpr TwoParts {name} = {{{hexadecimal(high)}, {hexadecimal(rounded(value - high))}}};")
print(f"inline constexpr TwoParts log10_e = {of_two(1 / mp.log(10))};")
print(f"inline constexpr TwoParts third = {of_two(mpf(1) / 3)};")
print(f"// log(2)/{EXP_STEPS} in two parts, the first of 35 bits: times a whole number under 2^18 it is exact")
high = head(mp.log(2) / EXP_STEPS, -43)
print(f"inline constexpr TwoParts exp_step = {{{hexadecimal(high)}, {hexadecimal(rounded(mp.log(2) / EXP_STEPS - high))}}};")
print(f"inline constexpr double exp_steps_per_unit = {hexadecimal(rounded(EXP_STEPS / mp.log(2)))};\n")

print("// The bits of 2/pi after the point, 64 per word")
bits = int(mp.floor(mp.ldexp(2 / mp.pi, 64 * 20)))
rows("std::uint64_t", "two_over_pi", [f"0x{(bits >> (64 * (19 - i))) & (2**64 - 1):016x}" for i in range(20)], 5)
print("// Angles of (16, i), (i, 16), (-16, i) and (-i, 16) from the x axis")
steps = [mp.atan(mpf(i) / 16) for i in range(17)]
turned = [steps, [mp.pi / 2 - a for a in steps], [mp.pi - a for a in steps], [mp.pi / 2 + a for a in steps]]
for name, angles in zip(("flat", "steep", "flat_left", "steep_left"), turned):
    rows("TwoParts", name, [of_two(a) for a in angles], 2)
print("inline constexpr const TwoParts* arctangents[] = {flat, steep, flat_left, steep_left};\n")
print(f"inline constexpr int log_steps = {LOG_STEPS}, exp_steps = {EXP_STEPS};")
print("// The bits of the smallest x whose logarithm needs no power of two")
print(f"inline constexpr std::uint64_t log_first = 0x{0x3ff0000000000000 - int(first_below_one * 2**45):016x};\n")
entries = [log_entry(i) for i in range(LOG_STEPS)]
rows("LogEntry", "logarithms", ["{" + ", ".join(hexadecimal(rounded(x)) for x in e) + "}" for e in entries], 2)
print(f"// 2^(i/{EXP_STEPS}), and its rounding error relative to it")
powers = [mpf(2)**(mpf(i) / EXP_STEPS) for i in range(EXP_STEPS)]
rows("TwoParts", "powers", [f"{{{hexadecimal(rounded(p))}, {hexadecimal(rounded(p / rounded(p) - 1))}}}" for p in powers], 2)
print("}  // namespace R1::coefficients")
