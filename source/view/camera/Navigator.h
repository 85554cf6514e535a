#pragma once

#include <functional>
#include <optional>
#include <set>
#include <vector>

#include "source/draw/CameraMoves.h"
#include "source/draw/Event.h"

namespace ray {

/// Moves the camera by pointer, wheel and keys, and remembers where it was.
class Navigator {
 public:
  /// Returns the point of the scene under a position of the drawing; std::nullopt for the background.
  using PointAt = std::function<std::optional<R3::Point>(const R2::Point& position)>;

  Navigator(const Camera& camera, const R3::Box& scene, const DrawingSize& size);

  const Camera& camera() const { return camera_; }
  /// Grows with every change of the camera.
  std::uint64_t Changes() const { return changes_; }
  const R3::Box& box() const { return box_; }

  /// Another scene, or another size; the camera stays.
  void SetBox(const R3::Box& scene) { box_ = scene; }
  void SetSize(const DrawingSize& size) { size_ = size; }

  /// Moves to another view, from which Back returns.
  void Go(const Camera& camera);
  /// Returns true if there was a view to return to.
  bool Back();
  bool Forward();

  /// The center of rotation and zoom: the pivot, or the center of the scene.
  R3::Point Center() const { return pivot_ ? *pivot_ : box_.IsEmpty() ? R3::Point{} : box_.Center(); }
  const std::optional<R3::Point>& Pivot() const { return pivot_; }
  void SetPivot(const std::optional<R3::Point>& pivot) { pivot_ = pivot; }
  /// Selects a turntable, the initial mode: the vertical stays upright in the image.
  void ToggleTurntable();
  bool IsTurntable() const { return is_turntable_; }

  void Frame(const R3::Box& box) { Go(Framed(camera_, box, size_)); }
  void LookAlong(const R3::Vector& towards, const R3::Vector& up) { Go(FromAxis(camera_, Center(), towards, up)); }
  void Widen(double factor) { Go(WithAngle(camera_, factor)); }

  void BeginDrag(const ButtonEvent& event, const PointAt& point_at);
  void DragTo(const R2::Point& position);
  void EndDrag() { drag_.reset(); }
  bool IsDragging() const { return drag_.has_value(); }
  void Scroll(const ScrollEvent& event, const PointAt& point_at);

  /// Moves the camera by a key while the right button is held. Returns false for keys that do not move it.
  bool IsFlying() const { return drag_ && drag_->button == Button::right; }
  bool HoldKey(const KeyEvent& event);
  /// Advances time: the camera moves as long as keys are held.
  void Advance(double seconds);
  /// The speed, in radii of the scene per second.
  double FlySpeed() const { return fly_speed_; }

 private:
  struct Dragging {
    Button button;
    Modifiers modifiers;
    R2::Point at;
    double depth;  // of the point that was grabbed
    bool has_moved = false;
  };
  void Set(const Camera& camera);
  double Radius() const { return box_.Radius() > 0 ? box_.Radius() : 1; }
  void Remember();

  Camera camera_;
  R3::Box box_;
  DrawingSize size_;
  std::uint64_t changes_ = 0;
  std::optional<R3::Point> pivot_;
  bool is_turntable_ = true;
  R3::Vector vertical_;
  std::optional<Dragging> drag_;
  std::set<Key> held_;
  bool is_fast_ = false, is_slow_ = false;
  double fly_speed_ = 0.5;
  std::vector<Camera> behind_, ahead_;
};

}  // namespace ray
