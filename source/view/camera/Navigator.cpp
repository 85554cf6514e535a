#include "source/view/camera/Navigator.h"

#include <algorithm>
#include <array>

#include "R1/Elementary.h"

namespace ray {
namespace {

constexpr std::size_t most_remembered = 100;
constexpr double zoom_of_a_step = 0.05;  // like a drag over that share of the drawing
constexpr double faster = 1.25;          // a step of the wheel while flying
constexpr double factor_of_modifier = 4;

/// The keys of flying, and the way of each along right, up and towards.
struct FlyKey {
  Key key;
  R3::Vector way;
};
const std::array<FlyKey, 6> fly_keys{FlyKey{Key::w, {0, 0, 1}}, {Key::s, {0, 0, -1}}, {Key::a, {-1, 0, 0}},
                                     {Key::d, {1, 0, 0}},       {Key::q, {0, -1, 0}}, {Key::e, {0, 1, 0}}};

/// The axis of the world that is most upright on the image.
R3::Vector MostUpright(const Camera& camera) {
  const R3::Vector& up = camera.up;
  const int axis = MaxAxis(up);
  const double sign = up[axis] < 0 ? -1 : 1;
  return {axis == 0 ? sign : 0, axis == 1 ? sign : 0, axis == 2 ? sign : 0};
}

}  // namespace

Navigator::Navigator(const Camera& camera, const R3::Box& scene, const DrawingSize& size)
    : camera_(camera), box_(scene), size_(size), vertical_(MostUpright(camera)) {}

void Navigator::Set(const Camera& camera) {
  const bool is_finite = IsFinite(camera.eye - R3::Point{}) && IsFinite(camera.towards) && IsFinite(camera.up) &&
                         IsFinite(camera.right) && !(camera.towards == R3::Vector{});
  if (!is_finite) return;
  camera_ = camera;
  ++changes_;
}

void Navigator::Remember() {
  behind_.push_back(camera_);
  if (behind_.size() > most_remembered) behind_.erase(behind_.begin());
  ahead_.clear();
}

void Navigator::Go(const Camera& camera) {
  Remember();
  Set(camera);
}

bool Navigator::Back() {
  if (behind_.empty()) return false;
  ahead_.push_back(camera_);
  Set(behind_.back());
  behind_.pop_back();
  return true;
}

bool Navigator::Forward() {
  if (ahead_.empty()) return false;
  behind_.push_back(camera_);
  Set(ahead_.back());
  ahead_.pop_back();
  return true;
}

void Navigator::ToggleTurntable() {
  is_turntable_ = !is_turntable_;
  if (!is_turntable_) return;
  vertical_ = MostUpright(camera_);
  Go(RotatedUpright(camera_, Center(), vertical_, {0, 0}));
}

void Navigator::BeginDrag(const ButtonEvent& event, const PointAt& point_at) {
  const auto grabbed = point_at({event.x, event.y});
  const double depth = grabbed ? DepthOf(camera_, *grabbed) : DepthOf(camera_, Center());
  drag_ = Dragging{event.button, event.modifiers, {event.x, event.y}, depth > 0 ? depth : Radius()};
  held_.clear();
}

void Navigator::DragTo(const R2::Point& position) {
  if (!drag_) return;
  const R2::Point way{(position.x - drag_->at.x) / size_.width, (position.y - drag_->at.y) / size_.height};
  drag_->at = position;
  if (way.x == 0 && way.y == 0) return;
  if (!drag_->has_moved) Remember();
  drag_->has_moved = true;
  const Modifiers& m = drag_->modifiers;
  if (drag_->button == Button::right)
    Set(Looking(camera_, vertical_, way));
  else if (drag_->button == Button::middle || m.shift)
    Set(Zoomed(camera_, Center(), way));
  else if (m.control)
    Set(Panned(camera_, drag_->depth, way, size_));
  else
    Set(is_turntable_ ? RotatedUpright(camera_, Center(), vertical_, way) : Rotated(camera_, Center(), way));
}

void Navigator::Scroll(const ScrollEvent& event, const PointAt& point_at) {
  if (IsFlying()) {
    fly_speed_ = std::clamp(fly_speed_ * R1::Pow(faster, event.steps), 1e-6, 1e6);
    return;
  }
  const auto point = point_at({event.x, event.y});
  Go(Zoomed(camera_, point ? *point : Center(), {0, zoom_of_a_step * event.steps}));
}

bool Navigator::HoldKey(const KeyEvent& event) {
  const bool moves = std::any_of(fly_keys.begin(), fly_keys.end(), [&](const FlyKey& k) { return k.key == event.key; });
  if (!moves || (event.is_pressed && !IsFlying())) return false;
  if (!event.is_pressed) return held_.erase(event.key) > 0;
  if (held_.empty()) Remember();
  held_.insert(event.key);
  is_fast_ = event.modifiers.shift;
  is_slow_ = event.modifiers.control;
  return true;
}

void Navigator::Advance(double seconds) {
  if (!IsFlying() || held_.empty()) return;
  const double speed =
      fly_speed_ * Radius() * (is_fast_ ? factor_of_modifier : 1) / (is_slow_ ? factor_of_modifier : 1);
  R3::Vector way;
  for (const FlyKey& k : fly_keys)
    if (held_.count(k.key)) way = way + k.way;
  if (!(way == R3::Vector{})) Set(Moved(camera_, speed * seconds * Unit(way)));
}

}  // namespace ray
