#!/usr/bin/env python3
"""Path tracing beside Mitsuba 3: the same five scenes written in both languages, rendered on one thread.

    script/against_mitsuba.py [-samples 16] [-width 256] [-reference 512] [-mesh scan.obj] [-variant llvm_ad_rgb]
                              [-sampler multijitter] [-runs 3] [-simd avx2]

Needs `pip install mitsuba numpy`. RAYPRO names the program (default build/raypro). With -simd avx2 both are kept to
vectors of 256 bits, raypro in its kernels for rays and Mitsuba in what LLVM compiles for it.

For each scene: camera samples per CPU second, of the fastest run, without start and load (and, of Mitsuba, without
compiling its kernels);
the relative squared error against a reference that is the mean of both programs' own; efficiency, which is 1 over
error times seconds; and by how much the means of the two references differ. Above 1 a ratio is in our favor.
"""

import argparse
import math
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import beside

root = Path(__file__).resolve().parent.parent
raypro = os.environ.get("RAYPRO", str(root / "build/raypro"))
most_bounces = 6
simd = "best"  # of raypro


class Scene:
    """One scene in both languages, built a thing at a time."""

    def __init__(self, folder, name, eye, target, half_angle, bounces=most_bounces):
        import mitsuba as mi

        self.mi, self.folder, self.name, self.bounces = mi, folder, name, bounces
        self.options = []  # of raypro
        towards = [t - e for e, t in zip(eye, target)]
        self.lines = ["camera %r %r %r %r %r %r 0 1 0 %r 0.01 100" % (*eye, *towards, half_angle),
                      "point_light 0 0 0  0 0 0  1 0 0"]  # so that there are no default lights
        self.materials = 0
        self.parts = {
            "type": "scene",
            "sensor": {
                "type": "perspective",
                "fov": math.degrees(2 * half_angle),
                "fov_axis": "x",
                "to_world": mi.ScalarTransform4f().look_at(origin=eye, target=target, up=[0, 1, 0]),
            },
        }

    def _add(self, part):
        self.parts["part%d" % len(self.parts)] = part

    def _material(self, color, emission):
        self.lines.append(
            "material 0 0 0  %r %r %r  0 0 0  0 0 0  %r %r %r  1 1 0" % (*color, *emission)
        )
        self.materials += 1
        return self.materials - 1

    def _surface(self, color, emission):
        part = {"bsdf": {"type": "twosided", "b": {"type": "diffuse", "reflectance": {"type": "rgb", "value": color}}}}
        if any(emission):
            part["emitter"] = {"type": "area", "radiance": {"type": "rgb", "value": emission}}
        return part

    def sphere(self, center, radius, color, emission=(0, 0, 0)):
        self.lines.append("sphere %d %r %r %r %r" % (self._material(color, emission), *center, radius))
        self._add({"type": "sphere", "center": list(center), "radius": radius,
                   **self._surface(list(color), list(emission))})

    def mesh(self, corners, faces, color):
        path = self.folder / ("%s%d.obj" % (self.name, len(self.lines)))
        with open(path, "w") as out:
            out.writelines("v %r %r %r\n" % tuple(c) for c in corners)
            out.writelines("f %s\n" % " ".join(str(i + 1) for i in f) for f in faces)
        self.mesh_file(path, color)

    def mesh_file(self, path, color):
        self.lines.append("mesh %d %s" % (self._material(color, (0, 0, 0)), path.name))
        self._add({"type": "obj", "filename": str(path), "face_normals": True, **self._surface(list(color), [0, 0, 0])})

    def quad(self, a, b, c, d, color):
        self.mesh([a, b, c, d], [(0, 1, 2), (0, 2, 3)], color)

    def box(self, low, high, color):
        x, y, z = zip(low, high)
        corners = [(x[i & 1], y[i >> 1 & 1], z[i >> 2]) for i in range(8)]
        sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
        self.mesh(corners, [f for s in sides for f in ((s[0], s[1], s[2]), (s[0], s[2], s[3]))], color)

    def lens(self, radius, distance):
        self.options += ["-aperture", str(radius), "-focus", str(distance)]
        self.parts["sensor"].update(type="thinlens", aperture_radius=radius, focus_distance=distance)

    def environment(self, sky):
        """`sky`: radiance by row from the top, by column from -z by +x."""
        import numpy as np

        height, width, _ = sky.shape
        path = self.folder / (self.name + ".pfm")
        with open(path, "wb") as out:
            out.write(b"PF\n%d %d\n-1.0\n" % (width, height))
            out.write(np.ascontiguousarray(sky[::-1]).astype("<f4").tobytes())
        self.lines.append("environment %s" % path.name)
        # In our maps -z is the middle, in Mitsuba's the edge.
        turned = np.roll(sky, width // 2, axis=1).astype("f4")
        self._add({"type": "envmap", "bitmap": self.mi.Bitmap(turned)})

    def save(self):
        self.path = self.folder / (self.name + ".scn")
        self.path.write_text("\n".join(self.lines) + "\n")
        return self


def sky_with_sun():
    """With soft edges: Mitsuba blends between texels, raypro does not."""
    import numpy as np

    height, width = 256, 512
    latitude = math.pi * (0.5 - (np.arange(height)[:, None] + 0.5) / height)
    longitude = 2 * math.pi * ((np.arange(width)[None, :] + 0.5) / width - 0.5)
    to_sun = np.array([-0.75, 0.6, 0.28])
    cosine = (to_sun[0] * np.cos(latitude) * np.sin(longitude) + to_sun[1] * np.sin(latitude)
              - to_sun[2] * np.cos(latitude) * np.cos(longitude)) / np.linalg.norm(to_sun)
    sky = np.where(latitude > 0, 0.35 + 0.5 * np.sin(np.maximum(latitude, 0)), 0.15)
    sky = np.broadcast_to(sky, (height, width))[..., None] * np.array([0.8, 0.9, 1.0])
    return sky + 60 * np.exp(800 * (cosine - 1))[..., None]


def scan(folder, path):
    """A mesh under a sky with a sun."""
    if path:
        points = [tuple(map(float, l.split()[1:4])) for l in open(path) if l.startswith("v ")]
        low = [min(p[k] for p in points) for k in range(3)]
        high = [max(p[k] for p in points) for k in range(3)]
    else:
        low, high = [-1, 0, -1], [1, 2, 1]
    size = max(h - l for l, h in zip(low, high))
    middle = [(l + h) / 2 for l, h in zip(low, high)]
    eye = [middle[0] + 0.3 * size, middle[1] + 0.5 * size, middle[2] + 2.2 * size]
    s = Scene(folder, "scan", eye, middle, 0.3)
    if path:
        s.mesh_file(Path(shutil.copy(path, folder)), (0.6, 0.5, 0.4))
    else:
        s.mesh(*beside.bumpy_ball(), (0.6, 0.5, 0.4))
    r = 10 * size
    s.quad((-r, low[1], r), (r, low[1], r), (r, low[1], -r), (-r, low[1], -r), (0.4, 0.4, 0.4))
    s.environment(sky_with_sun())
    return s.save()


def cornell(folder, name="cornell", bounces=most_bounces):
    """A closed room with two boxes, lit by one ball."""
    s = Scene(folder, name, (0, 1, 3.9), (0, 1, 0), 0.26, bounces)
    white = (0.75, 0.75, 0.75)
    s.quad((-1, 0, 4), (1, 0, 4), (1, 0, -1), (-1, 0, -1), white)
    s.quad((-1, 2, 4), (-1, 2, -1), (1, 2, -1), (1, 2, 4), white)
    s.quad((-1, 0, -1), (1, 0, -1), (1, 2, -1), (-1, 2, -1), white)
    s.quad((1, 0, 4), (-1, 0, 4), (-1, 2, 4), (1, 2, 4), white)
    s.quad((-1, 0, 4), (-1, 0, -1), (-1, 2, -1), (-1, 2, 4), (0.6, 0.1, 0.1))
    s.quad((1, 0, -1), (1, 0, 4), (1, 2, 4), (1, 2, -1), (0.1, 0.6, 0.1))
    s.box((-0.6, 0, -0.6), (-0.05, 1.2, -0.1), white)
    s.box((0.1, 0, 0), (0.6, 0.6, 0.5), white)
    s.sphere((0, 1.7, 0), 0.15, (0, 0, 0), (20, 19, 17))
    return s.save()


def direct(folder):
    """The same room, light that comes straight from the ball."""
    return cornell(folder, "direct", 0)


def spheres(folder, name="spheres"):
    """Balls on a floor under a sky and two lamps."""
    s = Scene(folder, name, (0, 3, 8), (0, 0.6, 0), 0.35)
    s.quad((-20, 0, 20), (20, 0, 20), (20, 0, -20), (-20, 0, -20), (0.5, 0.5, 0.5))
    for i in range(36):
        x, z = (i % 6 - 2.5) * 1.1, (i // 6 - 2.5) * 1.1
        color = tuple(0.25 + 0.5 * ((i * k) % 7) / 6 for k in (1, 2, 3))
        s.sphere((x, 0.25 + 0.2 * (i % 3), z), 0.25 + 0.05 * (i % 4), color)
    s.sphere((-3, 3, 2), 0.4, (0, 0, 0), (12, 11, 9))
    s.sphere((3, 2.5, -2), 0.3, (0, 0, 0), (8, 9, 12))
    s.environment(sky_with_sun() / 4)
    return s.save()


def lens(folder):
    """The same balls through a lens that shows those in the middle sharp."""
    s = spheres(folder, "lens")
    s.lens(0.1, 8.4)
    return s


def ours(scene, width, samples, runs=1, seed=0):
    import numpy as np

    def run(out, width, samples):
        before = beside.children_seconds()
        subprocess.run(
            [raypro, str(scene.path), str(out), "-width", str(width), "-height", str(width), "-samples", str(samples),
             "-mode", "path", "-max_depth", str(scene.bounces), "-threads", "1", "-seed", str(seed), "-quiet", "-restart",
             "-simd", simd, *scene.options],
            check=True)
        return beside.children_seconds() - before

    out = scene.folder / "ours.pfm"
    start = min(run(out, 1, 1) for _ in range(3))
    seconds = min(run(out, width, samples) for _ in range(runs)) - start
    with open(out, "rb") as f:
        assert f.readline().strip() == b"PF"
        w, h = map(int, f.readline().split())
        f.readline()
        return np.frombuffer(f.read(), "<f4").reshape(h, w, 3)[::-1].astype(float), seconds


def theirs(scene, width, samples, sampler, runs=1, seed=0):
    import numpy as np

    mi = scene.mi
    parts = dict(scene.parts)
    parts["integrator"] = {"type": "path", "max_depth": scene.bounces + 2}
    parts["sensor"] = {
        **parts["sensor"],
        "film": {"type": "hdrfilm", "width": width, "height": width, "rfilter": {"type": "box"},
                 "pixel_format": "rgb", "component_format": "float32"},
        "sampler": {"type": sampler, "sample_count": samples},
    }
    loaded = mi.load_dict(parts)
    np.array(mi.render(loaded, seed=seed + 1000))  # compiles

    def run():
        before = time.process_time()
        return np.array(mi.render(loaded, seed=seed), dtype=float), time.process_time() - before

    return min((run() for _ in range(runs)), key=lambda made: made[1])


def keep_to_avx2(mitsuba):
    """Has Mitsuba compile for vectors of 256 bits. Dr.Jit has no name for that in Python, but a function of C++."""
    import ctypes

    core = ctypes.CDLL(str(Path(mitsuba.__file__).parent.parent / "drjit" / "libdrjit-core.so"))
    core._Z19jit_llvm_set_targetPKcS0_j(b"x86-64-v3", None, 8)
    if core._Z21jit_llvm_vector_widthv() != 8:
        sys.exit("against_mitsuba.py: Mitsuba cannot be kept to AVX2")


def relative_error(image, truth):
    import numpy as np

    return float(np.mean((image - truth) ** 2 / (truth**2 + (0.01 * truth.mean()) ** 2)))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-samples", type=int, default=16)
    parser.add_argument("-width", type=int, default=256)
    parser.add_argument("-reference", type=int, default=512, help="samples of the references")
    parser.add_argument("-mesh", help="an OBJ for the scene scan; without it a ball with bumps")
    parser.add_argument("-variant", default="llvm_ad_rgb", help="of Mitsuba; also scalar_rgb")
    parser.add_argument("-sampler", default="multijitter", help="of Mitsuba, whose own default is independent")
    parser.add_argument("-simd", choices=("best", "avx2"), default="best", help="of both programs")
    parser.add_argument("-runs", type=int, default=3, help="of each program; the fastest counts")
    asked = parser.parse_args()
    try:
        import mitsuba as mi
        import numpy  # noqa: F401
    except ImportError as missing:
        sys.exit("against_mitsuba.py: %s; pip install mitsuba numpy" % missing)
    mi.set_variant(asked.variant)
    mi.set_log_level(mi.LogLevel.Error)
    if asked.simd == "avx2":
        global simd
        simd = "avx2"
        keep_to_avx2(mi)
    print("raypro beside Mitsuba %s %s, %s, -simd %s, %dx%d, %d samples, %d bounces, one thread; %s; %s" % (
        mi.__version__, asked.variant, asked.sampler, asked.simd, asked.width, asked.width, asked.samples, most_bounces, beside.processor(),
        time.strftime("%Y-%m-%d")))
    print("%-9s%11s%11s%8s%12s%12s%12s%14s" % (
        "scene", "ours M/s", "theirs M/s", "ratio", "our error", "their error", "efficiency", "means differ"))
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for scene in (scan(folder, asked.mesh), cornell(folder), spheres(folder), direct(folder), lens(folder)):
            our_reference, _ = ours(scene, asked.width, asked.reference, seed=7)
            their_reference, _ = theirs(scene, asked.width, asked.reference, asked.sampler, seed=7)
            truth = (our_reference + their_reference) / 2
            million = asked.width**2 * asked.samples * 1e-6
            our_image, our_seconds = ours(scene, asked.width, asked.samples, asked.runs)
            their_image, their_seconds = theirs(scene, asked.width, asked.samples, asked.sampler, asked.runs)
            our_error, their_error = relative_error(our_image, truth), relative_error(their_image, truth)
            print("%-9s%11.3f%11.3f%8.2f%12.3g%12.3g%12.2f%13.2f%%" % (
                scene.name, million / our_seconds, million / their_seconds, their_seconds / our_seconds, our_error,
                their_error, their_error * their_seconds / (our_error * our_seconds),
                100 * (our_reference.mean() / their_reference.mean() - 1)), flush=True)


main()
