/* A small ray tracer for the .scn language in single precision, written to be graded: it has the mistakes of its list,
   one at a time or several, and none without. It shares no code with raypro: shapes are triangles, balls and slabs in
   frames of their own, normals are found by the adjoint, and epsilon is a length.
     other scene.scn image.ppm width height [word...]
   Words are names of mistakes or of liberties that a correct program may take. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MISTAKES(_) \
  _(far_root) _(t_in_lengths_of_each_group) _(radius_not_squared) _(behind_the_eye) _(last_shape_wins) \
  _(first_shape_wins) _(direction_unit_in_group) _(box_without_top) _(box_normals_by_largest) _(one_sided_triangles) \
  _(parallelograms) _(triangle_normals_reversed) _(ambient_by_kd) _(ambient_without_light) _(emission_per_light) \
  _(emission_by_kd) _(highlight_behind) _(highlight_by_cosine) _(exponent_halved) _(exponent_doubled) \
  _(diffuse_squared) _(brightest_light) _(mean_of_lights) _(clamp_by_largest) _(clamp_each_term) _(few_levels) \
  _(spot_without_shadow) _(boxes_cast_no_shadow) _(no_self_shadow) _(glass_casts_no_shadow) _(half_shadow) \
  _(large_epsilon) _(no_epsilon) _(shadow_takes_ambient) _(attenuation_swapped) _(attenuation_multiplied) \
  _(attenuation_without_constant) _(distance_squared) _(spot_linear) _(spot_backwards) _(spot_not_unit) \
  _(dir_not_unit) _(point_light_from_origin) _(mirror_sign) _(mirror_sees_no_background) _(two_bounces_more) \
  _(no_bounce) _(mirror_blends) _(mirror_unlit) _(glass_sign) _(total_reflection) _(glass_blends) \
  _(glass_normal_kept) _(angle_without_tan) _(whole_aspect) _(up_not_orthogonal) _(towards_not_unit) \
  _(pixels_less_one) _(view_not_unit) _(eye_moved) _(v_flipped) _(u_flipped) _(uv_swapped) _(pole_y) _(uv_doubled) \
  _(texture_replaces) _(texture_on_ambient) _(directions_moved) _(scale_ignored) _(no_inherited_material) \
  _(inner_group_ignored) _(matrix_inverted) _(half_exposure) _(offset) _(contrast) _(pixel_shift) _(g_b_r) \
  _(saturated) _(red_lost) _(no_light_two) _(normals_face_light) _(specular_white) _(one_and_a_half) \
  _(mirror_adds_twice) _(tinted_glass_lost) _(fog) _(noise) _(ambient_doubled) _(diffuse_by_ks)
#define LIBERTIES(_) _(nearest_texel) _(srgb) _(gamma22) _(four_samples) _(sixteen_samples) _(random_samples) \
  _(rounded) _(other_epsilon) _(lower_left) _(lower_right) _(upper_left) _(upper_right)
#define NAME(x) x,
enum Word { MISTAKES(NAME) LIBERTIES(NAME) word_count };
#define TEXT(x) #x,
static const char* const words[] = {MISTAKES(TEXT) LIBERTIES(TEXT)};
static char has[word_count];

typedef float F;
typedef struct { F x, y, z; } P;
static P p3(F x, F y, F z) { P r = {x, y, z}; return r; }
static P plus(P a, P b) { return p3(a.x + b.x, a.y + b.y, a.z + b.z); }
static P minus(P a, P b) { return p3(a.x - b.x, a.y - b.y, a.z - b.z); }
static P by(P a, P b) { return p3(a.x * b.x, a.y * b.y, a.z * b.z); }
static P scaled(P a, F s) { return p3(a.x * s, a.y * s, a.z * s); }
static F in(P a, P b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static P out(P a, P b) { return p3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x); }
static F len(P a) { return sqrtf(in(a, a)); }
static P norm(P a) { F l = len(a); return l > 0 ? scaled(a, 1 / l) : a; }
static F top(P a) { return fmaxf(a.x, fmaxf(a.y, a.z)); }
static F clamp01(F x) { return x < 0 ? 0 : x > 1 ? 1 : x; }
static P clamped(P c) { return p3(clamp01(c.x), clamp01(c.y), clamp01(c.z)); }

/* Columns of a frame and its origin. */
typedef struct { P x, y, z, o; } Frame;
static P dir(const Frame* f, P d) { return plus(scaled(f->x, d.x), plus(scaled(f->y, d.y), scaled(f->z, d.z))); }
static P point(const Frame* f, P q) { return plus(dir(f, q), f->o); }
static Frame nested(const Frame* a, const Frame* b) {
  Frame r = {dir(a, b->x), dir(a, b->y), dir(a, b->z), point(a, b->o)};
  return r;
}
static P solve(const Frame* f, P d) { /* Cramer */
  F det = in(f->x, out(f->y, f->z));
  return p3(in(d, out(f->y, f->z)) / det, in(f->x, out(d, f->z)) / det, in(f->x, out(f->y, d)) / det);
}
static P adjoint(const Frame* f, P n) { /* a normal of the frame in the world */
  F det = in(f->x, out(f->y, f->z));
  P r = plus(scaled(out(f->y, f->z), n.x), plus(scaled(out(f->z, f->x), n.y), scaled(out(f->x, f->y), n.z)));
  return det < 0 ? scaled(r, -1) : r;
}

typedef struct { P ka, kd, ks, kt, e; F n, ir; int tex; } Mat;
typedef struct { char kind; int mat, smooth; P a, b, c, na, nb, nc; F r; Frame f; } Obj;
typedef struct { char kind; P color, at, along; F ca, la, qa, cut, exp; } Lamp;
typedef struct { int w, h; unsigned char* rgb; } Tex;
static Mat mats[64]; static Obj objs[4096]; static Lamp lamps[32]; static Tex texs[8];
static int nm, no, nl, nt, depth_limit = 3, fresnel;
static P eye, towards, up, back, amb;
static F angle;
static FILE* in_file;
static char folder[900];

static void quit(const char* why) { fprintf(stderr, "other: %s\n", why); exit(1); }
static F num(void) { double d; if (fscanf(in_file, "%lf", &d) != 1) quit("number"); return (F)d; }
static P tri(void) { P r; r.x = num(); r.y = num(); r.z = num(); return r; }
static FILE* opened(const char* name, const char* how) {
  char path[1900];
  FILE* f;
  snprintf(path, sizeof path, "%s%s", folder, name);
  if (!(f = fopen(path, how))) quit(name);
  return f;
}
static int load_tex(const char* name) {
  Tex* t = &texs[nt];
  FILE* f = opened(name, "rb");
  if (fscanf(f, "P6 %d %d 255", &t->w, &t->h) != 2) quit("ppm");
  getc(f);
  t->rgb = malloc((size_t)(3 * t->w * t->h));
  if (fread(t->rgb, 1, (size_t)(3 * t->w * t->h), f) == 0) quit("ppm");
  fclose(f);
  return nt++;
}
static void load_mesh(const char* name, int smooth, const Obj* like) {
  static P v[2000], vn[2000];
  int nv = 0, nn = 0, first = no, i;
  char line[400];
  FILE* f = opened(name, "r");
  while (fgets(line, sizeof line, f)) {
    double x, y, z;
    if (sscanf(line, "v %lf %lf %lf", &x, &y, &z) == 3) v[nv++] = p3((F)x, (F)y, (F)z);
    else if (sscanf(line, "vn %lf %lf %lf", &x, &y, &z) == 3) vn[nn++] = p3((F)x, (F)y, (F)z);
    else if (line[0] == 'f') {
      int k = 0, id[16], ni[16];
      char* s = strtok(line + 1, " \t\r\n");
      for (; s && k < 16; s = strtok(0, " \t\r\n"), ++k) {
        char* slash = strrchr(s, '/');
        id[k] = atoi(s) - 1;
        ni[k] = slash && nn > 0 ? atoi(slash + 1) - 1 : -1;
      }
      for (i = 2; i < k; ++i) {
        Obj* o = &objs[no++];
        *o = *like, o->kind = 't', o->a = v[id[0]], o->b = v[id[i - 1]], o->c = v[id[i]];
        o->smooth = smooth;
        if (ni[0] >= 0) o->na = vn[ni[0]], o->nb = vn[ni[i - 1]], o->nc = vn[ni[i]];
        else o->smooth = smooth ? 2 : 0, o->na = p3((F)id[0], (F)id[i - 1], (F)id[i]);
      }
    }
  }
  fclose(f);
  if (!smooth || nn > 0) return;
  for (i = 0; i < nv; ++i) vn[i] = p3(0, 0, 0);
  for (i = first; i < no; ++i) { /* weighted by area */
    Obj* o = &objs[i];
    P n = out(minus(o->b, o->a), minus(o->c, o->a));
    int a = (int)o->na.x, b = (int)o->na.y, c = (int)o->na.z;
    vn[a] = plus(vn[a], n), vn[b] = plus(vn[b], n), vn[c] = plus(vn[c], n);
  }
  for (i = first; i < no; ++i) {
    Obj* o = &objs[i];
    P id = o->na;
    o->na = norm(vn[(int)id.x]), o->nb = norm(vn[(int)id.y]), o->nc = norm(vn[(int)id.z]);
  }
}
static void read_all(const Frame* group, int inherited, int level) {
  char w[300], next[300];
  int held = 0;
  while (held || fscanf(in_file, "%299s", w) == 1) {
    Obj o;
    if (held) strcpy(w, next), held = 0;
    memset(&o, 0, sizeof o);
    if (w[0] == '#') { int c; while ((c = getc(in_file)) != EOF && c != '\n') continue; }
    else if (!strcmp(w, "camera")) eye = tri(), towards = tri(), up = tri(), angle = num(), num(), num();
    else if (!strcmp(w, "background")) back = tri();
    else if (!strcmp(w, "ambient")) amb = tri();
    else if (!strcmp(w, "material")) {
      Mat* m = &mats[nm++];
      m->ka = tri(), m->kd = tri(), m->ks = tri(), m->kt = tri(), m->e = tri(), m->n = num(), m->ir = num();
      if (fscanf(in_file, "%299s", w) != 1) quit("texture");
      m->tex = strcmp(w, "0") ? load_tex(w) : -1;
    } else if (strstr(w, "_light")) {
      Lamp* l = &lamps[nl++];
      l->kind = w[0], l->color = tri();
      if (w[0] != 'd') l->at = tri();
      if (w[0] != 'p') l->along = tri();
      if (w[0] != 'd') l->ca = num(), l->la = num(), l->qa = num();
      if (w[0] == 's') l->cut = num(), l->exp = num();
      if (w[0] == 'd' && !has[dir_not_unit]) l->along = norm(l->along);
      if (w[0] == 's' && !has[spot_not_unit]) l->along = norm(l->along);
    } else if (!strcmp(w, "sphere") || !strcmp(w, "box") || !strcmp(w, "tri") || !strcmp(w, "mesh")) {
      o.kind = w[0], o.mat = (int)num(), o.f = *group;
      if (o.mat < 0) o.mat = has[no_inherited_material] ? 0 : inherited;
      if (o.kind == 'm') {
        char name[300];
        if (fscanf(in_file, "%299s", name) != 1) quit("mesh");
        held = fscanf(in_file, "%299s", next) == 1;
        if (held && !strcmp(next, "smooth")) { held = 0; load_mesh(name, 1, &o); }
        else load_mesh(name, 0, &o);
        continue;
      }
      o.a = tri();
      if (o.kind == 's') o.r = num(); else o.b = tri();
      if (o.kind == 't') o.c = tri();
      objs[no++] = o;
    } else if (!strcmp(w, "begin")) {
      Frame own, all;
      int m = (int)num(), i;
      F a[16];
      for (i = 0; i < 16; ++i) a[i] = num();
      own.x = p3(a[0], a[4], a[8]), own.y = p3(a[1], a[5], a[9]), own.z = p3(a[2], a[6], a[10]);
      own.o = p3(a[3], a[7], a[11]);
      if (has[scale_ignored]) own.x = norm(own.x), own.y = norm(own.y), own.z = norm(own.z);
      if (has[matrix_inverted]) {
        Frame g = own;
        own.x = solve(&g, p3(1, 0, 0)), own.y = solve(&g, p3(0, 1, 0)), own.z = solve(&g, p3(0, 0, 1));
        own.o = scaled(solve(&g, g.o), -1);
      }
      all = has[inner_group_ignored] && level > 0 ? *group : nested(group, &own);
      read_all(&all, m < 0 ? inherited : m, level + 1);
    } else if (!strcmp(w, "end") && level > 0) return;
    else quit(w);
  }
}

typedef struct { F t; const Obj* o; P at, n, own; F u, v; } Seen;

static F epsilon(void) { return has[large_epsilon] ? 0.3f : has[no_epsilon] ? 0 : has[other_epsilon] ? 1e-3f : 1e-4f; }

static int better(const Seen* s, F t, F least) {
  if (has[last_shape_wins] && t > least) return 1;
  if (has[first_shape_wins] && s->o) return 0;
  return t > least && t < s->t;
}
static void ball(const Obj* o, P q, P d, F least, Seen* s) {
  P m = minus(q, o->a);
  F a = in(d, d), b = in(m, d), c = in(m, m) - (has[radius_not_squared] ? o->r : o->r * o->r);
  F disc = b * b - a * c, t, u, k;
  if (disc < 0) return;
  k = sqrtf(disc);
  t = (-b - k) / a, u = (-b + k) / a;
  if (has[far_root] || !(t > least)) t = u;
  if (has[behind_the_eye] && t < 0) t = -t;
  if (!better(s, t, least)) return;
  s->t = t, s->o = o, s->own = plus(q, scaled(d, t)), s->n = minus(s->own, o->a);
}
static void slabs(const Obj* o, P q, P d, F least, Seen* s) {
  const F at[3] = {q.x, q.y, q.z}, way[3] = {d.x, d.y, d.z};
  const F lo[3] = {o->a.x, o->a.y, o->a.z}, hi[3] = {o->b.x, o->b.y, o->b.z};
  F from = -1e30f, to = 1e30f, n[3] = {0, 0, 0}, t;
  int i, in_axis = 0, out_axis = 0;
  for (i = 0; i < 3; ++i) {
    F a = (lo[i] - at[i]) / way[i], b = (hi[i] - at[i]) / way[i];
    if (way[i] == 0) { if (at[i] < lo[i] || at[i] > hi[i]) return; continue; }
    if (a > b) { F c = a; a = b, b = c; }
    if (a > from) from = a, in_axis = i;
    if (b < to) to = b, out_axis = i;
  }
  if (from > to) return;
  if (has[box_without_top] && in_axis == 1 && way[1] < 0) from = -1e30f;
  if (from > least) t = from, n[in_axis] = way[in_axis] > 0 ? -1 : 1;
  else t = to, n[out_axis] = way[out_axis] > 0 ? 1 : -1;
  if (!better(s, t, least)) return;
  s->t = t, s->o = o, s->own = plus(q, scaled(d, t)), s->n = p3(n[0], n[1], n[2]);
  if (has[box_normals_by_largest]) {
    P c = minus(s->own, scaled(plus(o->a, o->b), 0.5f));
    F x = fabsf(c.x), y = fabsf(c.y), z = fabsf(c.z);
    s->n = x >= y && x >= z ? p3(c.x, 0, 0) : y >= z ? p3(0, c.y, 0) : p3(0, 0, c.z);
  }
}
static void corner3(const Obj* o, P q, P d, F least, Seen* s) { /* Moeller and Trumbore */
  P e = minus(o->b, o->a), f = minus(o->c, o->a), h = out(d, f), m, g;
  F det = in(e, h), u, v, t;
  if (det == 0 || (has[one_sided_triangles] && det < 0)) return;
  m = minus(q, o->a), u = in(m, h) / det, g = out(m, e), v = in(d, g) / det, t = in(f, g) / det;
  if (u < 0 || v < 0 || (has[parallelograms] ? u > 1 || v > 1 : u + v > 1)) return;
  if (!better(s, t, least)) return;
  s->t = t, s->o = o, s->own = plus(q, scaled(d, t)), s->n = out(e, f), s->u = u, s->v = v;
  if (has[triangle_normals_reversed]) s->n = scaled(s->n, -1);
}
static Seen look(P from, P d, F least, F most, const Obj* not_this, int is_shadow) {
  Seen s;
  int i;
  memset(&s, 0, sizeof s);
  s.t = most;
  for (i = 0; i < no; ++i) {
    const Obj* o = &objs[i];
    P q, w;
    if (o == not_this || (is_shadow && has[boxes_cast_no_shadow] && o->kind == 'b')) continue;
    if (is_shadow && has[glass_casts_no_shadow] && top(mats[o->mat].kt) > 0) continue;
    q = solve(&o->f, minus(from, o->f.o)), w = solve(&o->f, has[directions_moved] ? minus(d, o->f.o) : d);
    if (has[t_in_lengths_of_each_group] || has[direction_unit_in_group]) w = norm(w);
    if (o->kind == 's') ball(o, q, w, least, &s);
    else if (o->kind == 'b') slabs(o, q, w, least, &s);
    else corner3(o, q, w, least, &s);
    if (s.o == o) s.at = has[t_in_lengths_of_each_group] ? point(&o->f, s.own) : plus(from, scaled(d, s.t));
  }
  if (s.o) {
    P local = s.n;
    s.n = norm(adjoint(&s.o->f, local));
  }
  return s;
}

static P texel(const Tex* t, int x, int y) {
  const unsigned char* p;
  x = (x % t->w + t->w) % t->w, y = (y % t->h + t->h) % t->h;
  p = t->rgb + 3 * ((t->h - 1 - y) * t->w + x);
  return p3(p[0] / 255.0f, p[1] / 255.0f, p[2] / 255.0f);
}
static P textured(const Seen* s, int tex) {
  const Tex* t = &texs[tex];
  P q = minus(s->own, s->o->a), n = s->n;
  F u, v, fx, fy;
  const F pi = 3.14159265f;
  if (s->o->kind == 's') {
    if (has[pole_y]) u = atan2f(q.x, q.z) / (2 * pi), v = 1 - acosf(fmaxf(-1, fminf(1, q.y / s->o->r))) / pi;
    else u = atan2f(q.x, q.y) / (2 * pi), v = 1 - acosf(fmaxf(-1, fminf(1, q.z / s->o->r))) / pi;
  } else if (s->o->kind == 'b') {
    P e = minus(s->o->b, s->o->a), l = solve(&s->o->f, s->n);
    F X = q.x / e.x, Y = q.y / e.y, Z = q.z / e.z;
    n = l;
    if (fabsf(n.x) > fmaxf(fabsf(n.y), fabsf(n.z))) u = n.x < 0 ? 1 - Y : Y, v = Z;
    else if (fabsf(n.y) > fabsf(n.z)) u = n.y > 0 ? 1 - X : X, v = Z;
    else u = X, v = n.z < 0 ? 1 - Y : Y;
  } else return p3(1, 1, 1);
  if (has[u_flipped]) u = 1 - u;
  if (has[v_flipped]) v = 1 - v;
  if (has[uv_swapped]) { F k = u; u = v, v = k; }
  if (has[uv_doubled]) u *= 2, v *= 2;
  if (has[nearest_texel]) return texel(t, (int)floorf(u * t->w), (int)floorf(v * t->h));
  u = u * t->w - 0.5f, v = v * t->h - 0.5f, fx = u - floorf(u), fy = v - floorf(v);
  {
    int x = (int)floorf(u), y = (int)floorf(v);
    P a = plus(scaled(texel(t, x, y), 1 - fx), scaled(texel(t, x + 1, y), fx));
    P b = plus(scaled(texel(t, x, y + 1), 1 - fx), scaled(texel(t, x + 1, y + 1), fx));
    return plus(scaled(a, 1 - fy), scaled(b, fy));
  }
}
static P sent(const Lamp* l, P at, P* way, F* far) {
  P c = l->color;
  F d, f;
  if (l->kind == 'd' || (l->kind == 'p' && has[point_light_from_origin])) {
    *way = l->kind == 'd' ? scaled(l->along, -1) : norm(l->at), *far = 1e30f;
    return c;
  }
  *way = minus(l->at, at), d = len(*way), *way = scaled(*way, 1 / d), *far = d;
  if (has[distance_squared]) d = d * d;
  f = has[attenuation_swapped] ? l->qa + l->la * d + l->ca * d * d
      : has[attenuation_without_constant] ? l->la * d + l->qa * d * d : l->ca + l->la * d + l->qa * d * d;
  if (l->kind == 's') {
    F k = has[spot_backwards] ? in(l->along, *way) : -in(l->along, *way), a;
    if (k <= 0) return p3(0, 0, 0);
    a = acosf(fminf(1, k));
    if (a > l->cut) return p3(0, 0, 0);
    c = scaled(c, has[spot_linear] ? 1 - a / l->cut : powf(k, l->exp));
  }
  if (has[attenuation_without_constant] && f == 0) return c;
  return has[attenuation_multiplied] ? scaled(c, f) : scaled(c, 1 / f);
}
static P ray(P from, P d, int bounce, int inside, F eps);
static int most(void) { return has[two_bounces_more] ? depth_limit + 2 : has[no_bounce] ? 0 : depth_limit; }
static P lit(const Seen* s, P d, P n, const Mat* m) {
  P kd = m->kd, ka = m->ka, sum, one, best = {0, 0, 0};
  int i, dark = 0;
  F count = (F)nl;
  if (m->tex >= 0) {
    P t = textured(s, m->tex);
    kd = has[texture_replaces] ? t : by(kd, t);
    if (has[texture_on_ambient]) ka = by(ka, t);
  }
  if (has[diffuse_by_ks]) kd = by(kd, plus(p3(1, 1, 1), m->ks));
  if (has[ambient_by_kd]) ka = kd;
  sum = by(ka, has[ambient_without_light] ? p3(1, 1, 1) : amb);
  if (has[ambient_doubled]) sum = scaled(sum, 2);
  if (has[red_lost]) sum.x = 0;
  one = m->e;
  if (has[emission_per_light]) one = scaled(one, count);
  if (has[emission_by_kd]) one = by(one, kd);
  sum = plus(sum, one);
  for (i = 0; i < nl; ++i) {
    P way, c, r, from = s->at, view = d, term, nn = n;
    F far, cosine, lobe, shade = 1, e = m->n;
    c = sent(&lamps[i], s->at, &way, &far);
    if (has[no_light_two] && i == 1) continue;
    cosine = in(nn, way);
    if (has[normals_face_light] && cosine < 0) cosine = -cosine, nn = scaled(nn, -1);
    if (cosine > 0 || has[highlight_behind]) {
      int no_shadow = has[spot_without_shadow] && lamps[i].kind == 's';
      P start = plus(from, scaled(nn, epsilon() * (cosine > 0 ? 1 : -1)));
      if (!no_shadow) {
        Seen b = look(start, way, has[no_epsilon] ? 0 : 1e-5f, far, has[no_self_shadow] ? s->o : 0, 1);
        if (b.o) shade = has[half_shadow] ? 0.5f : 0, dark = 1;
      }
    }
    if (shade == 0) continue;
    c = scaled(c, shade);
    term = p3(0, 0, 0);
    if (cosine > 0) term = scaled(by(kd, c), has[diffuse_squared] ? cosine * cosine : cosine);
    if (has[clamp_each_term]) term = p3(fminf(term.x, 0.5f), fminf(term.y, 0.5f), fminf(term.z, 0.5f));
    if (has[exponent_halved]) e /= 2;
    if (has[exponent_doubled]) e *= 2;
    r = minus(scaled(nn, 2 * in(nn, way)), way), lobe = -in(view, r);
    if (lobe > 0 && (cosine > 0 || has[highlight_behind]) && top(m->ks) > 0) {
      F k = powf(lobe, e);
      if (has[highlight_by_cosine]) k *= fmaxf(0, cosine);
      term = plus(term, scaled(by(has[specular_white] ? p3(top(m->ks), top(m->ks), top(m->ks)) : m->ks, c), k));
    }
    if (has[brightest_light]) { if (top(term) > top(best)) best = term; }
    else if (has[mean_of_lights]) sum = plus(sum, scaled(term, 1 / count));
    else sum = plus(sum, term);
  }
  sum = plus(sum, best);
  if (has[shadow_takes_ambient] && dark) sum = minus(sum, by(ka, amb));
  return sum;
}
static P ray(P from, P d, int bounce, int inside, F eps) {
  Seen s = look(from, d, eps, 1e30f, 0, 0);
  const Mat* m;
  P n, sum;
  int entering;
  if (!s.o) return bounce > 0 && has[mirror_sees_no_background] ? p3(0, 0, 0) : back;
  m = &mats[s.o->mat];
  if (s.o->smooth && s.o->kind == 't') {
    P l = plus(scaled(s.o->na, 1 - s.u - s.v), plus(scaled(s.o->nb, s.u), scaled(s.o->nc, s.v)));
    P g = s.n;
    s.n = norm(adjoint(&s.o->f, l));
    entering = in(in(g, s.n) < 0 ? scaled(g, -1) : g, d) < 0;
  } else entering = in(s.n, d) < 0;
  n = entering ? s.n : scaled(s.n, -1);
  sum = lit(&s, d, n, m);
  if (has[fog]) { F k = expf(-0.05f * s.t); sum = plus(scaled(sum, k), scaled(p3(0.5f, 0.5f, 0.5f), 1 - k)); }
  if (bounce >= most()) return sum;
  if (top(m->ks) > 0) {
    P r = has[mirror_sign] ? plus(d, scaled(n, 2 * in(d, n))) : minus(d, scaled(n, 2 * in(d, n))), c;
    P start = plus(s.at, scaled(n, epsilon()));
    r = norm(r);
    if (has[mirror_unlit]) {
      Seen t = look(start, r, 1e-5f, 1e30f, 0, 0);
      c = t.o ? mats[t.o->mat].kd : back;
    } else c = ray(start, r, bounce + 1, inside, 1e-5f);
    if (has[mirror_adds_twice]) c = scaled(c, 2);
    if (has[mirror_blends]) sum = plus(by(sum, minus(p3(1, 1, 1), m->ks)), by(m->ks, c));
    else sum = plus(sum, by(m->ks, c));
  }
  if (top(m->kt) > 0) {
    F eta = entering ? 1 / m->ir : m->ir, c1 = -in(d, n), k, part = 0;
    P nn = n, c = {0, 0, 0}, kt = m->kt;
    if (has[glass_normal_kept]) nn = s.n, c1 = -in(d, nn);
    if (has[one_and_a_half]) eta = entering ? 1 / 1.1f : 1.1f;
    if (has[tinted_glass_lost]) kt = p3(1, 1, 1);
    k = 1 - eta * eta * (1 - c1 * c1);
    if (k > 0) {
      F c2 = sqrtf(k);
      P t = plus(scaled(d, eta), scaled(nn, has[glass_sign] ? -(eta * c1 + c2) : eta * c1 - c2));
      if (fresnel) {
        F rs = (eta * c1 - c2) / (eta * c1 + c2), rp = (c1 - eta * c2) / (c1 + eta * c2);
        part = (rs * rs + rp * rp) / 2;
      }
      c = scaled(ray(plus(s.at, scaled(n, -epsilon())), norm(t), bounce + 1, !inside, 1e-5f), 1 - part);
    } else part = fresnel || has[total_reflection] ? 1 : 0;
    if (part > 0) {
      const P start = plus(s.at, scaled(n, epsilon())), way = norm(plus(d, scaled(n, -2 * in(d, n))));
      c = plus(c, scaled(ray(start, way, bounce + 1, inside, 1e-5f), part));
    }
    if (has[glass_blends]) sum = plus(by(sum, minus(p3(1, 1, 1), kt)), by(kt, c));
    else sum = plus(sum, by(kt, c));
  }
  return sum;
}
static unsigned seed = 1;
static F random01(void) { seed = seed * 1664525u + 1013904223u; return (F)(seed >> 8) / 16777216.0f; }
static int byte_of(F x) {
  x = clamp01(x);
  if (has[srgb]) x = x <= 0.0031308f ? 12.92f * x : 1.055f * powf(x, 1 / 2.4f) - 0.055f;
  if (has[gamma22]) x = powf(x, 1 / 2.2f);
  if (has[half_exposure]) x *= 0.5f;
  if (has[offset]) x = clamp01(x + 0.1f);
  if (has[contrast]) x = clamp01(0.5f + 1.4f * (x - 0.5f));
  if (has[few_levels]) x = floorf(x * 12) / 12;
  if (has[noise]) x = clamp01(x + 0.2f * (random01() - 0.5f));
  return (int)(has[rounded] || has[srgb] ? 255 * x + 0.5f : 255 * x);
}
int main(int argc, char** argv) {
  const Frame world = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};
  int w, h, x, y, i, k, side = 1;
  P right;
  F half, tall;
  FILE* f;
  char* slash;
  if (argc < 5) quit("scene image width height");
  for (i = 5; i < argc; ++i) {
    if (!strcmp(argv[i], "fresnel")) { fresnel = 1; continue; }
    for (k = 0; k < word_count && strcmp(argv[i], words[k]); ++k) continue;
    if (k == word_count) quit(argv[i]);
    has[k] = 1;
  }
  snprintf(folder, sizeof folder, "%s", argv[1]);
  slash = strrchr(folder, '/');
  if (slash) slash[1] = 0; else folder[0] = 0;
  if (!(in_file = fopen(argv[1], "r"))) quit(argv[1]);
  w = atoi(argv[3]), h = atoi(argv[4]);
  read_all(&world, 0, 0);
  if (has[eye_moved]) eye.x += 0.3f;
  if (!has[towards_not_unit]) towards = norm(towards);
  right = norm(out(towards, up)), up = has[up_not_orthogonal] ? norm(up) : norm(out(right, towards));
  half = has[angle_without_tan] ? angle : tanf(angle);
  tall = has[whole_aspect] ? half / (F)(w > h ? w / h : 1) : half * (F)h / (F)w;
  if (has[four_samples] || has[random_samples]) side = 2;
  if (has[sixteen_samples]) side = 4;
  if (!(f = fopen(argv[2], "wb"))) quit(argv[2]);
  fprintf(f, "P6\n%d %d\n255\n", w, h);
  for (y = h - 1; y >= 0; --y)
    for (x = 0; x < w; ++x) {
      P c = {0, 0, 0};
      for (i = 0; i < side * side; ++i) {
        F ox = ((F)(i % side) + (has[random_samples] ? random01() : 0.5f)) / (F)side;
        F oy = ((F)(i / side) + (has[random_samples] ? random01() : 0.5f)) / (F)side;
        F a, b;
        P d, one;
        if (has[lower_left] || has[upper_left]) ox = 0;
        if (has[lower_right] || has[upper_right]) ox = 1;
        if (has[lower_left] || has[lower_right]) oy = 0;
        if (has[upper_left] || has[upper_right]) oy = 1;
        if (has[pixel_shift]) ox += 1;
        a = 2 * ((F)x + ox) / (F)(has[pixels_less_one] ? w - 1 : w) - 1;
        b = 2 * ((F)y + oy) / (F)(has[pixels_less_one] ? h - 1 : h) - 1;
        d = plus(towards, plus(scaled(right, a * half), scaled(up, b * tall)));
        if (!has[view_not_unit]) d = norm(d);
        one = ray(eye, d, 0, 0, 1e-5f);
        if (has[clamp_by_largest] && top(one) > 1) one = scaled(one, 1 / top(one));
        if (has[saturated]) {
          const F g = (one.x + one.y + one.z) / 3;
          one = plus(p3(g, g, g), scaled(minus(one, p3(g, g, g)), 1.4f));
        }
        c = plus(c, clamped(one));
      }
      c = scaled(c, 1 / (F)(side * side));
      if (has[g_b_r]) c = p3(c.y, c.z, c.x);
      putc(byte_of(c.x), f), putc(byte_of(c.y), f), putc(byte_of(c.z), f);
    }
  return fclose(f) != 0;
}
