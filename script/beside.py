"""What the comparisons with other programs share."""

import math
import platform
import resource


def bumpy_ball(sides=256, rings=136):
    def corner(side, ring):
        a, b = math.pi * ring / rings, 2 * math.pi * side / sides
        r = 0.9 + 0.15 * math.sin(3 * b) * math.sin(a) + 0.05 * math.cos(17 * a) * math.sin(a)
        return (r * math.sin(a) * math.cos(b), 0.9 + r * math.cos(a), r * math.sin(a) * math.sin(b))

    corners = [corner(s, r) for r in range(rings + 1) for s in range(sides)]
    at = lambda s, r: r * sides + s % sides
    faces = []
    for r in range(rings):
        for s in range(sides):
            if r > 0:
                faces.append((at(s, r), at(s + 1, r), at(s, r + 1)))
            if r + 1 < rings:
                faces.append((at(s + 1, r), at(s + 1, r + 1), at(s, r + 1)))
    return corners, faces


def children_seconds():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def processor():
    """Its name."""
    try:
        lines = open("/proc/cpuinfo").read().splitlines()
    except OSError:
        lines = []
    return next((line.split(":")[1].strip() for line in lines if line.startswith("model name")), platform.machine())
