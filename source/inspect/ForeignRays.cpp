#include "source/inspect/ForeignRays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "R1/Elementary.h"
#include "source/draw/CameraMoves.h"
#include "source/integrate/shading/Refract.h"
#include "source/parse/Tokenizer.h"
#include "source/text/Number.h"
#include "source/text/NumberText.h"
#include "source/text/Suggestion.h"

namespace ray {
namespace {

std::optional<RayKind> KindNamed(std::string_view word) {
  static constexpr std::array<std::pair<std::string_view, RayKind>, 5> others{{{"primary", RayKind::camera},
                                                                               {"light", RayKind::shadow},
                                                                               {"reflected", RayKind::reflection},
                                                                               {"refraction", RayKind::transmission},
                                                                               {"transmitted", RayKind::transmission}}};
  for (std::size_t i = 0; i < ray_kind_names.size(); ++i)
    if (word == ray_kind_names[i]) return static_cast<RayKind>(i);
  for (const auto& [name, kind] : others)
    if (word == name) return kind;
  return {};
}

std::string Name(RayKind kind) { return ray_kind_names[static_cast<std::size_t>(kind)]; }

/// Reads lines of rays, or an .obj file of lines; every mistake is kept, and its line is ignored.
class Reader {
 public:
  explicit Reader(const Text& text) : text_(text), tokens_(text, Tokenizer::Comments::hash) {}

  ForeignRays Read() {
    while (const auto word = tokens_.Next()) {
      try {
        ReadLine(*word);
      } catch (const SceneError& error) {
        errors_.push_back(error);
      }
      tokens_.SkipLine(word->line);
    }
    if (!errors_.empty()) throw SceneErrors(errors_);
    return std::move(read_);
  }

 private:
  void ReadLine(const Token& word) {
    line_ = word;
    if (const auto kind = KindNamed(word.text)) {
      const R3::Point from = Place();
      return read_.rays.push_back({*kind, from, Place()});
    }
    if (word.text == "pixel") {
      const int column = Whole();
      read_.pixel = ForeignPixel{column, Whole()};
      return;
    }
    if (word.text == "v") return vertices_.push_back(Place());
    if (word.text == "g" || word.text == "o") {
      if (const auto kind = KindNamed(Next("a kind of rays").text)) kind_ = *kind;
      return;
    }
    if (word.text != "l") {
      const std::vector<std::string_view> kinds(ray_kind_names.begin(), ray_kind_names.end());
      throw ErrorAt(text_, word, Quoted(word.text) + " is no kind of ray", Suggestion(word.text, kinds, "kinds"));
    }
    const R3::Point from = Vertex();
    read_.rays.push_back({kind_, from, Vertex()});
  }
  Token Next(const char* what) {
    const auto& next = tokens_.Peek();
    if (!next || next->line != line_.line) throw ErrorAt(text_, line_, std::string(what) + " is missing");
    return *tokens_.Next();
  }
  double Number() {
    const Token word = Next("a coordinate");
    const auto number = ParseNumber(word.text);
    if (number.problem) throw ErrorAt(text_, word, std::string("a coordinate ") + number.problem);
    return number.value;
  }
  int Whole() {
    const Token word = Next("a column or row");
    const auto number = ParseWhole(word.text);
    if (number.problem || number.value < 0 || number.value > most_pixels)
      throw ErrorAt(text_, word, Quoted(word.text) + " is no column or row");
    return static_cast<int>(number.value);
  }
  R3::Point Place() {
    const double x = Number(), y = Number();
    return {x, y, Number()};
  }
  R3::Point Vertex() {
    const Token word = Next("a vertex");
    const auto number = ParseWhole(word.text.substr(0, word.text.find('/')));
    const auto count = static_cast<std::int64_t>(vertices_.size());
    const std::int64_t index = number.value < 0 ? count + number.value : number.value - 1;
    if (number.problem || index < 0 || index >= count)
      throw ErrorAt(text_, word, "there is no vertex " + std::string(word.text) + " before this line");
    return vertices_[static_cast<std::size_t>(index)];
  }

  static constexpr std::int64_t most_pixels = 1 << 28;

  const Text& text_;
  Tokenizer tokens_;
  Token line_;
  RayKind kind_ = RayKind::camera;
  std::vector<R3::Point> vertices_;
  ForeignRays read_;
  std::vector<SceneError> errors_;
};

/// Returns the angle between two directions; 180 if one of them is 0.
double Degrees(const R3::Vector& a, const R3::Vector& b) {
  if (!(Length(a) > 0 && Length(b) > 0)) return 180;
  // The chord, which is accurate for small angles.
  return 2 * R1::Asin(std::min(1.0, Length(Unit(a) - Unit(b)) / 2)) * 180 / std::numbers::pi;
}

/// A direction that a known mistake leads to.
struct Mistake {
  R3::Vector direction;
  const char* text;
};

/// The first mistake that leads to such a direction; empty for none.
std::string Explained(const R3::Vector& direction, const std::vector<Mistake>& mistakes) {
  for (const Mistake& mistake : mistakes)
    if (Length(mistake.direction) > 0 && Degrees(direction, mistake.direction) <= foreign_degrees)
      return std::string("; ") + mistake.text;
  return {};
}

/// Compares rays, starting from camera rays, with our corresponding ones.
class Comparison {
 public:
  Comparison(const PixelTrace& ours, const PixelTrace& foreign, const World& world, const RenderSettings& settings)
      : ours_(ours), foreign_(foreign), world_(world), settings_(settings) {
    const double radius = world.scene().root.bounds.IsEmpty() ? 1 : world.scene().root.bounds.Radius();
    tolerance_ = foreign_length * (radius > 0 ? radius : 1);
  }

  std::optional<RayDifference> First() {
    struct Pair {
      std::size_t ours, foreign;
    };
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < foreign_.rays.size(); ++i) {
      if (foreign_.rays[i].kind != RayKind::camera) continue;
      if (ours_.rays.empty()) return RayDifference{i, {}, "the camera sees nothing there"};
      if (auto found = CompareCamera(0, i)) return found;
      pairs.push_back({0, i});
      break;  // of several samples, the first
    }
    for (std::size_t next = 0; next < pairs.size(); ++next) {
      const Pair pair = pairs[next];
      if (auto found = CompareEnds(pair.ours, pair.foreign)) return found;
      std::vector<std::size_t> left = Children(ours_, pair.ours);
      for (const std::size_t child : Children(foreign_, pair.foreign)) {
        const RecordedRay& theirs = foreign_.rays[child];
        if (theirs.kind == RayKind::diffuse) continue;
        const auto match = Nearest(left, theirs);
        if (!match && theirs.kind == RayKind::shadow) continue;  // one that cannot matter, such as behind the surface
        if (!match)
          return RayDifference{
              child, {}, Named(theirs) + ": ours sends no such ray from there" + WhyNone(pair.ours, theirs)};
        if (auto found = CompareDirections(*match, child, pair.ours)) return found;
        std::erase(left, *match);
        pairs.push_back({*match, child});
      }
      for (const std::size_t missing : left)
        if (ours_.rays[missing].kind != RayKind::diffuse && Matters(ours_.rays[missing]))
          return RayDifference{pair.foreign, missing, Missing(ours_.rays[missing])};
    }
    return {};
  }

 private:
  static std::vector<std::size_t> Children(const PixelTrace& trace, std::size_t parent) {
    std::vector<std::size_t> children;
    for (std::size_t i = 0; i < trace.rays.size(); ++i)
      if (trace.rays[i].parent == static_cast<int>(parent)) children.push_back(i);
    return children;
  }
  /// Returns true if it may change the image: shadow rays of lights behind the surface need not be traced.
  static bool Matters(const RecordedRay& ray) { return !IsBlack(ray.throughput); }

  static std::string Named(const RecordedRay& ray) {
    return Name(ray.kind) + " ray at depth " + std::to_string(ray.depth) +
           (ray.towards.empty() ? "" : " toward " + ray.towards);
  }
  static std::string Missing(const RecordedRay& ray) { return "a ray is missing: " + Named(ray); }

  /// Returns, of some of our rays, the one of the same kind with the nearest direction.
  std::optional<std::size_t> Nearest(const std::vector<std::size_t>& among, const RecordedRay& theirs) const {
    std::optional<std::size_t> best;
    double least = 361;
    for (const std::size_t i : among) {
      if (ours_.rays[i].kind != theirs.kind) continue;
      const double degrees = Degrees(ours_.rays[i].ray.direction, theirs.ray.direction);
      if (degrees < least) best = i, least = degrees;
    }
    return best;
  }

  std::optional<RayDifference> CompareCamera(std::size_t ours, std::size_t foreign) const {
    const RecordedRay &a = ours_.rays[ours], &b = foreign_.rays[foreign];
    const Camera& camera = settings_.view ? *settings_.view : world_.scene().camera;
    // Whatever place in the pixel it goes through.
    const auto through = [&](double x, double y) {
      return camera.Through(x, y, settings_.width, settings_.height).direction;
    };
    const double pixel = Degrees(through(ours_.column, ours_.row), through(ours_.column + 1, ours_.row + 1));
    if (camera.IsPinhole() && Length(b.ray.origin - camera.eye) > tolerance_)
      return RayDifference{
          foreign, ours,
          "camera ray: it starts " + Rounded(Length(b.ray.origin - camera.eye), 3) + " away from the eye"};
    const double degrees = Degrees(a.ray.direction, b.ray.direction);
    if (degrees <= pixel) return {};
    const double x = ours_.column + 0.5, y = ours_.row + 0.5;
    const double w = settings_.width, h = settings_.height, across = 2 * x / w - 1, upward = 2 * y / h - 1;
    const auto towards = [&](double sideways, double up) {
      return camera.towards + sideways * camera.right + up * camera.up;
    };
    const double half = camera.HalfWidth(), high = camera.HalfHeight(settings_.width, settings_.height);
    const std::vector<Mistake> mistakes{
        {through(w - x, y), "left and right are swapped"},
        {through(x, h - y), "rows count from the other end"},
        {through(w - x, h - y), "the image is turned by half"},
        {towards(across * camera.xfov, upward * camera.xfov * h / w), "the half angle is used without its tangent"},
        {towards(across * R1::Tan(camera.xfov / 2), upward * R1::Tan(camera.xfov / 2) * h / w),
         "the half angle is taken for the whole one"},
        {towards(across * half, upward * half), "the aspect ratio is left out"},
        {towards(across * high, upward * high * h / w), "the horizontal angle is used as the vertical one"},
        {-1.0 * a.ray.direction, "it points backward"}};
    return RayDifference{foreign, ours, Differs(a, degrees) + Explained(b.ray.direction, mistakes)};
  }

  static std::string Differs(const RecordedRay& ray, double degrees) {
    return Named(ray) + ": its direction differs by " + Rounded(degrees, 3) + " degrees";
  }

  std::optional<RayDifference> CompareDirections(std::size_t ours, std::size_t foreign, std::size_t parent) const {
    const RecordedRay &a = ours_.rays[ours], &b = foreign_.rays[foreign], &from = ours_.rays[parent];
    const double degrees = Degrees(a.ray.direction, b.ray.direction);
    if (degrees <= foreign_degrees || !from.at || Length(b.ray.direction) <= tolerance_) return {};
    const R3::Vector d = Unit(from.ray.direction), geometric = AsVector(from.at->normal),
                     shading = AsVector(from.at->shading_normal);
    const auto facing = [&](const R3::Vector& n) { return Dot(n, d) > 0 ? -n : n; };
    const R3::Vector n = facing(shading);
    std::vector<Mistake> mistakes{{-1.0 * a.ray.direction, "it points the opposite way"}};
    if (a.kind == RayKind::shadow) {
      const auto end = a.End();
      if (end) mistakes.push_back({*end - R3::Point{}, "the light's position is used as its direction"});
      mistakes.push_back({shading, "it is the normal"});
    } else {
      const double ir = from.hit ? world_.MaterialAt(*from.hit).ir : 1;
      const double eta = Dot(geometric, d) < 0 ? 1 / ir : ir;  // of the side that the ray comes from over the other
      const R3::Vector mirrored = Reflect(d, n);
      mistakes.push_back({-1.0 * mirrored, "it is the mirrored direction with the wrong sign"});
      mistakes.push_back({mirrored, "it is the mirrored direction"});
      const auto add = [&](const std::optional<R3::Vector>& direction, const char* text) {
        if (direction) mistakes.push_back({*direction, text});
      };
      if (ir > 0 && ir != 1) {
        add(Refract(d, n, eta), "it is the refracted direction");
        add(Refract(d, n, 1 / eta), "it equals refraction with eta inverted");
        // Snell's law as it is usually written, with the cosine of a normal on the far side.
        const double cosine = Dot(d, n), squared = 1 - eta * eta * (1 - cosine * cosine);
        if (squared >= 0)
          mistakes.push_back(
              {eta * d + (eta * cosine - std::sqrt(squared)) * -n, "the normal is not turned to the ray's side"});
      }
      mistakes.push_back({d, "it goes straight on"});
      mistakes.push_back(
          {Reflect(d, geometric), "it is mirrored about the face's own normal instead of the interpolated one"});
      mistakes.push_back({n, "it is the normal"});
      mistakes.push_back({from.at->position - R3::Point{}, "the position is used as the direction"});
      mistakes.push_back({d - Dot(d, n) * n, "the factor 2 of the mirrored direction is missing"});
    }
    return RayDifference{foreign, ours, Differs(a, degrees) + Explained(b.ray.direction, mistakes)};
  }

  std::optional<RayDifference> CompareEnds(std::size_t ours, std::size_t foreign) const {
    const RecordedRay &a = ours_.rays[ours], &b = foreign_.rays[foreign];
    const double theirs = Length(b.ray.direction);
    if (b.kind != RayKind::camera && theirs <= tolerance_ &&
        (!a.End() || Length(*a.End() - a.ray.origin) > 2 * tolerance_))
      return RayDifference{foreign, ours,
                           Named(a) +
                               ": it ends where it starts, on the surface that it leaves; start it "
                               "a little off the surface, or with a small least t"};
    if (a.kind == RayKind::shadow) {
      const bool is_blocked = a.at.has_value();
      const double to_end = is_blocked ? Length(a.at->position - a.ray.origin) : 0;
      if (is_blocked && theirs > to_end + 2 * tolerance_)
        return RayDifference{
            foreign, ours,
            Named(a) + ": ours is blocked after " + Rounded(to_end, 4) + ", this one goes on to " + Rounded(theirs, 4)};
      return {};
    }
    const auto end = a.End();
    if (!end) return {};  // how far a ray to nowhere is drawn says nothing
    const double length = Length(*end - a.ray.origin);
    // A place aside on a surface that is seen at a grazing angle may be farther away.
    if (std::abs(length - theirs) <= 2 * tolerance_ + 0.02 * length) return {};
    return RayDifference{
        foreign, ours,
        Named(a) + ": it ends after " + Rounded(theirs, 4) + ", ours after " + Rounded(length, 4) +
            (theirs < length ? "; it hits something that is not there" : "; it misses what ours hits")};
  }

  /// Returns the reason why ours has no ray of that kind, if it is known.
  std::string WhyNone(std::size_t parent, const RecordedRay& theirs) const {
    const RecordedRay& from = ours_.rays[parent];
    if (!from.hit) return ", since it hits nothing";
    const Material& m = world_.MaterialAt(*from.hit);
    if (from.depth >= settings_.trace.max_depth && theirs.kind != RayKind::shadow)
      return ": its depth is above -max_depth " + std::to_string(settings_.trace.max_depth);
    if (theirs.kind == RayKind::reflection && IsBlack(m.kr)) return ": kr is 0";
    if (theirs.kind == RayKind::transmission && IsBlack(m.kt)) return ": kt is 0";
    return {};
  }

  const PixelTrace &ours_, &foreign_;
  const World& world_;
  const RenderSettings& settings_;
  double tolerance_ = 0;  // of places
};

}  // namespace

ForeignRays ReadForeignRays(const Text& text) { return Reader(text).Read(); }

bool IsForeignRays(const Text& text) {
  if (text.name.ends_with(".rays")) return true;
  if (!text.name.ends_with(".obj")) return false;
  Tokenizer tokens(text, Tokenizer::Comments::hash);
  const auto first = tokens.Next(), second = tokens.Next();
  return first && second && first->text == "g" && KindNamed(second->text);
}

PixelTrace AsTrace(const std::vector<ForeignRay>& foreign, double scene_radius) {
  PixelTrace trace;
  for (const ForeignRay& ray : foreign) {
    RecordedRay recorded;
    recorded.kind = ray.kind;
    recorded.ray = {ray.from, ray.to - ray.from, 0, ray.kind == RayKind::shadow ? 1 : R3::infinity};
    recorded.throughput = {1, 1, 1};
    if (ray.kind != RayKind::shadow) {
      recorded.at.emplace();
      recorded.at->position = ray.to;
    }
    // It starts from the end of the ray before it that ends nearest.
    double nearest = 2 * foreign_length * scene_radius;
    for (std::size_t i = 0; i < trace.rays.size() && ray.kind != RayKind::camera; ++i) {
      const RecordedRay& before = trace.rays[i];
      if (before.kind == RayKind::shadow) continue;
      const double distance = Length(before.at->position - ray.from);
      if (distance > nearest) continue;
      nearest = distance;
      recorded.parent = static_cast<int>(i);
      recorded.depth = before.depth + (ray.kind == RayKind::shadow ? 0 : 1);
    }
    trace.rays.push_back(std::move(recorded));
  }
  return trace;
}

std::optional<RayDifference> FirstDifference(const PixelTrace& ours, const std::vector<ForeignRay>& foreign,
                                             const World& world, const RenderSettings& settings) {
  const double radius = world.scene().root.bounds.IsEmpty() ? 1 : world.scene().root.bounds.Radius();
  return Comparison(ours, AsTrace(foreign, radius), world, settings).First();
}

std::optional<ForeignPixel> PixelOf(const ForeignRays& foreign, const Camera& camera, const RenderSettings& settings) {
  if (const auto& pixel = foreign.pixel)
    return pixel->column < settings.width && pixel->row < settings.height ? pixel : std::nullopt;
  const auto first = std::ranges::find(foreign.rays, RayKind::camera, &ForeignRay::kind);
  if (first == foreign.rays.end()) return {};
  if (!camera.IsPinhole()) return {};
  const DrawingSize size{settings.width, settings.height};
  const auto place = PixelOf(camera, camera.eye + (first->to - first->from), size);
  if (!place || !(place->x >= 0 && place->y >= 0 && place->x < size.width && place->y < size.height)) return {};
  return ForeignPixel{static_cast<int>(place->x), static_cast<int>(place->y)};
}

}  // namespace ray
