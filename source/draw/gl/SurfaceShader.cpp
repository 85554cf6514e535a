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
void main() { gl_Position = clip_from_drawing * vec4(at, 1); }
)";

// A triangle over the whole viewport.
constexpr const char* sky_vertex_shader = R"(
uniform vec3 directions[3];  // to the lower left corner; from there to the right edge, and to the upper one
out vec3 direction;
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 2 : 0, gl_VertexID == 2 ? 2 : 0);
  direction = directions[0] + corner.x * directions[1] + corner.y * directions[2];
  gl_Position = vec4(2.0 * corner - 1.0, 0, 1);
}
)";

// Returns the radiance from a direction. Environment::Radiance defines the orientation of the map.
constexpr const char* environment = R"(
const float pi = 3.14159265;
uniform sampler2D environment;
vec3 Seen(vec3 direction) {
  vec3 d = normalize(direction);
  vec2 at = vec2(atan(d.x, -d.z) / (2.0 * pi), asin(clamp(d.y, -1.0, 1.0)) / pi) + 0.5;
  float texel = pi / float(textureSize(environment, 0).y), spread = max(length(dFdx(d)), length(dFdy(d)));
  return textureLod(environment, at, log2(max(spread / texel, 1e-6))).rgb;
}
)";

constexpr const char* background = R"(
uniform vec3 background;
vec3 Seen(vec3 direction) { return background; }
)";

constexpr const char* screen = R"(
uniform float exposure;
uniform int srgb;
// R2::EncodeSrgb; the conversion to bytes clamps to 0..1.
vec3 Shown(vec3 light) {
  vec3 c = clamp(exposure * light, 0.0, 1.0);
  if (srgb == 0) return c;
  return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}
)";

constexpr const char* sky = R"(
in vec3 direction;
out vec4 color;
void main() { color = vec4(Shown(Seen(direction)), 1); }
)";

// The light of a PreviewLight, and whether it arrives: the surfaces in its view before the point, if that is in view.
constexpr const char* lights = R"(
struct Light {
  vec4 color;      // and the exponent
  vec4 place;      // and 1 if it is infinitely far
  vec4 direction;  // and the least cosine
  vec4 falloff;    // constant, linear, quadratic
};
layout(std140) uniform Lights { Light lights[8]; };
uniform int light_count;

// Sets L to the unit vector towards the light.
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
#ifdef SHADOWS
uniform sampler2DArrayShadow shadow_maps;
uniform mat4 shadow_views[2];
uniform int shadow_count;
const float off_surface = 4e-3;  // of the distance: about two texels of a map
float Unshadowed(int i, vec3 at, vec3 normal) {
  float distance = lights[i].place.w > 0.0 ? 1.0 : length(at - lights[i].place.xyz);
  vec4 seen = shadow_views[i] * vec4(at + off_surface * distance * normal, 1);
  vec3 place = 0.5 * seen.xyz / seen.w + 0.5;
  if (seen.w <= 0.0 || any(lessThan(place.xy, vec2(0))) || any(greaterThan(place.xy, vec2(1)))) return 1.0;
  return texture(shadow_maps, vec4(place.xy, i, clamp(place.z, 0.0, 1.0)));
}
#endif
)";

// The surface equation with Phong's highlight; see PhongReflection of the tracer.
constexpr const char* shading = R"(
in vec3 position, outward, vertex_color;
in vec2 place;
uniform vec3 eye, around;
uniform vec3 emission, ambient, kd, ks, kr, kt;
uniform float exponent, rim;
uniform sampler2D paint;
uniform int has_colors, is_painted, is_ambient_painted;
layout(location = 0, index = 0) out vec4 color;
layout(location = 0, index = 1) out vec4 behind;  // visibility of the background
void main() {
  vec3 V = normalize(eye - position);
  // At the outline of a mesh, pixels show the back of a triangle whose interpolated normal faces the viewer.
  bool is_front = gl_FrontFacing || dot(outward, V) > 0.0;
  vec3 front = normalize(outward), N = is_front ? front : -front;
  vec3 painted = vec3(1);
#ifdef TEXTURES
  if (has_colors != 0) painted = vertex_color;
  if (is_painted != 0) painted *= texture(paint, place).rgb;
#endif
  vec3 diffuse = kd * painted;
  vec3 sum = emission + (is_ambient_painted != 0 ? painted : vec3(1)) * ambient + diffuse * around;
  for (int i = 0; i < light_count; ++i) {
    vec3 L, arriving = Irradiance(lights[i], position, L);
    float cosine = dot(N, L), in_lobe = dot(V, 2.0 * cosine * N - L);
    vec3 scattered = cosine > 0.0 ? cosine * diffuse + (in_lobe > 0.0 ? pow(in_lobe, exponent) * ks : vec3(0)) : vec3(0);
#ifdef SHADOWS
    if (i < shadow_count) arriving *= Unshadowed(i, position, N);
#endif
    sum += arriving * scattered;
  }
#ifdef MIRRORS
  sum += kr * Seen(reflect(-V, N));
  // Mirrors and glass that show nothing are visible by their rim.
  sum += max(rim - max(sum.r, max(sum.g, sum.b)), 0.0) * pow(1.0 - clamp(dot(N, V), 0.0, 1.0), 3.0);
#endif
  color = vec4(Shown(sum), 1);
  behind = vec4(kt, 0);
}
)";

}  // namespace

std::string SurfaceVertexShader() { return std::string(version) + vertex_shader; }

std::string SurfaceFragmentShader(const SurfaceFeatures& features) {
  std::string text = version;
  if (features.textures) text += "#define TEXTURES\n";
  if (features.mirrors) text += "#define MIRRORS\n";
  if (features.shadows) text += "#define SHADOWS\n";
  return text + screen + (features.environment ? environment : background) + lights + shading;
}

std::string DepthVertexShader() { return std::string(version) + depth_vertex_shader; }
std::string DepthFragmentShader() { return std::string(version) + "void main() {}\n"; }
std::string SkyVertexShader() { return std::string(version) + sky_vertex_shader; }
std::string SkyFragmentShader() { return std::string(version) + screen + environment + sky; }

}  // namespace ray
