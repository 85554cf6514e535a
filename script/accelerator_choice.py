#!/usr/bin/env python3
"""What `-accel auto` costs beside the best accelerator, on odd scenes of 33 kinds.

    script/accelerator_choice.py [-width 128] [-rounds 3] [name ...]

For each scene: CPU seconds to build and render on one thread, the least of some rounds, with `auto` and with each of
the other accelerators, without start and load; what auto chose; and the ratio of auto's time to that of the fastest.
Exits with 1 if that is above 1.5 in one of them, by more than ten milliseconds. RAYPRO names the program (default
build/raypro).
"""

import argparse
import json
import math
import os
import random
import subprocess
import sys
import tempfile
from pathlib import Path

raypro = os.environ.get("RAYPRO", str(Path(__file__).resolve().parent.parent / "build/raypro"))
others = ("none", "bvh", "grid", "octree")
most_ratio, leeway = 1.5, 0.01
draw = random.Random(1)
head = "camera 0 .5 4  0 0 -1  0 1 0  .3 .01 100\n"
lit = "point_light .8 .8 .8  5 6 7  1 0 0\nmaterial .3 .3 .3  .7 .6 .5  0 0 0  0 0 0  0 0 0  1 1 0\n"


def side():
    return draw.uniform(-1, 1)


def anywhere(scale=1.2):
    return (scale * side(), 0.5 + scale * side(), scale * side())


def plus(p, *d):
    return tuple(a + b for a, b in zip(p, d))


class Scenes:
    def __init__(self, folder):
        self.folder, self.names = folder, []

    def text(self, name, lines):
        self.names.append(name)
        (self.folder / (name + ".scn")).write_text(head + lit + "\n".join(lines) + "\n")

    def mesh(self, name, corners, faces):
        with open(self.folder / (name + ".obj"), "w") as out:
            out.writelines("v %r %r %r\n" % tuple(c) for c in corners)
            out.writelines("f %d %d %d\n" % tuple(i + 1 for i in f) for f in faces)
        self.text(name, ["mesh 0 %s.obj" % name])

    def triangles(self, name, triangles):
        faces = [(3 * i, 3 * i + 1, 3 * i + 2) for i in range(len(triangles))]
        self.mesh(name, [p for t in triangles for p in t], faces)

    def fan(self, name, count, tilt=0.0):
        """Slivers around a vertex."""
        turns = [2 * math.pi * i / count for i in range(count)]
        rim = [(1.5 * math.cos(a), 0.5 + 1.5 * math.sin(a) * math.cos(tilt), 1.5 * math.sin(a) * math.sin(tilt))
               for a in turns]
        self.mesh(name, [(0, 0.5, 0)] + rim, [(0, i + 1, (i + 1) % count + 1) for i in range(count)])

    def hair(self, name, count, width, length, upright=False):
        def hair():
            p = anywhere()
            along = (0, length, 0) if upright else (length * side(), length * side(), length * side())
            return p, plus(p, *along), plus(p, width, width * side(), 0)

        self.triangles(name, [hair() for _ in range(count)])

    def soup(self, name, count, size):
        def triangle():
            p = anywhere()
            return [plus(p, size * side(), size * side(), size * side()) for _ in range(3)]

        self.triangles(name, [triangle() for _ in range(count)])

    def ball(self, name, rings):
        at = lambda ring, place: 2 * rings * ring + place % (2 * rings)
        corners = [(math.sin(a) * math.cos(b), 0.5 + math.cos(a), math.sin(a) * math.sin(b))
                   for a in (math.pi * r / rings for r in range(rings + 1))
                   for b in (math.pi * s / rings for s in range(2 * rings))]
        faces = [f for r in range(rings) for s in range(2 * rings)
                 for f in ((at(r, s), at(r, s + 1), at(r + 1, s)), (at(r, s + 1), at(r + 1, s + 1), at(r + 1, s)))]
        self.mesh(name, corners, faces)

    def in_a_stadium(self, name, count, spread, size, width):
        """A small thing of many triangles on a large floor."""
        triangles = [((-50, -1, -50), (50, -1, -50), (0, -1, 50))]
        for _ in range(count):
            p = anywhere(spread)
            tip = plus(p, size * side(), size * side(), size * side())
            triangles.append((p, tip, plus(p, width, 0, width * side())))
        self.triangles(name, triangles)


def make(folder):
    s = Scenes(folder)
    s.fan("fan_500", 500)
    s.fan("fan_20k", 20000)
    s.fan("fan_100k", 100000)
    s.fan("fan_tilted", 20000, 0.7)
    s.hair("hair_200", 200, 0.01, 1)
    s.hair("hair_2k", 2000, 0.002, 0.6)
    s.hair("hair_20k", 20000, 0.002, 0.6)
    s.hair("hair_100k", 100000, 0.001, 0.5)
    s.hair("hair_long", 5000, 0.002, 3)
    s.hair("hair_upright", 20000, 0.002, 0.6, True)
    s.hair("bristles", 20000, 0.01, 0.03)
    s.soup("soup_100", 100, 0.2)
    s.soup("soup_20k", 20000, 0.05)
    s.soup("large_500", 500, 0.8)
    s.soup("large_20k", 20000, 0.5)

    def ray_of_star():
        a, z = draw.uniform(0, 2 * math.pi), side()
        r = math.sqrt(1 - z * z)
        tip = (1.2 * r * math.cos(a), 0.5 + 1.2 * z, 1.2 * r * math.sin(a))
        return (0, 0.5, 0), tip, plus(tip, 0.003, 0.003, 0)

    s.triangles("star", [ray_of_star() for _ in range(20000)])
    s.triangles("planks", [((x, -0.5, -1), (x + 0.7, 1.5, 1), (x + 0.0005, -0.5, -1))
                           for x in (-1.2 + 2.4 * i / 3000 for i in range(3000))])
    around = [2 * math.pi * i / 2000 for i in range(2000)]
    s.mesh("tube", [c for a in around for c in ((0.8 * math.cos(a), -0.7, 0.8 * math.sin(a)),
                                                (0.8 * math.cos(a) + 0.5, 1.7, 0.8 * math.sin(a) + 0.3))],
           [f for i in range(2000) for f in ((2 * i, 2 * i + 1, (2 * i + 2) % 4000),
                                             (2 * i + 1, (2 * i + 3) % 4000, (2 * i + 2) % 4000))])
    s.ball("ball_30", 30)
    s.ball("ball_150", 150)
    s.in_a_stadium("stadium", 30000, 0.05, 0.001, 0.001)
    s.in_a_stadium("stadium_fur", 20000, 0.3, 0.1, 0.0003)
    ball = lambda p, r: "sphere 0  %r %r %r  %r" % (*p, r)
    s.text("one", [ball((0, 0.5, 0), 1)])
    s.text("two", [ball((0, 0.5, 0), 0.5), "box 0  -1 -1 -1  1 -.5 1"])
    s.text("three", [ball((0, 0.5, 0), 0.5), ball((1, 0.5, 0), 0.5), "box 0  -1 -1 -1  1 -.5 1"])
    s.text("out_of_view", [ball((0, 0.5, 0), 0.5), ball((50, 0.5, 0), 0.5), ball((-50, 0.5, 0), 0.5)])
    s.text("balls_400", [ball(anywhere(), 0.05) for _ in range(400)])
    s.text("balls_within", [ball(anywhere(0.3), 1) for _ in range(100)])
    s.text("rods", [line for _ in range(400) for line in
                    ("begin 0  rotate %r 1 2 3" % (180 * side()), "cylinder 0  %r %r %r  .01 2" % anywhere(1), "end")])
    union = lambda x: ["csg union 0"] + [ball(plus(anywhere(1), x, 0, 0), 0.3) for _ in range(40)] + ["end"]
    s.text("csg", union(0))
    s.text("csg_out_of_view", [ball((0, 0.5, 0), 1)] + union(50))
    s.text("rings", ["torus 0  0 .5 0  .7 .2", "torus 0  0 -.3 0  .7 .2"])
    s.text("implicit", ['implicit 0  "x^2 + (y - 0.5)^2 + z^2 - 0.8 + 0.1 sin(9 x)"  -1 -.5 -1  1 1.5 1',
                        ball((50, 0, 0), 1)])
    return s.names


def seconds(folder, name, accelerator, width, rounds, limit):
    """Of the process, and the accelerator used; infinite if it takes longer than the limit."""
    least, used = math.inf, "?"
    for _ in range(rounds):
        report = folder / "report.json"
        try:
            subprocess.run([raypro, name + ".scn", "out.png", "-width", str(width), "-height", str(width), "-accel",
                            accelerator, "-threads", "1", "-quiet", "-restart", "-report", str(report)], cwd=folder,
                           check=True, timeout=limit, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        except subprocess.TimeoutExpired:
            break
        read = json.loads(report.read_text())
        least, used = min(least, find(read, "cpu")), find(read, "accelerator", str)
    return least, used


def find(value, key, kind=float):
    """The number or word of that name, wherever it is."""
    if isinstance(value, dict):
        if isinstance(value.get(key), (int, float) if kind is float else kind):
            return value[key]
        value = list(value.values())
    if isinstance(value, list):
        for v in value:
            found = find(v, key, kind)
            if found is not None:
                return found
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-width", type=int, default=128)
    parser.add_argument("-rounds", type=int, default=3)
    parser.add_argument("names", nargs="*")
    asked = parser.parse_args()
    print("%-16s%9s" % ("scene", "auto") + "".join("%9s" % o for o in others) + "%9s  %s" % ("ratio", "auto chose"))
    worst = 0
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for scene in make(folder):
            if asked.names and scene not in asked.names:
                continue
            start = seconds(folder, scene, "none", 1, asked.rounds, 60)[0]
            auto, chosen = seconds(folder, scene, "auto", asked.width, asked.rounds, 600)
            limit = 2 * auto + 1  # of a process; what takes longer is not the fastest
            times = [seconds(folder, scene, o, asked.width, asked.rounds, limit)[0] for o in others]
            auto, times = auto - start, [t - start for t in times]
            best = min(times)
            ratio = auto / best
            worst = max(worst, ratio if auto > best + leeway else 0)
            print("%-16s%9.4f" % (scene, auto) + "".join("%9.4f" % t for t in times) + "%9.2f  %s" % (ratio, chosen),
                  flush=True)
    print("largest ratio, of those more than %g s slower: %.2f" % (leeway, worst))
    sys.exit(worst > most_ratio)


main()
