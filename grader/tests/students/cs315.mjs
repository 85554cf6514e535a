// A ray tracer as a student of CS 315 may hand it in, written from the course's equations alone. It shares no code with
// raypro, so that tests can ask what raygrade says of a right program of somebody else.
//   usage: node cs315.mjs scene.json image.ppm width height
import { readFileSync, writeFileSync } from "node:fs";

const add = (a, b) => a.map((x, i) => x + b[i]);
const sub = (a, b) => a.map((x, i) => x - b[i]);
const mul = (a, b) => a.map((x, i) => x * b[i]);
const times = (s, a) => a.map((x) => s * x);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => times(1 / Math.sqrt(dot(a, a)), a);
const radians = (degrees) => (degrees * Math.PI) / 180;

// A transform is three columns and where the origin goes. The last one of a list acts on the shape first.
const turned = (m, d) => add(add(times(d[0], m[0]), times(d[1], m[1])), times(d[2], m[2]));
const moved = (m, p) => add(turned(m, p), m[3]);
const product = (a, b) => [turned(a, b[0]), turned(a, b[1]), turned(a, b[2]), moved(a, b[3])];
const identity = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, 0]];

function rotation([x, y, z]) {
  const [cx, cy, cz] = [x, y, z].map((angle) => Math.cos(radians(angle))),
    [sx, sy, sz] = [x, y, z].map((angle) => Math.sin(radians(angle))),
    none = [0, 0, 0];
  const about = [
    [[1, 0, 0], [0, cx, sx], [0, -sx, cx], none],
    [[cy, 0, -sy], [0, 1, 0], [sy, 0, cy], none],
    [[cz, sz, 0], [-sz, cz, 0], [0, 0, 1], none],
  ];
  return product(product(about[0], about[1]), about[2]);
}

function transformOf([kind, v]) {
  if (kind === "Translate") return [...identity.slice(0, 3), v];
  if (kind === "Scale") return [[v[0], 0, 0], [0, v[1], 0], [0, 0, v[2]], [0, 0, 0]];
  return rotation(v);
}

function inverse([a, b, c, at]) {
  const rows = [cross(b, c), cross(c, a), cross(a, b)].map((row) => times(1 / dot(a, cross(b, c)), row));
  const columns = [0, 1, 2].map((i) => rows.map((row) => row[i]));
  return [...columns, times(-1, turned([...columns, [0, 0, 0]], at))];
}

const scene = JSON.parse(readFileSync(process.argv[2], "utf8"));
for (const surface of scene.surfaces)
  surface.toOwn = inverse((surface.transforms ?? []).map(transformOf).reduce(product, identity));

function hitsOf(surface, origin, way) {
  if (surface.shape === "Sphere") {
    const m = sub(origin, surface.center),
      a = dot(way, way), b = dot(m, way), c = dot(m, m) - surface.radius ** 2,
      root = Math.sqrt(b * b - a * c); // NaN where there is none, which no comparison holds for
    return [(-b - root) / a, (-b + root) / a].map((t) => [t, add(m, times(t, way))]);
  }
  const e = sub(surface.p2, surface.p1), f = sub(surface.p3, surface.p1), n = cross(e, f),
    m = sub(origin, surface.p1), q = cross(m, way), det = -dot(way, n),
    u = dot(f, q) / det, v = -dot(e, q) / det;
  return u >= 0 && v >= 0 && u + v <= 1 ? [[dot(m, n) / det, n]] : [];
}

function nearest(origin, way, least, most = Infinity) {
  let best = { t: most };
  for (const surface of scene.surfaces)
    for (const [t, normal] of hitsOf(surface, moved(surface.toOwn, origin), turned(surface.toOwn, way)))
      if (t > least && t < best.t) best = { t, normal, surface };
  return best.surface && best;
}

const shadowBias = scene.shadow_bias ?? 0.0001;

function trace(origin, way, bounces, least) {
  const hit = nearest(origin, way, least);
  if (!hit) return [0, 0, 0];
  const p = add(origin, times(hit.t, way)),
    material = scene.materials[hit.surface.material],
    transposed = hit.surface.toOwn.slice(0, 3).map((column) => dot(column, hit.normal));
  let n = unit(transposed);
  if (dot(n, way) > 0) n = times(-1, n);
  let sum = [0, 0, 0];
  for (const light of scene.lights) {
    if (light.source === "Ambient") {
      sum = add(sum, mul(material.ka, light.color));
      continue;
    }
    const toLight = light.source === "Point" ? sub(light.position, p) : times(-1, light.direction),
      distance = light.source === "Point" ? Math.sqrt(dot(toLight, toLight)) : Infinity,
      l = unit(toLight),
      cosine = dot(n, l);
    if (cosine <= 0 || nearest(p, l, shadowBias, distance)) continue;
    sum = add(sum, times(cosine, mul(material.kd, light.color)));
    const lobe = -dot(way, sub(times(2 * cosine, n), l));
    if (lobe > 0 && material.shininess > 0)
      sum = add(sum, times(lobe ** material.shininess, mul(material.ks, light.color)));
  }
  if (bounces === 0 || !material.kr?.some((k) => k > 0)) return sum;
  return add(sum, mul(material.kr, trace(p, sub(way, times(2 * dot(way, n), n)), bounces - 1, shadowBias)));
}

const [width, height] = process.argv.slice(4).map(Number);
const { eye, at, up, fovy, aspect } = scene.camera;
const back = unit(sub(eye, at)), right = unit(cross(up, back)), above = cross(back, right);
const tall = 2 * Math.tan(radians(fovy) / 2), wide = tall * aspect;
const bytes = [];
for (let y = 0; y < height; ++y)
  for (let x = 0; x < width; ++x) {
    const across = times(wide * ((x + 0.5) / width - 0.5), right),
      along = times(tall * (0.5 - (y + 0.5) / height), above);
    const color = trace(eye, unit(sub(add(across, along), back)), scene.bounce_depth ?? 0, 1e-9);
    bytes.push(...color.map((c) => Math.max(0, Math.min(255, Math.floor(255 * c)))));
  }
writeFileSync(process.argv[3], Buffer.concat([Buffer.from(`P6\n${width} ${height}\n255\n`), Buffer.from(bytes)]));
