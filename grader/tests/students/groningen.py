"""A ray tracer as a student of Groningen's course may hand it in, written from the course's equations alone.

It shares no code with raypro, so that tests can ask what raygrade says of a right program of somebody else. Python's
standard library is all that it needs.
  usage: groningen.py scene.yaml image.png width height
"""
import json
import math
import os
import re
import struct
import sys
import zlib

EPSILON = 1e-4


def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def mul(a, b):
    return (a[0] * b[0], a[1] * b[1], a[2] * b[2])


def times(s, a):
    return (s * a[0], s * a[1], s * a[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    return times(1 / math.sqrt(dot(a, a)), a)


def value_of(text):
    """A number, a word, or a list or mapping in brackets."""
    text = text.strip()
    try:
        return json.loads(re.sub(r"[A-Za-z_][\w.]*", lambda word: json.dumps(word.group()), text))
    except json.JSONDecodeError:
        return text


def read_scene(name):
    """The part of YAML that scenes use: keys at the top, lists of mappings in braces below them."""
    scene, items = {}, None
    with open(name, encoding="utf-8") as file:
        for line in file:
            line = line.split("#")[0].rstrip()
            if line.lstrip().startswith("- "):
                items.append(value_of(line.lstrip()[2:]))
            elif line:
                key, _, rest = line.partition(":")
                items = []
                scene[key] = value_of(rest) if rest.strip() else items
    return scene


def read_png(name):
    """Rows of (r, g, b) in 0..1, of eight bits and three channels, the top row first."""
    with open(name, "rb") as file:
        data = file.read()
    at, packed = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        chunk = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, bits, color = struct.unpack(">IIBB", chunk[:10])
            assert (bits, color) == (8, 2)
        if kind == b"IDAT":
            packed += chunk
        at += length + 12
    raw, stride, rows, above = zlib.decompress(packed), 3 * width, [], bytes(3 * width)
    for y in range(height):
        how, row = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            left, up, corner = (row[i - 3], above[i], above[i - 3]) if i >= 3 else (0, above[i], 0)
            guess = left + up - corner
            paeth = min((abs(guess - left), 0, left), (abs(guess - up), 1, up), (abs(guess - corner), 2, corner))[2]
            row[i] = (row[i] + (0, left, up, (left + up) // 2, paeth)[how]) & 255
        rows.append([tuple(byte / 255 for byte in row[i:i + 3]) for i in range(0, stride, 3)])
        above = row
    return rows


def write_png(name, width, height, pixels):
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    def row(y):
        colors = pixels[y * width:(y + 1) * width]
        return b"\0" + bytes(max(0, min(255, int(255 * c))) for color in colors for c in color)

    raw = b"".join(row(y) for y in range(height))
    with open(name, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
                   chunk(b"IDAT", zlib.compress(raw)) + chunk(b"IEND", b""))


class Sphere:
    def __init__(self, data):
        self.center, self.radius = data["position"], data["radius"]

    def crossings(self, origin, way):
        m = sub(origin, self.center)
        b, c = dot(m, way), dot(m, m) - self.radius**2
        if b * b < c:
            return ()
        root = math.sqrt(b * b - c)
        return (-b - root, -b + root)

    def normal(self, p):
        return times(1 / self.radius, sub(p, self.center))

    def color(self, rows, p):
        """North is towards +z; u turns from +x, v runs down from the pole."""
        n = self.normal(p)
        u, v = math.atan2(n[1], n[0]) / (2 * math.pi) % 1, math.acos(max(-1, min(1, n[2]))) / math.pi
        height, width = len(rows), len(rows[0])
        x, y = u * width - 0.5, v * height - 0.5
        i, j = math.floor(x), math.floor(y)

        def texel(column, row):
            return rows[max(0, min(height - 1, row))][column % width]

        top = add(times(1 - x + i, texel(i, j)), times(x - i, texel(i + 1, j)))
        bottom = add(times(1 - x + i, texel(i, j + 1)), times(x - i, texel(i + 1, j + 1)))
        return add(times(1 - y + j, top), times(y - j, bottom))


class Triangle:
    def __init__(self, data):
        self.corner = data["v0"]
        self.e, self.f = sub(data["v1"], self.corner), sub(data["v2"], self.corner)
        self.n = cross(self.e, self.f)

    def crossings(self, origin, way):
        det = -dot(way, self.n)
        if det == 0:
            return ()
        m = sub(origin, self.corner)
        q = cross(m, way)
        u, v = dot(self.f, q) / det, -dot(self.e, q) / det
        return (dot(m, self.n) / det,) if u >= 0 and v >= 0 and u + v <= 1 else ()

    def normal(self, _):
        return unit(self.n)


class Tracer:
    def __init__(self, name):
        self.scene = read_scene(name)
        self.objects = []
        for data in self.scene["Objects"]:
            shape = Sphere(data) if data["type"] == "sphere" else Triangle(data)
            shape.material = data["material"]
            if "texture" in shape.material:
                shape.rows = read_png(os.path.join(os.path.dirname(name), shape.material["texture"]))
            self.objects.append(shape)
        self.shadows = self.scene.get("Shadows") in (True, "true")
        self.mode = self.scene.get("RenderMode", "phong")

    def nearest(self, origin, way, most=math.inf):
        best, hit = most, None
        for shape in self.objects:
            for t in shape.crossings(origin, way):
                if EPSILON < t < best:
                    best, hit = t, shape
        return best, hit

    def trace(self, origin, way, bounces):
        t, shape = self.nearest(origin, way)
        if not shape:
            return (0, 0, 0)
        p, m = add(origin, times(t, way)), shape.material
        normal = shape.normal(p)
        entering = dot(normal, way) < 0
        n = normal if entering else times(-1, normal)
        if self.mode == "normal":
            return times(0.5, add(n, (1, 1, 1)))
        color = shape.color(shape.rows, p) if "texture" in m else m["color"]
        total = (0, 0, 0)
        for light in self.scene["Lights"]:
            total = add(total, times(m["ka"], mul(color, light["color"])))
            to_light = sub(light["position"], p)
            distance = math.sqrt(dot(to_light, to_light))
            direction = times(1 / distance, to_light)
            cosine = dot(n, direction)
            if cosine <= 0 or (self.shadows and self.nearest(p, direction, distance)[1]):
                continue
            total = add(total, times(m["kd"] * cosine, mul(color, light["color"])))
            lobe = -dot(way, sub(times(2 * cosine, n), direction))
            if lobe > 0:
                total = add(total, times(m["ks"] * lobe**m["n"], light["color"]))
        if bounces == 0:
            return total
        mirrored = sub(way, times(2 * dot(way, n), n))
        if m["ks"] > 0:
            total = add(total, times(m["ks"], self.trace(p, mirrored, bounces - 1)))
        if m.get("refract", 0) > 0:
            index = 1 / m["eta"] if entering else m["eta"]
            cosine = -dot(n, way)
            squared = 1 - index * index * (1 - cosine * cosine)
            # Where no ray can leave, all goes along the mirrored one.
            further = add(times(index, way), times(index * cosine - math.sqrt(squared), n)) if squared > 0 else mirrored
            total = add(total, times(m["refract"], self.trace(p, unit(further), bounces - 1)))
        return total

    def image(self, width, height):
        if "Camera" in self.scene:
            camera = self.scene["Camera"]
            eye, center, up = camera["eye"], camera["center"], camera["up"]
            ahead, size = unit(sub(center, eye)), math.sqrt(dot(up, up))
            right = times(size, unit(cross(ahead, up)))
            up = times(size, unit(cross(right, ahead)))
        else:
            eye, center, right, up = self.scene["Eye"], (200, 200, 0), (400 / width, 0, 0), (0, 400 / height, 0)
        bounces = self.scene.get("MaxRecursionDepth", 0)
        for y in range(height):
            for x in range(width):
                goal = add(center, add(times(x + 0.5 - width / 2, right), times(height / 2 - y - 0.5, up)))
                yield self.trace(eye, unit(sub(goal, eye)), bounces)


def main():
    scene, image, width, height = sys.argv[1], sys.argv[2], int(sys.argv[3]), int(sys.argv[4])
    write_png(image, width, height, list(Tracer(scene).image(width, height)))


main()
