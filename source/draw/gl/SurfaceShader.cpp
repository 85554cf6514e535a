#include "source/draw/gl/SurfaceShader.h"

namespace ray {
namespace {

constexpr const char* version = "#version 330 core\n";

constexpr const char* vertex_shader = R"(
layout(location = 0) in vec3 at;
layout(location = 1) in vec4 normal;
layout(location = 2) in vec2 uv;
layout(location = 3) in vec3 color;
uniform mat4 clip_from_drawing;
invariant gl_Position;  // depths drawn before are those drawn now
uniform vec2 texture_scale;
out vec3 position, outward, vertex_color;
out vec2 place;  // on the texture
void main() {
  gl_Position = clip_from_drawing * vec4(at, 1);
  position = at, outward = normal.xyz;
  place = texture_scale * uv, vertex_color = color;
}
)";

constexpr const char* depth_vertex_shader = R"(
layout(location = 0) in vec3 at;
uniform mat4 clip_from_drawing;
invariant gl_Position;
void main() { gl_Position = clip_from_drawing * vec4(at, 1); }
)";

// A triangle over all of the viewport.
constexpr const char* sky_vertex_shader = R"(
uniform vec3 directions[3];  // towards the lower left corner; from there to the right edge; and to the upper one
out vec3 direction;
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 2 : 0, gl_VertexID == 2 ? 2 : 0);
  direction = directions[0] + corner.x * directions[1] + corner.y * directions[2];
  gl_Position = vec4(2.0 * corner - 1.0, 0, 1);
}
)";

// What comes from a direction. Environment::Radiance says how the map lies; `spread` is the angle that is seen at once,
// in radians, and picks the level of the map whose texels are as large.
constexpr const char* environment = R"(
const float pi = 3.14159265;
uniform sampler2D environment;
vec3 Seen(vec3 direction, float spread) {
  vec3 d = normalize(direction);
  vec2 at = vec2(atan(d.x, -d.z) / (2.0 * pi), asin(clamp(d.y, -1.0, 1.0)) / pi) + 0.5;
  float texel = pi / float(textureSize(environment, 0).y);
  return textureLod(environment, at, log2(max(spread / texel, 1e-6))).rgb;
}
)";

constexpr const char* background = R"(
uniform vec3 background;
vec3 Seen(vec3 direction, float spread) { return background; }
)";

constexpr const char* screen = R"(
uniform float exposure;
uniform int srgb;
uniform int for_probe;  // light is kept as it is, with its distance, to be seen in mirrors
// R2::EncodeSrgb; clamping to 0..1 comes with the byte.
vec3 Shown(vec3 light) {
  vec3 c = clamp(exposure * light, 0.0, 1.0);
  if (srgb == 0) return c;
  return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}
)";

constexpr const char* sky = R"(
in vec3 direction;
out vec4 color;
const float endless = 6e4;  // a distance that half precision holds
void main() {
  vec3 d = normalize(direction);
  vec3 light = Seen(d, max(length(dFdx(d)), length(dFdy(d))));
  color = for_probe != 0 ? vec4(light, endless) : vec4(Shown(light), 1);
}
)";

// A light as PreviewLight says it.
constexpr const char* lights = R"(
struct Light {
  vec4 color;      // and the exponent
  vec4 place;      // and 1 where it is infinitely far; of a disc its radius, negative
  vec4 direction;  // and the least cosine
  vec4 falloff;    // constant, linear, quadratic; and where its shadows are, as ShadowViews says
};
layout(std140) uniform Lights { Light lights[64]; };
uniform int light_count;

/// L is set to the unit vector towards the light.
vec3 Irradiance(Light light, vec3 at, out vec3 L) {
  bool is_infinite = light.place.w > 0.0;
  vec3 way = is_infinite ? light.place.xyz : light.place.xyz - at;
  float d = length(way);
  L = way / d;
  if (is_infinite) return light.color.rgb;
  float sum = dot(light.falloff.xyz, vec3(1, d, d * d));
  vec3 arriving = sum > 0.0 ? light.color.rgb / sum : light.color.rgb;
  if (light.direction.w < -1.0) return arriving;
  float cosine = min(-dot(light.direction.xyz, L), 1.0);
  if (!(cosine > 0.0 && cosine >= light.direction.w)) return vec3(0);
  return pow(cosine, light.color.w) * arriving;
}
)";

constexpr const char* material = R"(
in vec3 position;
in vec3 outward;
in vec2 place;
uniform vec3 eye;
uniform vec3 emission, ambient, kd, ks, kr;
uniform vec3 through;  // kt, and what is left of it inside
uniform float exponent, lobe, ir, coat, least_rim;
layout(location = 0, index = 0) out vec4 color;
layout(location = 0, index = 1) out vec4 behind;  // how much of what is behind is seen
// At the outline of a mesh pixels show the back of a triangle whose normal, bent towards those around it, is a front's.
bool IsFront() { return gl_FrontFacing || dot(outward, eye - position) > 0.0; }
)";

constexpr const char* diffuse_light = R"(
uniform vec3 diffuse_light[9];
// DiffuseLight::At
vec3 LightFromAround(vec3 N) {
  vec3 sum = diffuse_light[0] + N.y * diffuse_light[1] + N.z * diffuse_light[2] + N.x * diffuse_light[3];
  sum += N.x * N.y * diffuse_light[4] + N.y * N.z * diffuse_light[5] + (3.0 * N.z * N.z - 1.0) * diffuse_light[6];
  sum += N.x * N.z * diffuse_light[7] + (N.x * N.x - N.y * N.y) * diffuse_light[8];
  return max(sum, 0.0);
}
)";

constexpr const char* textures = R"(
uniform sampler2D paint;
uniform int is_painted, is_ambient_painted;
)";

// The tracer's Bumped: N minus the height's slope over the surface, found from how the texture lies on the screen.
// source: Mikkelsen, Bump mapping unparametrized surfaces on the GPU (2010), eq. 4 and 5, for the gradient
constexpr const char* bumps = R"(
uniform sampler2D relief;
uniform float height;  // 0: no relief
float Rise(vec2 at) { return dot(texture(relief, at).rgb, vec3(0.30, 0.59, 0.11)); }
vec3 Bumped(vec3 N, float side) {
  vec3 along = dFdx(position), upward = dFdy(position);
  vec2 du = dFdx(place), dv = dFdy(place);
  vec2 size = vec2(textureSize(relief, 0));
  // Half a texel, or half a pixel where that is larger.
  vec2 aside = 0.5 * max(1.0 / size, abs(du) + abs(dv));
  vec2 slope = vec2(Rise(place + vec2(aside.x, 0)) - Rise(place - vec2(aside.x, 0)),
                    Rise(place + vec2(0, aside.y)) - Rise(place - vec2(0, aside.y))) / (2.0 * aside);
  vec3 a = cross(upward, N), b = cross(N, along);
  float area = dot(along, a);
  vec3 gradient = area != 0.0 ? (dot(slope, du) * a + dot(slope, dv) * b) / area : vec3(0);
  return normalize(N - side * height * gradient);
}
)";

// The tracer's NormalMapped. Along u, v stays as it is, and the other way round; the sign of the texture's area on the
// screen tells which of both ways.
constexpr const char* normal_maps = R"(
uniform sampler2D normal_map;
uniform int is_mapped;
vec3 NormalMapped(vec3 N, float side) {
  vec3 along = dFdx(position), upward = dFdy(position);
  vec2 du = dFdx(place), dv = dFdy(place);
  float turn = sign(du.x * dv.y - du.y * dv.x);
  vec3 c = texture(normal_map, place).rgb;
  if (turn == 0.0 || c == vec3(0)) return N;
  vec3 along_u = turn * normalize(dv.y * along - du.y * upward);
  vec3 along_v = turn * normalize(du.x * upward - dv.x * along);
  vec3 tilt = 2.0 * c - 1.0;
  vec3 mapped = side * (tilt.r * along_u + tilt.g * along_v) + tilt.b * N;
  return dot(mapped, mapped) > 0.0 ? normalize(mapped) : N;
}
)";

constexpr const char* specular_maps = R"(
uniform sampler2D specular_map;
uniform int is_specular_mapped;
vec3 Specular(vec3 weight) { return is_specular_mapped != 0 ? weight * texture(specular_map, place).rgb : weight; }
)";

constexpr const char* plain_specular = "vec3 Specular(vec3 weight) { return weight; }\n";

// FresnelReflectance and Coat of the tracer.
constexpr const char* fresnel = R"(
float Fresnel(float cosine, float eta) {
  float sine_squared = eta * eta * max(0.0, 1.0 - cosine * cosine);
  if (!(sine_squared < 1.0)) return 1.0;
  float other = sqrt(1.0 - sine_squared);
  float across = (eta * cosine - other) / (eta * cosine + other);
  float along = (cosine - eta * other) / (cosine + eta * other);
  return (across * across + along * along) / 2.0;
}
)";

constexpr const char* coats = R"(
float FifthPower(float x) { return x * x * (x * x) * x; }
float AtNormal() { return pow((coat - 1.0) / (coat + 1.0), 2.0); }
)";

// What a probe sees from the middle of a mirror, as it is seen from a place on the mirror: the ray is followed, in
// steps that grow, to where it goes from before what the probe sees to behind it, and there to the place where both
// meet.
// source: Szirmay-Kalos, Aszodi, Lazanyi, Premecz, Approximate ray-tracing on the GPU with distance impostors (2005)
constexpr const char* probes = R"(
uniform samplerCube probe, probe_depths;  // one map: filtered between its levels, or its largest alone, which is cheaper
uniform int has_probe;
uniform vec3 probe_at;
// How far a place is behind what the probe sees there, as a part of its distance from the probe.
float Behind(vec3 from_probe) { return 1.0 - textureLod(probe_depths, from_probe, 0.0).a / length(from_probe); }
uniform int is_faint;  // mirrors so little that to follow the ray would cost more than it shows
vec3 SeenFrom(vec3 at, vec3 direction, float spread) {
  // What lies further behind what the probe sees than `thickness` is hidden from it, and may be anything.
  const float growth = 1.5, tolerance = 0.003, thickness = 0.06;
  const int halvings = 5;
  vec3 d = normalize(direction), way = at - probe_at;
  float first_step = 0.05 * length(way), end = has_probe != 0 && is_faint == 0 ? min(8.0, 4e3 * first_step) : 0.0;
  float near = 0.0, far = 0.0, t = 0.5 * first_step, found = 0.0;
  bool was_behind = true;
  int left = 0;  // of the halvings between `near` and `far`
  // One lookup in each turn: where shaders are compiled for the processor, all of a loop's body costs, taken or not.
  while (t < end) {
    float behind = Behind(way + t * d);
    bool is_behind = behind > tolerance;
    if (left > 0) {
      if (is_behind) far = t, found = behind; else near = t;
      if (--left == 0 && found < thickness) break;
      is_behind = true;
    } else if (is_behind && !was_behind) {
      far = t, found = behind, left = halvings;
    } else {
      near = far = t;
    }
    was_behind = is_behind;
    t = left > 0 ? 0.5 * (near + far) : growth * far;
  }
  bool guesses = has_probe != 0 && is_faint != 0;
  if (guesses) far = min(textureLod(probe_depths, d, 0.0).a, 8.0);
  if (!guesses && !(t < end)) return Seen(direction, spread);
  float texel = 1.5707963 / float(textureSize(probe, 0).x);
  return textureLod(probe, way + far * d, log2(max(spread / texel, 1e-6))).rgb;
}
)";
constexpr const char* no_probes = R"(
vec3 SeenFrom(vec3 at, vec3 direction, float spread) { return Seen(direction, spread); }
)";

// Bends twice, as a ball does, where the way out is the mirror image of the way in: T turns by the same angle again.
constexpr const char* bending = R"(
uniform int bends;  // else what is behind is seen straight on, by blending
vec3 Bent(vec3 V, vec3 N, bool entering) {
  vec3 T = refract(-V, N, entering ? 1.0 / ir : ir);
  if (T == vec3(0)) return reflect(-V, N);
  if (!entering) return T;
  vec3 out_again = refract(T, -(N - 2.0 * dot(N, T) * T), ir);
  return out_again == vec3(0) ? T : out_again;
}
)";

// How much of a light arrives: what its view has before the point, if that is in view.
constexpr const char* shadows = R"(
uniform sampler2DArrayShadow shadow_maps;
uniform mat4 shadow_views[24];
const float off_surface = 4e-3;  // of the distance: about two texels of a map
float UnshadowedIn(int view, vec3 at) {
  vec4 seen = shadow_views[view] * vec4(at, 1);
  vec3 place = 0.5 * seen.xyz / seen.w + 0.5;
  if (seen.w <= 0.0 || any(lessThan(place.xy, vec2(0))) || any(greaterThan(place.xy, vec2(1)))) return 1.0;
  return texture(shadow_maps, vec4(place.xy, view, clamp(place.z, 0.0, 1.0)));
}
float Unshadowed(Light light, vec3 at, vec3 normal) {
  int code = int(abs(light.falloff.w)), view = code % 64 - 1, places = 1 + code / 64;
  if (view < 0) return 1.0;
  bool is_infinite = light.place.w > 0.0;
  vec3 from = at - light.place.xyz;
  if (light.falloff.w < 0.0) {
    vec3 a = abs(from);
    int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    view += 2 * axis + (from[axis] < 0.0 ? 1 : 0);
  }
  vec3 off = at + off_surface * (is_infinite ? 1.0 : length(from)) * normal;
  float sum = 0.0;
  for (int i = 0; i < places; ++i) sum += UnshadowedIn(view + i, off);
  return sum / float(places);
}
)";

// PhongReflection of one light; `left` is what a coat leaves on the way out.
constexpr const char* reflection = R"(
vec3 highlight;  // ks there
vec3 Diffuse(float cosine, vec3 diffuse, float left) {
  float share = left * cosine;
#ifdef COATS
  if (coat > 0.0) share *= 21.0 / 20.0 * (1.0 - FifthPower(1.0 - min(cosine, 1.0)));
#endif
  return share * diffuse;
}
vec3 Lobe(vec3 N, vec3 V, vec3 L) {
  float in_lobe = dot(V, 2.0 * dot(N, L) * N - L);
  return in_lobe > 0.0 ? pow(in_lobe, exponent) * highlight : vec3(0);
}
vec3 FromPoint(Light light, vec3 N, vec3 V, vec3 diffuse, float left) {
  vec3 L;
  vec3 arriving = Irradiance(light, position, L);
  float cosine = dot(N, L);
  return cosine > 0.0 ? arriving * (Diffuse(cosine, diffuse, left) + Lobe(N, V, L)) : vec3(0);
}
)";

// A disc that shines to one side: diffuse light from seven places on it, highlights from the place nearest to where the
// mirrored ray meets its plane, as much darker as the disc is wider than the lobe.
// source: Abramowitz and Stegun, Handbook of Mathematical Functions (1964), 25.4.61, exact to the fifth degree
//         Karis, Real Shading in Unreal Engine 4 (2013), representative points
constexpr const char* discs = R"(
uniform int disc_count;
const vec2 places[7] = vec2[](vec2(0, 0), vec2(0.81649658, 0), vec2(0.40824829, 0.70710678),
                              vec2(-0.40824829, 0.70710678), vec2(-0.81649658, 0), vec2(-0.40824829, -0.70710678),
                              vec2(0.40824829, -0.70710678));  // but for the first, sqrt(2/3) from the middle
vec3 ArrivingFrom(Light disc, vec3 way, float d) {
  float cosine = max(-dot(disc.direction.xyz, way), 0.0) / d, sum = dot(disc.falloff.xyz, vec3(1, d, d * d));
  return (sum > 0.0 ? cosine / sum : cosine) * disc.color.rgb;
}
vec3 DiffuseFromDisc(Light disc, vec3 N, vec3 diffuse, float left) {
  float radius = -disc.place.w;
  vec3 D = disc.direction.xyz, to_middle = disc.place.xyz - position;
  vec3 across = normalize(cross(D, abs(D.z) < 0.9 ? vec3(0, 0, 1) : vec3(1, 0, 0))), upward = cross(D, across);
  vec3 sum = vec3(0);
  for (int i = 0; i < 7; ++i) {
    vec3 way = to_middle + radius * (places[i].x * across + places[i].y * upward);
    float d = length(way), cosine = dot(N, way) / d;
    if (cosine > 0.0) sum += (i == 0 ? 0.25 : 0.125) * ArrivingFrom(disc, way, d) * Diffuse(cosine, diffuse, left);
  }
  return sum;
}
vec3 HighlightOfDisc(Light disc, vec3 N, vec3 V) {
  float radius = -disc.place.w;
  vec3 D = disc.direction.xyz, to_middle = disc.place.xyz - position, R = reflect(-V, N), way = to_middle;
  float t = dot(to_middle, D) / dot(R, D);
  if (t > 0.0) {
    vec3 aside = t * R - to_middle;
    way += aside * min(1.0, radius / max(length(aside), 1e-6 * radius));
  }
  float d = length(way);
  if (highlight == vec3(0) || !(dot(N, way) > 0.0)) return vec3(0);
  // Both as solid angles: the disc's, and 2 pi / (n + 1) of the lobe cos^n.
  float square = dot(to_middle, to_middle);
  float seen = 3.14159265 * radius * radius * max(-dot(D, to_middle), 0.0) / (square * sqrt(square));
  return ArrivingFrom(disc, way, d) * Lobe(N, V, way / d) / (1.0 + seen * (exponent + 1.0) / (2.0 * 3.14159265));
}
)";

// Discs come first: what is not taken of a branch costs as much where shaders are compiled for the processor.
constexpr const char* all_lights = R"(
vec3 Shadowed(vec3 arriving, Light light) {
#ifdef SHADOWS
  if (arriving != vec3(0)) arriving *= Unshadowed(light, position, (IsFront() ? 1.0 : -1.0) * normalize(outward));
#endif
  return arriving;
}
vec3 FromLights(vec3 N, vec3 V, vec3 diffuse, float left) {
  vec3 sum = vec3(0);
  int i = 0;
#ifdef DISCS
  for (; i < disc_count; ++i)
    sum += Shadowed(DiffuseFromDisc(lights[i], N, diffuse, left) + HighlightOfDisc(lights[i], N, V), lights[i]);
#endif
  for (; i < light_count; ++i) sum += Shadowed(FromPoint(lights[i], N, V, diffuse, left), lights[i]);
  return sum;
}
)";

// The surface equation; see SpecularWeightsOf and Whitted.
constexpr const char* shading = R"(
void main() {
  vec3 V = normalize(eye - position);
  bool entering = IsFront();
  float side = entering ? 1.0 : -1.0;
  vec3 N = side * normalize(outward);
#ifdef NORMAL_MAPS
  if (is_mapped != 0) N = NormalMapped(N, side);
#endif
#ifdef BUMPS
  if (height != 0.0) N = Bumped(N, side);
#endif
  float towards_eye = clamp(dot(N, V), 0.0, 1.0);
  vec3 diffuse = kd, sum = emission, mirrored = Specular(kr), transmitted = through;
  highlight = Specular(ks);
#ifdef TEXTURES
  vec3 painted = is_painted != 0 ? texture(paint, place).rgb : vec3(1);
#ifdef VERTEX_COLORS
  painted *= vertex_color;
#endif
  diffuse *= painted;
  sum += (is_ambient_painted != 0 ? painted : vec3(1)) * ambient;
#else
  sum += ambient;
#endif
  float left_by_coat = 1.0;
#ifdef COATS
  if (coat > 0.0) {
    left_by_coat = (1.0 - AtNormal()) * (1.0 - FifthPower(1.0 - towards_eye));
    mirrored += AtNormal() + (1.0 - AtNormal()) * FifthPower(1.0 - towards_eye);
  }
#endif
#ifdef FRESNEL
  if (ir != 1.0 && coat == 0.0) {
    float share = Fresnel(towards_eye, entering ? 1.0 / ir : ir);
    mirrored += share * transmitted;
    transmitted *= 1.0 - share;
  }
#endif
  sum += FromLights(N, V, diffuse, left_by_coat);
#ifdef DIFFUSE_LIGHT
  sum += left_by_coat * diffuse * LightFromAround(N);
#endif
#ifdef MIRRORS
  vec3 R = reflect(-V, N);
  if (mirrored != vec3(0)) sum += mirrored * SeenFrom(position, R, max(lobe, max(length(dFdx(R)), length(dFdy(R)))));
#ifdef BENDING
  if (bends != 0 && transmitted != vec3(0)) {
    vec3 T = Bent(V, N, entering);
    sum += transmitted * SeenFrom(position, T, max(length(dFdx(T)), length(dFdy(T))));
    transmitted = vec3(0);
  }
#endif
  // Mirrors and glass that show nothing are seen by their rim.
  float brightest = max(sum.r, max(sum.g, sum.b));
  sum += max(least_rim - brightest, 0.0) * pow(1.0 - towards_eye, 3.0);
#endif
  color = for_probe != 0 ? vec4(min(sum, 6e4), distance(position, eye)) : vec4(Shown(sum), 1);
  behind = vec4(transmitted, 0);
}
)";

// Modes that show a first surface; see source/integrate/modes.
constexpr const char* first_surface = R"(
void Show(vec3 c) { color = vec4(Shown(c), 1), behind = vec4(0); }
vec3 Painted() {
#ifdef TEXTURES
  if (is_painted != 0) return texture(paint, place).rgb;
#endif
  return vec3(1);
}
vec3 ShadingNormal() {
  float side = IsFront() ? 1.0 : -1.0;
  vec3 N = side * normalize(outward);
#ifdef NORMAL_MAPS
  if (is_mapped != 0) N = NormalMapped(N, side);
#endif
#ifdef BUMPS
  if (height != 0.0) N = Bumped(N, side);
#endif
  return N;
}
)";

constexpr const char* flat_mode = R"(
uniform vec3 flat_painted, flat_plain;
void main() { Show(flat_painted * Painted() + flat_plain); }
)";

constexpr const char* normal_mode = "void main() { Show((ShadingNormal() + 1.0) / 2.0); }\n";
constexpr const char* uv_mode = "void main() { Show(vec3(fract(place), 0)); }\n";
constexpr const char* uv_color_mode = "void main() { Show(vec3(fract(place.x), 0, 1.0 - fract(place.y))); }\n";

constexpr const char* depth_mode = R"(
uniform vec2 depths;  // nearest, farthest
uniform float dimmest;  // of the farthest
void main() {
  float length = depths.y - depths.x;
  float nearness = length > 0.0 ? clamp((depths.y - distance(position, eye)) / length, 0.0, 1.0) : 1.0;
  Show(vec3(mix(dimmest, 1.0, nearness)));
}
)";

// Lights as points, discs at their middle and to the side that they shine to; without shadows.
constexpr const char* lights_as_points = R"(
vec3 ArrivingAt(int i, out vec3 L) {
  vec3 arriving = Irradiance(lights[i], position, L);
#ifdef DISCS
  if (i < disc_count) {
    vec3 way = lights[i].place.xyz - position;
    float d = length(way);
    L = way / d;
    arriving = ArrivingFrom(lights[i], way, d);
  }
#endif
  return arriving;
}
)";

constexpr const char* gooch_mode = R"(
uniform vec4 tones;  // blue, yellow, alpha, beta
void main() {
  vec3 N = ShadingNormal(), V = normalize(eye - position), sum = vec3(0), diffuse = kd * Painted(), L;
  highlight = Specular(ks);
  for (int i = 0; i < light_count; ++i) {
    vec3 arriving = ArrivingAt(i, L), lit = diffuse * arriving;
    float cosine = dot(N, L);
    vec3 cool = vec3(0, 0, tones.x) + tones.z * lit, warm = vec3(tones.y, tones.y, 0) + tones.w * lit;
    sum += (1.0 - cosine) / 2.0 * cool + (1.0 + cosine) / 2.0 * warm;
    if (cosine > 0.0) sum += Lobe(N, V, L) * arriving;
  }
  Show(sum);
}
)";

constexpr const char* toon_mode = R"(
uniform float bands;
void main() {
  vec3 N = ShadingNormal(), V = normalize(eye - position), painted = Painted(), sum = emission, L;
  sum += ambient * painted;
  highlight = Specular(ks);
  for (int i = 0; i < light_count; ++i) {
    vec3 arriving = ArrivingAt(i, L);
    float cosine = dot(N, L), lobe = dot(V, 2.0 * cosine * N - L);
    if (!(cosine > 0.0)) continue;
    float tone = ceil(bands * min(cosine, 1.0)) / bands;
    bool shines = lobe > 0.0 && pow(lobe, exponent) > 0.5;
    sum += (tone * kd * painted + (shines ? highlight : vec3(0))) * arriving;
  }
  Show(sum);
}
)";

/// The main function of a mode; null where it is light's.
const char* MainOf(RenderMode mode) {
  switch (mode) {
    case RenderMode::flat:
    case RenderMode::albedo:
      return flat_mode;
    case RenderMode::normal:
    case RenderMode::normal_color:
      return normal_mode;
    case RenderMode::uv:
      return uv_mode;
    case RenderMode::uv_color:
      return uv_color_mode;
    case RenderMode::zbuffer:
    case RenderMode::depth:
      return depth_mode;
    case RenderMode::gooch:
      return gooch_mode;
    case RenderMode::toon:
      return toon_mode;
    case RenderMode::whitted:
    case RenderMode::path:
    case RenderMode::heat:
    case RenderMode::rays:
    case RenderMode::id:
    case RenderMode::hatching:
      break;
  }
  return nullptr;
}

}  // namespace

std::string SurfaceVertexShader() { return std::string(version) + vertex_shader; }

std::string SurfaceFragmentShader(const SurfaceFeatures& features) {
  std::string text = version;
  const auto add = [&text](bool has, const char* name, const char* part) {
    if (has) text += std::string("#define ") + name + "\n" + part;
  };
  text += material;
  text += screen;
  text += lights;
  add(features.textures, "TEXTURES", textures);
  add(features.vertex_colors, "VERTEX_COLORS", "in vec3 vertex_color;\n");
  add(features.bumps, "BUMPS", bumps);
  add(features.normal_maps, "NORMAL_MAPS", normal_maps);
  if (features.specular_maps)
    text += specular_maps;
  else
    text += plain_specular;
  add(features.diffuse_light, "DIFFUSE_LIGHT", diffuse_light);
  add(features.coats, "COATS", coats);
  add(features.fresnel, "FRESNEL", fresnel);
  add(features.shadows, "SHADOWS", shadows);
  add(features.clear && features.mirrors, "BENDING", bending);
  text += reflection;
  add(features.discs, "DISCS", discs);
  if (const char* main = MainOf(features.mode)) return text + lights_as_points + first_surface + main;
  add(features.mirrors, "MIRRORS", features.environment ? environment : background);
  if (features.mirrors) text += features.probes ? probes : no_probes;
  return text + all_lights + shading;
}

std::string DepthVertexShader() { return std::string(version) + depth_vertex_shader; }
std::string DepthFragmentShader() { return std::string(version) + "void main() {}\n"; }
std::string SkyVertexShader() { return std::string(version) + sky_vertex_shader; }
std::string SkyFragmentShader() { return std::string(version) + screen + environment + sky; }

}  // namespace ray
