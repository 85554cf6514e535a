#!/usr/bin/env python3
"""CSG beside POV-Ray: scenes of solids written in both languages, rendered on one thread, in one run.

    script/csg_against_povray.py [-width 256] [-rounds 3] [name.scn ...]

Needs povray 3.7. RAYPRO and RAYIMG name the programs (default build/raypro, build/rayimg); BEFORE names a raypro of
another revision, for one more column.

`nested` and `row` are 200 solids in one another, `side by side` a union of 200, `plates` eight plates with 25 holes
each. All have a point light, shadows and one ray per pixel, so that images should be alike. A scene that is named,
with a .pov beside it, is rendered as it is. For each: CPU seconds, the least of some rounds, without start and load;
the ratio, above 1 in our favor; and the share of pixels that differ by more than 8 levels of 255.
"""

import argparse
import math
import os
import random
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import beside

root = Path(__file__).resolve().parent.parent
raypro = os.environ.get("RAYPRO", str(root / "build/raypro"))
rayimg = os.environ.get("RAYIMG", str(root / "build/rayimg"))
before = os.environ.get("BEFORE")
draw = random.Random(5)


class Solid:
    """A solid in both languages."""

    def __init__(self, ours, theirs):
        self.ours, self.theirs = ours, theirs


def ball(x, y, z, r):
    return Solid(["sphere 0  %r %r %r  %r" % (x, y, z, r)], "sphere { <%r, %r, %r>, %r }" % (x, y, z, r))


def box(low, high):
    return Solid(["box 0  %r %r %r  %r %r %r" % (*low, *high)], "box { <%r, %r, %r>, <%r, %r, %r> }" % (*low, *high))


def upright(x, y, z, r, h):
    return Solid(["cylinder 0  %r %r %r  %r %r" % (x, y, z, r, h)],
                 "cylinder { <%r, %r, %r>, <%r, %r, %r>, %r }" % (x, y - h / 2, z, x, y + h / 2, z, r))


def combined(operation, solids):
    return Solid(["csg %s 0" % operation] + [line for s in solids for line in s.ours] + ["end"],
                 "%s { %s }" % (operation, " ".join(s.theirs for s in solids)))


def somewhere(reach=3.0):
    return [draw.uniform(-reach, reach) for _ in range(3)]


def nested():
    solid = ball(*somewhere(), 0.9)
    for _ in range(199):
        solid = combined(draw.choice(["union", "difference"]), [solid, ball(*somewhere(), draw.uniform(0.4, 1))])
    return solid


def row():
    solid = ball(3, 0, 0, 0.3)
    for i in range(199):
        solid = combined("difference", [ball(3 - 0.03 * (i + 1), math.sin(i / 9), 0, 0.3), solid])
    return solid


def side_by_side():
    return combined("union", [ball(*somewhere(), draw.uniform(0.1, 0.4)) for _ in range(200)])


def plates():
    def plate(y):
        holes = [upright(x, y, z, 0.4, 1) for x in (-2, -1, 0, 1, 2) for z in (-2, -1, 0, 1, 2)]
        return combined("difference", [box([-2.6, y - 0.1, -2.6], [2.6, y + 0.1, 2.6])] + holes)

    return combined("union", [plate(-2.4 + 0.7 * i) for i in range(8)])


def save(folder, name, solid):
    half = 0.35
    (folder / (name + ".scn")).write_text("\n".join(
        ["camera 0 3 14  0 -.2 -1  0 1 0  %r .01 100" % half, "background .2 .3 .4", "ambient .3 .3 .3",
         "point_light .7 .7 .7  5 9 7  1 0 0", "material .3 .3 .3  .7 .6 .5  0 0 0  0 0 0  0 0 0  1 1 0",
         *solid.ours, ""]))
    side = 2 * math.tan(half)
    length = math.hypot(1, 0.2)
    (folder / (name + ".pov")).write_text(
        "#version 3.7; global_settings { assumed_gamma 1 ambient_light 1 }\n"
        "camera { location <0, 3, 14> direction <0, %r, %r> right <%r, 0, 0> up <0, %r, %r> }\n"
        "background { rgb <.2, .3, .4> } light_source { <5, 9, 7> rgb .7 }\n"
        "object { %s texture { pigment { rgb <.7, .6, .5> } finish { ambient 0 emission .09 / .7 diffuse 1 } } }\n" % (
            -0.2 / length, -1 / length, side, side / length, -0.2 * side / length, solid.theirs))
    return folder / name


def cpu_seconds(command, folder):
    start = beside.children_seconds()
    subprocess.run(command, cwd=folder, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return beside.children_seconds() - start


def least(rounds, run, width):
    start = min(run(1) for _ in range(rounds))
    return min(run(width) for _ in range(rounds)) - start


def ours(program, scene, rounds, width, output):
    return least(rounds, lambda w: cpu_seconds(
        [program, str(scene) + ".scn", str(output), "-width", str(w), "-height", str(w), "-threads", "1", "-quiet",
         "-restart", "-allow_path", "/"], output.parent), width)


def theirs(scene, rounds, width, output):
    return least(rounds, lambda w: cpu_seconds(
        ["povray", "+I" + str(scene) + ".pov", "+O" + str(output), "+W%d" % w, "+H%d" % w, "File_Gamma=1", "-A", "-D",
         "-P", "+WT1"], output.parent), width)


def share_that_differs(a, b):
    def values(path):
        to = path.with_suffix(".ppm")
        subprocess.run([rayimg, "convert", str(path), str(to)], check=True, stdout=subprocess.DEVNULL)
        return to.read_bytes().split(b"\n", 3)[-1]

    first, second = values(a), values(b)
    pixels = range(0, min(len(first), len(second)), 3)
    return sum(any(abs(first[i + c] - second[i + c]) > 8 for c in range(3)) for i in pixels) / len(pixels)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-width", type=int, default=256)
    parser.add_argument("-rounds", type=int, default=3)
    parser.add_argument("scenes", nargs="*", type=Path)
    asked = parser.parse_args()
    if not shutil.which("povray"):
        sys.exit("csg_against_povray.py: povray is not installed")
    print("%dx%d, CPU seconds of one thread; %s; %s" % (asked.width, asked.width, beside.processor(),
                                                       time.strftime("%Y-%m-%d")))
    print("%-14s%9s%9s%9s%8s%16s" % ("scene", "before" if before else "", "ours", "theirs", "ratio", "pixels differ"))
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        made = [(label, save(folder, label.replace(" ", "_"), solid)) for label, solid in
                (("nested", nested()), ("row", row()), ("side by side", side_by_side()), ("plates", plates()))]
        for label, scene in made + [(s.stem, s.resolve().with_suffix("")) for s in asked.scenes]:
            image, their_image = folder / "ours.png", folder / "theirs.png"
            old = "%.3f" % ours(before, scene, asked.rounds, asked.width, image) if before else ""
            us = ours(raypro, scene, asked.rounds, asked.width, image)
            them = theirs(scene, asked.rounds, asked.width, their_image)
            differ = 100 * share_that_differs(image, their_image)
            print("%-14s%9s%9.3f%9.3f%8.2f%15.2f%%" % (label, old, us, them, them / us, differ), flush=True)


main()
