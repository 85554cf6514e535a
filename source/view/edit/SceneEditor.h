#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "R3/Ray.h"
#include "source/draw/Drawing.h"
#include "source/view/edit/EditHistory.h"
#include "source/view/edit/ScnEdits.h"

namespace ray {

struct ViewerState;

/// Along what a thing is moved: an axis of the world, or the plane through it that faces the camera.
enum class MoveAxis { x, y, z, view };

/// Changes the scene that a viewer shows, by edits of its text that are read again at once, and saves them into the
/// very lines of its files. What cannot be done is a message of the viewer, and changes nothing.
class SceneEditor {
 public:
  /// Whether something was changed that no file has.
  bool HasUnsaved() const { return is_unsaved_; }
  /// "2 changes, 1 undone, not saved"; "none" before the first.
  std::string Describe() const;
  const EditHistory& History() const { return history_; }
  /// Why the viewer's scene cannot be edited; empty where it can.
  static std::string WhyNot(const ViewerState& viewer);
  /// The scene was read from the disk: there is nothing to undo any more.
  void Forget();
  /// Whether the viewer may go on to lose the edits: where there are any that are not saved, it says so at first, and
  /// may when it asks again. `next` is what it would do: "quit".
  bool MayLose(ViewerState& viewer, const std::string& next);

  // What is chosen. A light is where no node is.
  /// The statement of the chosen node, or light; nothing for none, and where the program itself has made it.
  std::optional<std::uint32_t> ChosenStatement(const ViewerState& viewer) const;
  std::optional<std::size_t> ChosenLight(const ViewerState& viewer) const;
  void ChooseLight(ViewerState& viewer, std::size_t light);
  /// Index into Scene::materials: that of the chosen node, unless another was chosen since.
  std::optional<std::size_t> ChosenMaterial(const ViewerState& viewer) const;
  void ChooseMaterial(const ViewerState& viewer, std::size_t material);

  // Changes.
  /// `continues`: it goes on with what a slider or picker did, so that one undo takes all of it back.
  void SetField(ViewerState& viewer, std::uint32_t statement, const ScnField& field, const std::vector<double>& values,
                bool continues);
  /// A setting that the scene asks for, by the name of its option.
  void SetSetting(ViewerState& viewer, const std::string& option, const std::string& value, bool continues);
  /// "mirror" or "gloss", which the scene has not said of the material yet: with numbers that change little at first.
  void AddToMaterial(ViewerState& viewer, std::size_t material, const std::string& command);
  /// The image's name as the scene says it; empty for none.
  void SetTexture(ViewerState& viewer, std::size_t material, const std::string& name);
  MoveAxis Axis() const { return axis_; }
  void SetAxis(ViewerState& viewer, MoveAxis axis);
  void NextAxis(ViewerState& viewer);
  /// Moves what is chosen by so many steps along the axis; facing the camera, to the right.
  void MoveBySteps(ViewerState& viewer, double steps);
  /// In the scene's unit of length: a round number, about 1/20 of the scene's radius.
  static double StepOf(const ViewerState& viewer);
  void Delete(ViewerState& viewer);
  void Duplicate(ViewerState& viewer);
  /// The camera of the view becomes that of the scene.
  void KeepCamera(ViewerState& viewer);
  /// Focuses on a point; opens the lens where the scene has none.
  void FocusOn(ViewerState& viewer, const std::optional<R3::Point>& point);

  /// A button was let go: what a slider or picker was dragged to is done now, where reading the scene takes too long to
  /// follow it.
  void DoHeld();

  // A drag of what is chosen. Rays are through the pointer.
  /// Whether there is something to drag.
  bool BeginDrag(ViewerState& viewer, const R3::Ray& ray);
  void DragTo(ViewerState& viewer, const R3::Ray& ray);
  void EndDrag(ViewerState& viewer);
  bool IsDragging() const { return drag_.has_value(); }

  void Undo(ViewerState& viewer);
  void Redo(ViewerState& viewer);
  void Save(ViewerState& viewer);
  /// Beside the scene, under the first free name: "room-2.scn".
  void SaveCopy(ViewerState& viewer);

  /// The axis that things are moved along, at what is chosen. `size_at` says how long it is at a point.
  Lines Marks(const ViewerState& viewer, const DrawingSpace& space,
              const std::function<double(const R3::Point&)>& size_at) const;

 private:
  struct Drag {
    R3::Point from;         // the middle of what is dragged, when it was pressed
    R3::Ray pressed;        // through the pointer then
    R3::Vector done, left;  // how far it has gone, and is still to go
  };

  /// What to move, and from which coordinates its own are made.
  struct Target {
    std::uint32_t statement = 0;
    std::uint32_t frame = 0;  // into World::Frames: the coordinates that the statement is in
    R3::Box box{};            // in the world; empty where it has none
  };

  /// Nothing where a message says why not.
  std::optional<Target> ChosenTarget(ViewerState& viewer) const;
  std::optional<Target> TargetOf(const ViewerState& viewer) const;
  std::optional<EditPlace> PlaceOf(const ViewerState& viewer, std::optional<std::uint32_t> statement) const;
  /// Chooses what is said there, if anything is.
  void Choose(ViewerState& viewer, const EditPlace& place);
  /// Makes the edits of `make`, which throws EditRefusal, into a change; `key` of the statement's field, for changes
  /// that continue. Returns whether it was done.
  bool Do(ViewerState& viewer, const std::string& what, const std::string& key, bool continues,
          const std::function<TextEdits()>& make, const std::optional<EditPlace>& chosen_after = {});
  /// Does an edit at once, or on release of the button: for edits that continue while reading the scene takes long.
  void DoOrHold(ViewerState& viewer, const std::string& what, const std::string& key, bool continues,
                const std::function<TextEdits()>& make);
  bool Apply(ViewerState& viewer, const TextEdits& edits, const std::optional<EditPlace>& chosen);
  void Move(ViewerState& viewer, const R3::Vector& way, const std::string& key, bool continues);
  R3::Vector AxisVector(const ViewerState& viewer) const;
  void RefuseReadOnly(const ViewerState& viewer, const TextEdits& edits) const;
  void CheckUnsaved();
  std::string Name(const ViewerState& viewer, std::uint32_t statement) const;

  EditHistory history_;
  std::shared_ptr<const EditedFiles> texts_;   // of the scene's files, as edited; null before the first edit
  EditedFiles saved_;                          // as the disk has them
  std::shared_ptr<const EditedFiles> copied_;  // what was saved as a copy last
  bool is_unsaved_ = false, was_asked_ = false;
  MoveAxis axis_ = MoveAxis::x;
  std::optional<std::size_t> light_, material_;
  std::optional<std::size_t> node_of_material_;  // what was chosen when the material was
  std::optional<Drag> drag_;
  std::function<void()> held_;     // a change for when the button is let go; empty for none
  double seconds_of_reading_ = 0;  // of the last edit
};

}  // namespace ray
