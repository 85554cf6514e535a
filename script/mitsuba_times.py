#!/usr/bin/env python3
"""Renders a scene of bench/scenes with Mitsuba 3: processor seconds and true errors of ever more samples.

    script/mitsuba_times.py scene.scn [-size N] [-seconds S] [-samples N] [-max_depth N] [-aperture R -focus D]
                            [-denoise] [-avx2] -references FOLDER/NAME

Needs `pip install mitsuba numpy`, and pyoidn for -denoise: Open Image Denoise with the albedos and normals of the
first surfaces. Prints a line for each of 4, 8, 16, ... samples per pixel, or for -samples alone: seconds, error. The
error is the root mean square in 255ths, as displayed, against two references of 1,024 samples of Mitsuba's own, which
are kept as FOLDER/NAME.1.npy and .2.npy. The seconds are of one thread, without start, load and compiling.

Of the language it reads what these scenes use. Glass is Fresnel's, and the sky is blended between texels.
"""

import argparse
import ctypes
import math
import sys
import time
from pathlib import Path

try:
    import drjit
    import mitsuba as mi
    import numpy as np
except ImportError as missing:
    sys.exit("mitsuba_times.py: %s; pip install mitsuba numpy" % missing)

samples_of_references = 1024


def keep_to_avx2():
    """Has Dr.Jit compile for vectors of 256 bits: a function of its C++ library, without a name in Python."""
    core = ctypes.CDLL(str(Path(drjit.__file__).parent / "libdrjit-core.so"))
    core._Z19jit_llvm_set_targetPKcS0_j(b"x86-64-v3", None, 8)
    if core._Z21jit_llvm_vector_widthv() != 8:
        sys.exit("mitsuba_times.py: Mitsuba cannot be kept to AVX2")


def surface_of(numbers):
    """Returns the BSDF, and emitter, of a `material`: ka, kd, ks, kt, emission, shininess, ior, texture."""
    kd, kt, emission, ior = numbers[3:6], numbers[9:12], numbers[12:15], numbers[16]
    if any(kt):
        return {"bsdf": {"type": "dielectric", "int_ior": ior}}
    diffuse = {"type": "diffuse", "reflectance": {"type": "rgb", "value": kd}}
    light = {"emitter": {"type": "area", "radiance": {"type": "rgb", "value": emission}}} if any(emission) else {}
    return {"bsdf": {"type": "twosided", "b": diffuse}, **light}


def environment_of(path):
    """In our maps -z is the middle, in Mitsuba's the edge."""
    sky = np.array(mi.Bitmap(str(path)).convert(mi.Bitmap.PixelFormat.RGB, mi.Struct.Type.Float32, False))
    return {"type": "envmap", "bitmap": mi.Bitmap(np.roll(sky, sky.shape[1] // 2, axis=1))}


def place(x, y, z, origin):
    """Returns the transform with these axes."""
    return mi.ScalarTransform4f(np.vstack([np.column_stack([x, y, z, origin]), [0, 0, 0, 1]]))


def rectangle_of(corners):
    a, b, c, d = np.array(corners).reshape(4, 3)
    if not np.allclose(a + c, b + d):
        sys.exit("mitsuba_times.py: a quad is not a parallelogram")
    x, y = (b - a) / 2, (d - a) / 2
    return {"type": "rectangle", "to_world": place(x, y, np.cross(x, y), (a + c) / 2)}


def box_of(corners):
    low, high = np.array(corners).reshape(2, 3)
    return {"type": "cube", "to_world": place(*np.diag((high - low) / 2), (low + high) / 2)}


def read(path):
    """Returns the parts of Mitsuba's scene, with its camera."""
    parts, surfaces = {"type": "scene"}, []
    for line in path.read_text().splitlines():
        word, *values = line.split() or ["#"]
        if word in ("environment", "mesh"):
            file = str(path.parent / values.pop())
        numbers = [float(v) for v in values] if not word.startswith("#") else []
        if word == "camera":
            eye, towards, up = numbers[0:3], numbers[3:6], numbers[6:9]
            to_world = mi.ScalarTransform4f().look_at(origin=eye, target=list(np.add(eye, towards)), up=up)
            parts["sensor"] = {"type": "perspective", "fov": math.degrees(2 * numbers[9]), "fov_axis": "x",
                               "to_world": to_world}
        elif word == "material":
            surfaces.append(surface_of(numbers))
        elif word == "environment":
            parts["sky"] = environment_of(file)
        elif word in ("quad", "box", "sphere", "mesh"):
            shape = {"quad": rectangle_of, "box": box_of,
                     "sphere": lambda n: {"type": "sphere", "center": n[:3], "radius": n[3]},
                     "mesh": lambda n: {"type": "obj", "filename": file, "face_normals": True}}[word](numbers[1:])
            parts["shape%d" % len(parts)] = {**shape, **surfaces[int(numbers[0])]}
        elif not word.startswith("#") and (word != "point_light" or any(numbers[0:3])):
            sys.exit("mitsuba_times.py: %s: '%s' is not read" % (path, word))
    return parts


class Renderer:
    """A scene that is compiled for one number of samples at a time."""

    def __init__(self, settings):
        self.settings = settings
        self.parts = read(settings.scene)
        if settings.aperture:
            self.parts["sensor"].update(type="thinlens", aperture_radius=settings.aperture,
                                        focus_distance=settings.focus)

    def render(self, samples, seed, denoise):
        """Returns an image in linear light, and its processor seconds."""
        path = {"type": "path", "max_depth": self.settings.max_depth + 2}
        aovs = {"type": "aov", "aovs": "albedo:albedo,normal:sh_normal", "image": path}
        film = {"type": "hdrfilm", "width": self.settings.size, "height": self.settings.size,
                "rfilter": {"type": "box"}, "pixel_format": "rgb", "component_format": "float32"}
        sensor = {**self.parts["sensor"], "film": film,
                  "sampler": {"type": "multijitter", "sample_count": samples}}
        scene = mi.load_dict({**self.parts, "sensor": sensor, "integrator": aovs if denoise else path})

        def finish(layers):
            layers = np.array(layers, dtype=np.float32)
            if not denoise:
                return layers
            import pyoidn

            color, albedo, normal = (np.ascontiguousarray(layers[:, :, k : k + 3]) for k in (0, 3, 6))
            return pyoidn.denoise(color, np.clip(albedo, 0, 1), normal, hdr=True)

        finish(mi.render(scene, seed=seed + 1000))  # compiles
        before = time.process_time()
        image = finish(mi.render(scene, seed=seed))
        return image, time.process_time() - before

    def reference(self, which):
        """Returns one of the two references, from its file if there is one of this size."""
        file = Path("%s.%d.npy" % (self.settings.references, which))
        if not file.exists():
            passes = 16  # each needs memory for its samples
            images = (self.render(samples_of_references // passes, 9000 + 100 * which + i, False)[0]
                      for i in range(passes))
            np.save(file, sum(image.astype(float) for image in images) / passes)
        return np.load(file)


def displayed(image):
    return 255 * np.clip(image, 0, 1)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene", type=Path)
    parser.add_argument("-size", type=int, default=128, help="pixels in a row and in a column")
    parser.add_argument("-seconds", type=float, default=10, help="the last line is the first that takes longer")
    parser.add_argument("-samples", type=int, help="a line for this number alone")
    parser.add_argument("-max_depth", type=int, default=6, help="bounces")
    parser.add_argument("-aperture", type=float, default=0, help="radius of the lens")
    parser.add_argument("-focus", type=float, default=1, help="distance")
    parser.add_argument("-denoise", action="store_true")
    parser.add_argument("-avx2", action="store_true", help="vectors of 256 bits")
    parser.add_argument("-references", required=True, help="their file names, without the ends")
    settings = parser.parse_args()
    mi.set_variant("llvm_ad_rgb")
    mi.set_log_level(mi.LogLevel.Error)
    drjit.set_thread_count(1)
    if settings.avx2:
        keep_to_avx2()
    renderer = Renderer(settings)
    first, second = displayed(renderer.reference(1)), displayed(renderer.reference(2))
    error_of_truth = np.mean((first - second) ** 2) / 4
    samples = settings.samples or 4
    while True:
        image, seconds = renderer.render(samples, 1, settings.denoise)
        square = np.mean((displayed(image) - (first + second) / 2) ** 2) - error_of_truth
        error = math.sqrt(max(square, 0))
        print("%.4f %.4f" % (seconds, error), flush=True)
        if settings.samples or seconds > settings.seconds or error < 0.5:
            return
        samples *= 2


main()
