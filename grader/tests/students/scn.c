/* A ray tracer as a student of COS426 or INFOGR may hand it in: one file of C, written from the courses' equations
   alone. It shares no code with raypro, so that tests can ask what raygrade says of a right program of somebody else.
     scn scene.scn image.ppm width height [fresnel]
   Not here: meshes. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
  double x, y, z;
} V;
typedef struct {
  double m[3][4];
} M;

static V v(double x, double y, double z) {
  V r;
  r.x = x, r.y = y, r.z = z;
  return r;
}
static V add(V a, V b) { return v(a.x + b.x, a.y + b.y, a.z + b.z); }
static V sub(V a, V b) { return v(a.x - b.x, a.y - b.y, a.z - b.z); }
static V mul(V a, V b) { return v(a.x * b.x, a.y * b.y, a.z * b.z); }
static V times(double s, V a) { return v(s * a.x, s * a.y, s * a.z); }
static double dot(V a, V b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static V cross(V a, V b) { return v(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x); }
static V unit(V a) { return times(1 / sqrt(dot(a, a)), a); }
static int is_black(V a) { return a.x == 0 && a.y == 0 && a.z == 0; }

static V turned(const M* m, V d) {
  return v(m->m[0][0] * d.x + m->m[0][1] * d.y + m->m[0][2] * d.z,
           m->m[1][0] * d.x + m->m[1][1] * d.y + m->m[1][2] * d.z,
           m->m[2][0] * d.x + m->m[2][1] * d.y + m->m[2][2] * d.z);
}
static V moved(const M* m, V p) { return add(turned(m, p), v(m->m[0][3], m->m[1][3], m->m[2][3])); }
static V turned_by_transpose(const M* m, V d) {
  return v(m->m[0][0] * d.x + m->m[1][0] * d.y + m->m[2][0] * d.z,
           m->m[0][1] * d.x + m->m[1][1] * d.y + m->m[2][1] * d.z,
           m->m[0][2] * d.x + m->m[1][2] * d.y + m->m[2][2] * d.z);
}
static M product(const M* a, const M* b) {
  M p;
  int i, j, k;
  for (i = 0; i < 3; ++i)
    for (j = 0; j < 4; ++j) {
      p.m[i][j] = j == 3 ? a->m[i][3] : 0;
      for (k = 0; k < 3; ++k) p.m[i][j] += a->m[i][k] * b->m[k][j];
    }
  return p;
}
static M inverse(const M* a) {
  const double(*m)[4] = a->m;
  V r0 = v(m[0][0], m[0][1], m[0][2]), r1 = v(m[1][0], m[1][1], m[1][2]), r2 = v(m[2][0], m[2][1], m[2][2]);
  V c0 = cross(r1, r2), c1 = cross(r2, r0), c2 = cross(r0, r1), t;
  double d = dot(r0, c0);
  M i = {{{c0.x / d, c1.x / d, c2.x / d, 0}, {c0.y / d, c1.y / d, c2.y / d, 0}, {c0.z / d, c1.z / d, c2.z / d, 0}}};
  t = turned(&i, v(m[0][3], m[1][3], m[2][3]));
  i.m[0][3] = -t.x, i.m[1][3] = -t.y, i.m[2][3] = -t.z;
  return i;
}

/* --- the scene --- */

typedef struct {
  V ka, kd, ks, kt, emission;
  double n, ir;
  int texture;
} Material;
typedef struct {
  int kind, material;
  V a, b, c;
  double radius;
  M to_world, to_own;
} Shape; /* kind: the first letter */
typedef struct {
  int kind;
  V color, at, along;
  double ca, la, qa, cutoff, exponent;
} Light;
typedef struct {
  int width, height;
  unsigned char* rgb;
} Image;

#define MOST 200
static Material materials[MOST];
static Shape shapes[MOST];
static Light lights[MOST];
static Image images[MOST];
static int material_count, shape_count, light_count, image_count, with_fresnel;
static V eye, towards, up, background, ambient;
static double half_angle;
static FILE* file;

static void fail(const char* why) {
  fprintf(stderr, "scn: %s\n", why);
  exit(1);
}
static double number(void) {
  double d;
  if (fscanf(file, "%lf", &d) != 1) fail("a number is missing");
  return d;
}
static V three(void) {
  double x = number(), y = number(), z = number();
  return v(x, y, z);
}

static int texture_named(const char* scene, const char* name) {
  char path[1000];
  const char* slash = strrchr(scene, '/');
  Image* image = &images[image_count];
  FILE* f;
  size_t size;
  sprintf(path, "%.*s%.200s", slash ? (int)(slash + 1 - scene) : 0, scene, name);
  if (!(f = fopen(path, "rb")) || fscanf(f, "P6 %d %d 255", &image->width, &image->height) != 2) fail("no texture");
  getc(f);
  size = (size_t)(3 * image->width * image->height);
  if (!(image->rgb = malloc(size)) || fread(image->rgb, 1, size, f) != size) fail("the texture is short");
  fclose(f);
  return image_count++;
}

static void read_shape(int kind, const M* group, int inherited) {
  Shape* s = &shapes[shape_count++];
  s->kind = kind;
  s->material = (int)number();
  if (s->material < 0) s->material = inherited;
  s->a = three();
  if (kind == 's')
    s->radius = number();
  else
    s->b = three();
  if (kind == 't') s->c = three();
  s->to_world = *group, s->to_own = inverse(group);
}

static void read_scene(const char* scene, const M* group, int inherited, int depth) {
  char word[200];
  while (fscanf(file, "%199s", word) == 1) {
    if (word[0] == '#') {
      while (!feof(file) && getc(file) != '\n') continue;
    } else if (!strcmp(word, "camera")) {
      eye = three(), towards = three(), up = three(), half_angle = number(), number(), number();
    } else if (!strcmp(word, "background"))
      background = three();
    else if (!strcmp(word, "ambient"))
      ambient = three();
    else if (!strcmp(word, "material")) {
      Material* m = &materials[material_count++];
      m->ka = three(), m->kd = three(), m->ks = three(), m->kt = three(), m->emission = three(), m->n = number(),
      m->ir = number();
      if (fscanf(file, "%199s", word) != 1) fail("a texture is missing");
      m->texture = strcmp(word, "0") ? texture_named(scene, word) : -1;
    } else if (!strcmp(word, "dir_light") || !strcmp(word, "point_light") || !strcmp(word, "spot_light")) {
      Light* l = &lights[light_count++];
      l->kind = word[0], l->color = three();
      if (l->kind != 'd') l->at = three();
      if (l->kind != 'p') l->along = unit(three());
      if (l->kind != 'd') l->ca = number(), l->la = number(), l->qa = number();
      if (l->kind == 's') l->cutoff = number(), l->exponent = number();
    } else if (!strcmp(word, "sphere") || !strcmp(word, "box") || !strcmp(word, "tri"))
      read_shape(word[0], group, inherited);
    else if (!strcmp(word, "begin")) {
      M own, all;
      int i, j, material = (int)number();
      for (i = 0; i < 3; ++i)
        for (j = 0; j < 4; ++j) own.m[i][j] = number();
      for (j = 0; j < 4; ++j) number();
      all = product(group, &own);
      read_scene(scene, &all, material < 0 ? inherited : material, depth + 1);
    } else if (!strcmp(word, "end") && depth > 0)
      return;
    else
      fail(word);
  }
}

/* --- rays --- */

typedef struct {
  double t;
  const Shape* shape;
  V own, normal;
} Hit; /* own: the place in the shape's frame */

static void offer(Hit* hit, double least, double t, const Shape* s, V own, V normal) {
  if (t > least && t < hit->t) hit->t = t, hit->shape = s, hit->own = own, hit->normal = normal;
}

static void hit_sphere(const Shape* s, V o, V d, double least, Hit* hit) {
  V m = sub(o, s->a);
  double a = dot(d, d), b = dot(m, d), c = dot(m, m) - s->radius * s->radius, root = b * b - a * c;
  int sign;
  if (root < 0) return;
  for (sign = -1; sign <= 1; sign += 2) {
    double t = (-b + sign * sqrt(root)) / a;
    V p = add(o, times(t, d));
    offer(hit, least, t, s, p, sub(p, s->a));
  }
}

static void hit_box(const Shape* s, V o, V d, double least, Hit* hit) {
  const double origin[3] = {o.x, o.y, o.z}, way[3] = {d.x, d.y, d.z}, a[3] = {s->a.x, s->a.y, s->a.z},
               b[3] = {s->b.x, s->b.y, s->b.z};
  int i, side;
  for (i = 0; i < 3; ++i)
    for (side = 0; side < 2; ++side) {
      double t = ((side ? b[i] : a[i]) - origin[i]) / way[i];
      V p = add(o, times(t, d));
      const double at[3] = {p.x, p.y, p.z};
      double n[3] = {0, 0, 0};
      int j = (i + 1) % 3, k = (i + 2) % 3;
      if (way[i] == 0 || at[j] < a[j] || at[j] > b[j] || at[k] < a[k] || at[k] > b[k]) continue;
      n[i] = side ? 1 : -1;
      offer(hit, least, t, s, p, v(n[0], n[1], n[2]));
    }
}

static void hit_triangle(const Shape* s, V o, V d, double least, Hit* hit) {
  V e = sub(s->b, s->a), f = sub(s->c, s->a), n = cross(e, f), m = sub(o, s->a), q;
  double det = -dot(d, n), u, w;
  if (det == 0) return;
  q = cross(m, d);
  u = dot(f, q) / det, w = -dot(e, q) / det;
  if (u < 0 || w < 0 || u + w > 1) return;
  offer(hit, least, dot(m, n) / det, s, add(s->a, add(times(u, e), times(w, f))), n);
}

static Hit nearest(V from, V d, double least, double most) {
  Hit hit;
  int i;
  hit.t = most, hit.shape = 0;
  for (i = 0; i < shape_count; ++i) {
    const Shape* s = &shapes[i];
    V o = moved(&s->to_own, from), w = turned(&s->to_own, d);
    if (s->kind == 's')
      hit_sphere(s, o, w, least, &hit);
    else if (s->kind == 'b')
      hit_box(s, o, w, least, &hit);
    else
      hit_triangle(s, o, w, least, &hit);
  }
  return hit;
}

/* --- shading --- */

static V texel(const Image* image, int x, int y) { /* repeated; row 0 of the file is the top */
  const unsigned char* p;
  x = (x % image->width + image->width) % image->width, y = (y % image->height + image->height) % image->height;
  p = image->rgb + 3 * ((image->height - 1 - y) * image->width + x);
  return v(p[0] / 255.0, p[1] / 255.0, p[2] / 255.0);
}

static V texture_at(const Material* m, const Hit* hit) {
  const Shape* s = hit->shape;
  const Image* image = &images[m->texture];
  V p = sub(hit->own, s->a), n = hit->normal;
  double a, b, x, y, pi = acos(-1.0);
  if (s->kind == 's') {
    a = atan2(p.x, p.y) / (2 * pi), b = 1 - acos(p.z / s->radius) / pi;
  } else if (s->kind == 'b') {
    double X = p.x / (s->b.x - s->a.x), Y = p.y / (s->b.y - s->a.y), Z = p.z / (s->b.z - s->a.z);
    a = n.x < 0 ? 1 - Y : n.x > 0 ? Y : n.y > 0 ? 1 - X : X;
    b = n.z < 0 ? 1 - Y : n.z > 0 ? Y : Z;
  } else {
    return v(1, 1, 1);
  }
  a = a * image->width - 0.5, b = b * image->height - 0.5;
  x = a - floor(a), y = b - floor(b);
  return add(times(1 - y, add(times(1 - x, texel(image, (int)floor(a), (int)floor(b))),
                              times(x, texel(image, (int)floor(a) + 1, (int)floor(b))))),
             times(y, add(times(1 - x, texel(image, (int)floor(a), (int)floor(b) + 1)),
                          times(x, texel(image, (int)floor(a) + 1, (int)floor(b) + 1)))));
}

static V arriving(const Light* l, V p, V* to_light, double* distance) {
  double d, fading;
  V color = l->color;
  if (l->kind == 'd') {
    *to_light = times(-1, l->along), *distance = 1e30;
    return color;
  }
  *to_light = sub(l->at, p), d = sqrt(dot(*to_light, *to_light)), *to_light = times(1 / d, *to_light), *distance = d;
  fading = l->ca + l->la * d + l->qa * d * d;
  if (l->kind == 's') {
    double cosine = -dot(l->along, *to_light);
    if (cosine <= 0 || acos(cosine > 1 ? 1 : cosine) > l->cutoff) return v(0, 0, 0);
    color = times(pow(cosine, l->exponent), color);
  }
  return times(1 / fading, color);
}

/* What part of the light a boundary reflects: the mean of both polarizations. */
static double reflected_part(double cos_i, double cos_t, double n) { /* n: index here over that beyond */
  double s = (n * cos_i - cos_t) / (n * cos_i + cos_t), p = (cos_i - n * cos_t) / (cos_i + n * cos_t);
  return (s * s + p * p) / 2;
}

static V trace(V from, V d, int bounces) {
  const double epsilon = 1e-6;
  Hit hit = nearest(from, d, epsilon, 1e30);
  const Material* m;
  V p, n, kd, sum;
  int i, is_entering;
  if (!hit.shape) return background;
  m = &materials[hit.shape->material];
  p = add(from, times(hit.t, d));
  n = unit(turned_by_transpose(&hit.shape->to_own, hit.normal));
  is_entering = dot(n, d) < 0;
  if (!is_entering) n = times(-1, n);
  kd = m->texture < 0 ? m->kd : mul(m->kd, texture_at(m, &hit));
  sum = add(m->emission, mul(m->ka, ambient));
  for (i = 0; i < light_count; ++i) {
    V l, light, r;
    double distance, cosine, lobe;
    light = arriving(&lights[i], p, &l, &distance);
    cosine = dot(n, l);
    if (cosine <= 0 || nearest(p, l, epsilon, distance).shape) continue;
    r = sub(times(2 * cosine, n), l), lobe = -dot(d, r);
    sum = add(sum, times(cosine, mul(kd, light)));
    if (lobe > 0) sum = add(sum, times(pow(lobe, m->n), mul(m->ks, light)));
  }
  if (bounces == 0) return sum;
  if (!is_black(m->ks)) sum = add(sum, mul(m->ks, trace(p, unit(sub(d, times(2 * dot(d, n), n))), bounces - 1)));
  if (!is_black(m->kt)) {
    double index = is_entering ? 1 / m->ir : m->ir, cos_i = -dot(n, d),
           squared = 1 - index * index * (1 - cos_i * cos_i), part = 1;
    V mirrored = unit(add(d, times(2 * cos_i, n)));
    if (squared > 0) {
      double cos_t = sqrt(squared);
      part = with_fresnel ? reflected_part(cos_i, cos_t, index) : 0;
      sum = add(sum, times(1 - part, mul(m->kt, trace(p, unit(add(times(index, d), times(index * cos_i - cos_t, n))),
                                                      bounces - 1))));
    }
    if (with_fresnel) sum = add(sum, times(part, mul(m->kt, trace(p, mirrored, bounces - 1))));
  }
  return sum;
}

static int byte(double c) { return c >= 1 ? 255 : c <= 0 ? 0 : (int)(255 * c); }

int main(int argc, char** argv) {
  const M world = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  int width, height, x, y;
  V right;
  FILE* out;
  if (argc < 5 || !(file = fopen(argv[1], "r")) || !(out = fopen(argv[2], "wb"))) {
    fail("scn scene image width height");
    return 1;
  }
  width = atoi(argv[3]), height = atoi(argv[4]), with_fresnel = argc > 5;
  read_scene(argv[1], &world, 0, 0);
  towards = unit(towards), right = unit(cross(towards, up)), up = cross(right, towards);
  fprintf(out, "P6\n%d %d\n255\n", width, height);
  for (y = height - 1; y >= 0; --y)
    for (x = 0; x < width; ++x) {
      double across = tan(half_angle) * (2 * (x + 0.5) / width - 1),
             along = tan(half_angle) * height / width * (2 * (y + 0.5) / height - 1);
      V c = trace(eye, unit(add(towards, add(times(across, right), times(along, up)))), 3);
      putc(byte(c.x), out), putc(byte(c.y), out), putc(byte(c.z), out);
    }
  return fclose(out) != 0;
}
