#!/usr/bin/env python3
"""Direct light beside POV-Ray: the same three scenes written in both languages, rendered on one thread.

    script/against_povray.py [-width 512] [-samples 1]

Needs povray 3.7. RAYPRO and RAYIMG name the programs (default build/raypro, build/rayimg).

One ray through the middle of each pixel (-samples 4, 9 ...: of each of so many equal parts), lamps without size, mirrors:
nothing is left to chance, so that the images should be alike. For each scene: camera rays per CPU second, without start
and load; the ratio, above 1 in our favor; by how much the means differ, and what share of the pixels differs by more
than a level of 255 (along edges, which each program's rounding sees elsewhere).
"""

import argparse
import math
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import beside

root = Path(__file__).resolve().parent.parent
raypro = os.environ.get("RAYPRO", str(root / "build/raypro"))
rayimg = os.environ.get("RAYIMG", str(root / "build/rayimg"))
max_depth = 5  # mirrors


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(v):
    length = math.sqrt(sum(x * x for x in v))
    return [x / length for x in v]


def words(v):
    return " ".join(repr(x) for x in v)


def vector(v):
    return "<%s>" % ", ".join(repr(x) for x in v)


class Scene:
    """One scene in both languages, built a thing at a time."""

    def __init__(self, folder, name, eye, target, half_angle):
        self.folder, self.name = folder, name
        towards = unit([t - e for e, t in zip(eye, target)])
        right = unit(cross(towards, [0, 1, 0]))
        up = cross(right, towards)
        side = 2 * math.tan(half_angle)
        self.ours = ["camera %s %s 0 1 0 %r 0.01 100" % (words(eye), words(towards), half_angle)]
        self.theirs = [
            "#version 3.7; global_settings { assumed_gamma 1 max_trace_level %d ambient_light 0 }" % (max_depth + 1),
            "camera { location %s direction %s right %s up %s }" % (
                vector(eye), vector(towards), vector([side * x for x in right]), vector([side * x for x in up]))]
        self.materials = 0

    def _material(self, color, mirror):
        self.ours.append("material 0 0 0  %s  0 0 0  0 0 0  0 0 0  1 1 0" % words(color))
        if mirror:
            self.ours.append("mirror %d %r %r %r" % (self.materials, mirror, mirror, mirror))
        self.materials += 1
        return self.materials - 1

    @staticmethod
    def _texture(color, mirror):
        return "texture { pigment { color rgb %s } finish { ambient 0 diffuse 1 specular 0 reflection %r } }" % (
            vector(color), mirror)

    def lamp(self, place, color):
        self.ours.append("point_light %s %s 1 0 0" % (words(color), words(place)))
        self.theirs.append("light_source { %s color rgb %s }" % (vector(place), vector(color)))

    def sphere(self, center, radius, color, mirror=0):
        self.ours.append("sphere %d %s %r" % (self._material(color, mirror), words(center), radius))
        self.theirs.append("sphere { %s, %r %s }" % (vector(center), radius, self._texture(color, mirror)))

    def box(self, low, high, color):
        self.ours.append("box %d %s %s" % (self._material(color, 0), words(low), words(high)))
        self.theirs.append("box { %s, %s %s }" % (vector(low), vector(high), self._texture(color, 0)))

    def mesh(self, corners, faces, color):
        path = self.folder / ("%s%d.obj" % (self.name, len(self.ours)))
        with open(path, "w") as out:
            out.writelines("v %s\n" % words(c) for c in corners)
            out.writelines("f %d %d %d\n" % tuple(i + 1 for i in f) for f in faces)
        self.ours.append("mesh %d %s" % (self._material(color, 0), path.name))
        self.theirs.append("mesh2 { vertex_vectors { %d, %s } face_indices { %d, %s } %s }" % (
            len(corners), ", ".join(map(vector, corners)), len(faces), ", ".join(map(vector, faces)),
            self._texture(color, 0)))

    def save(self):
        (self.folder / (self.name + ".scn")).write_text("\n".join(self.ours) + "\n")
        (self.folder / (self.name + ".pov")).write_text("\n".join(self.theirs) + "\n")
        return self


def scan(folder):
    """A mesh of 69,000 triangles on a floor."""
    s = Scene(folder, "scan", [0.6, 1.9, 5.3], [0, 0.9, 0], 0.3)
    s.lamp([4, 6, 3], [0.7, 0.7, 0.6])
    s.lamp([-5, 3, 4], [0.2, 0.2, 0.3])
    s.mesh(*beside.bumpy_ball(), (0.6, 0.5, 0.4))
    s.box([-20, -1, -20], [20, -0.1, 20], (0.4, 0.4, 0.4))
    return s.save()


def room(folder):
    """A closed room with two boxes and two lamps."""
    s = Scene(folder, "room", [0, 1, 3.9], [0, 1, 0], 0.26)
    white = (0.75, 0.75, 0.75)
    s.lamp([0.3, 1.7, 0.5], [0.5, 0.5, 0.45])
    s.lamp([-0.6, 1.2, 1.5], [0.2, 0.2, 0.25])
    s.box([-1, -0.1, -1], [1, 0, 4], white)
    s.box([-1, 2, -1], [1, 2.1, 4], white)
    s.box([-1, 0, -1.1], [1, 2, -1], white)
    s.box([-1.1, 0, -1], [-1, 2, 4], (0.6, 0.1, 0.1))
    s.box([1, 0, -1], [1.1, 2, 4], (0.1, 0.6, 0.1))
    s.box([-0.6, 0, -0.6], [-0.05, 1.2, -0.1], white)
    s.box([0.1, 0, 0], [0.6, 0.6, 0.5], white)
    return s.save()


def spheres(folder):
    """400 balls on a floor, of which a third are mirrors, and three lamps."""
    s = Scene(folder, "spheres", [0, 6, 14], [0, 0.6, 0], 0.35)
    s.lamp([-8, 9, 6], [0.4, 0.4, 0.4])
    s.lamp([8, 7, 4], [0.3, 0.25, 0.2])
    s.lamp([0, 12, -6], [0.2, 0.25, 0.3])
    s.box([-40, -1, -40], [40, 0, 40], (0.5, 0.5, 0.5))
    for i in range(400):
        x, z = (i % 20 - 9.5) * 0.6, (i // 20 - 9.5) * 0.6
        color = tuple(0.15 + 0.4 * ((i * k) % 7) / 6 for k in (1, 2, 3))
        s.sphere([x, 0.2 + 0.1 * (i % 3), z], 0.18 + 0.02 * (i % 4), color, 0.4 if i % 3 == 0 else 0)
    return s.save()


def timed(command, folder):
    before = beside.children_seconds()
    subprocess.run(command, cwd=folder, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return beside.children_seconds() - before


def pixels(path):
    data = path.read_bytes()
    kind, size, _, rest = data.split(b"\n", 3)
    width, height = map(int, size.split())
    assert kind == b"PF"
    return struct.unpack("<%df" % (3 * width * height), rest)


def ours(scene, width, samples):
    def run(width):
        return timed([raypro, scene.name + ".scn", "ours.pfm", "-width", str(width), "-height", str(width), "-samples",
                      str(samples), "-sampler", "grid", "-max_depth", str(max_depth), "-min_luminance", "0", "-threads",
                      "1", "-quiet", "-restart"], scene.folder)

    start = min(run(1) for _ in range(3))
    return run(width) - start, pixels(scene.folder / "ours.pfm")


def theirs(scene, width, samples):
    grid = round(math.sqrt(samples))

    def run(width):
        return timed(["povray", "+I" + scene.name + ".pov", "+Otheirs.png", "+W%d" % (width * grid),
                      "+H%d" % (width * grid), "+FN16", "File_Gamma=1", "-A", "-D", "-P", "+WT1"], scene.folder)

    start = min(run(1) for _ in range(3))
    seconds = run(width) - start
    subprocess.run([rayimg, "convert", "theirs.png", "theirs.pfm"], cwd=scene.folder, check=True)
    return seconds, averaged(pixels(scene.folder / "theirs.pfm"), width, grid)


def averaged(values, width, grid):
    """Means of grid x grid neighbors."""
    if grid == 1:
        return values
    wide = width * grid
    sums = [0.0] * (3 * width * width)
    for y in range(wide):
        for x in range(wide):
            for c in range(3):
                sums[3 * (y // grid * width + x // grid) + c] += values[3 * (y * wide + x) + c]
    return [s / grid**2 for s in sums]


def version():
    text = subprocess.run(["povray", "--version"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True).stdout
    return next(line.strip() for line in text.splitlines() if line.strip().startswith("POV-Ray"))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-width", type=int, default=512)
    parser.add_argument("-samples", type=int, default=1, help="1, 4, 9 ...")
    asked = parser.parse_args()
    if round(math.sqrt(asked.samples)) ** 2 != asked.samples:
        sys.exit("against_povray.py: -samples must be a square number, got %d" % asked.samples)
    if not shutil.which("povray"):
        sys.exit("against_povray.py: povray is not installed")
    print("raypro beside %s, %dx%d, %d camera rays per pixel, one thread; %s; %s" % (
        version(), asked.width, asked.width, asked.samples, beside.processor(), time.strftime("%Y-%m-%d")))
    print("%-9s%11s%12s%8s%14s%14s" % ("scene", "ours M/s", "theirs M/s", "ratio", "means differ", "pixels differ"))
    million = asked.width**2 * asked.samples * 1e-6
    with tempfile.TemporaryDirectory() as name:
        for scene in (make(Path(name)) for make in (scan, room, spheres)):
            our_seconds, our_image = ours(scene, asked.width, asked.samples)
            their_seconds, their_image = theirs(scene, asked.width, asked.samples)
            level = 1 / 255
            differ = sum(
                any(abs(our_image[i + c] - their_image[i + c]) > level for c in range(3))
                for i in range(0, len(our_image), 3))
            print("%-9s%11.3f%12.3f%8.2f%13.3f%%%13.3f%%" % (
                scene.name, million / our_seconds, million / their_seconds, their_seconds / our_seconds,
                100 * (sum(our_image) / sum(their_image) - 1), 300 * differ / len(our_image)), flush=True)


main()
