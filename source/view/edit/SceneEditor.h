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
  /// Makes the editor of the viewer that it is a part of.
  explicit SceneEditor(ViewerState& viewer) : viewer_(viewer) {}

  /// Returns true if a change is in no file.
  bool HasUnsaved() const { return is_unsaved_; }
  /// "2 changes, 1 undone, not saved"; "none" before the first.
  std::string Describe() const;
  const EditHistory& History() const { return history_; }
  /// Returns the reason why the scene cannot be edited; empty if it can.
  std::string WhyNot() const;
  /// The scene was read from the disk: there is nothing to undo any more.
  void Forget();
  /// Returns true if the edits may be lost. If some are not saved, a question is shown first, and the same request
  /// may when it asks the same again at once. `next` is what it would do: "quit".
  bool MayLose(const std::string& next);

  // What is chosen. A light is where no node is.
  /// The statement of the chosen node, or light; nothing for none, and where the program itself has made it.
  std::optional<std::uint32_t> ChosenStatement() const;
  std::optional<std::size_t> ChosenLight() const;
  void ChooseLight(std::size_t light);
  /// Index into Scene::materials: that of the chosen node, unless another was chosen since.
  std::optional<std::size_t> ChosenMaterial() const;
  void ChooseMaterial(std::size_t material);

  // Changes.
  /// `continues`: it extends what a slider or picker did, so that one undo takes all of it back.
  void SetField(std::uint32_t statement, const ScnField& field, const std::vector<double>& values, bool continues);
  /// Changes a setting of the scene, by the name of its option.
  void SetSetting(const std::string& option, const std::string& value, bool continues);
  /// "mirror" or "gloss", which the scene has not said of the material yet: with numbers that change little at first.
  void AddToMaterial(std::size_t material, const std::string& command);
  /// The image's name as the scene says it; empty for none.
  void SetTexture(std::size_t material, const std::string& name);
  MoveAxis Axis() const { return axis_; }
  void SetAxis(MoveAxis axis);
  void NextAxis();
  /// Moves what is chosen by so many steps along the axis; facing the camera, to the right.
  void MoveBySteps(double steps);
  /// Returns a round number, about 1/20 of the scene's radius, in the scene's unit of length.
  double Step() const;
  void Delete();
  void Duplicate();
  /// The camera of the view becomes that of the scene.
  void KeepCamera();
  /// Focuses on a point; opens the lens where the scene has none.
  void FocusOn(const std::optional<R3::Point>& point);

  /// A button was let go: what a slider or picker was dragged to is done now, where reading the scene takes too long to
  /// follow it.
  void DoHeld();
  /// Does the same that had to wait until a scene was read.
  void DoDue();

  // A drag of what is chosen. Rays are through the pointer.
  /// Returns true if there is something to drag.
  bool BeginDrag(const R3::Ray& ray);
  void DragTo(const R3::Ray& ray);
  void EndDrag();
  bool IsDragging() const { return drag_.has_value(); }

  void Undo();
  void Redo();
  void Save();
  /// Saves it next to the scene, under the first free name: "room-2.scn".
  void SaveCopy();

  /// The axis that things are moved along, at what is chosen. `size_at` says how long it is at a point.
  Lines Marks(const DrawingSpace& space, const std::function<double(const R3::Point&)>& size_at) const;

 private:
  struct Drag {
    R3::Point from;         // the middle of what is dragged, when it was pressed
    R3::Ray pressed;        // through the pointer then
    R3::Vector done, left;  // how far it has gone, and is still to go
  };

  /// The thing to be moved, and the coordinates that its own are relative to.
  struct Target {
    std::uint32_t statement = 0;
    std::uint32_t frame = 0;  // into World::Frames: the coordinates that the statement is in
    R3::Box box{};            // in the world; empty where it has none
  };

  /// Nothing where a message says why not.
  std::optional<Target> ChosenTarget() const;
  std::optional<Target> TargetOf() const;
  std::optional<EditPlace> PlaceOf(std::optional<std::uint32_t> statement) const;
  /// Chooses what is said there, if anything is.
  void Choose(const EditPlace& place);
  /// Makes the edits of `make`, which throws EditRefusal, into a change; `key` of the statement's field, for changes
  /// that continue.
  void Do(const std::string& what, const std::string& key, bool continues, const std::function<TextEdits()>& make,
          const std::optional<EditPlace>& chosen_after = {});
  /// Does an edit at once, or on release of the button: for edits that continue while reading the scene takes long.
  void DoOrHold(const std::string& what, const std::string& key, bool continues,
                const std::function<TextEdits()>& make);
  /// Shows the scene with the edits. Then calls `then`, which returns the message, unless they are refused.
  void Apply(const TextEdits& edits, const std::optional<EditPlace>& chosen, const std::function<std::string()>& then);
  /// Returns true, with a message, if a scene is being read: an edit would be of a text that is about to change.
  bool MustWait();
  /// Returns true if reading the scene takes too long to follow a drag.
  bool IsSlow() const;
  void Move(const R3::Vector& way, const std::string& key, bool continues);
  R3::Vector AxisVector() const;
  void RefuseReadOnly(const TextEdits& edits) const;
  const ScnPlaces& Places() const;
  void CheckUnsaved();
  std::string Name(std::uint32_t statement) const;

  ViewerState& viewer_;
  EditHistory history_;
  std::shared_ptr<const EditedFiles> texts_;   // of the scene's files, as edited; null before the first edit
  EditedFiles saved_;                          // as the disk has them
  std::shared_ptr<const EditedFiles> copied_;  // what was saved as a copy last
  bool is_unsaved_ = false;
  MoveAxis axis_ = MoveAxis::x;
  std::optional<std::size_t> light_, material_;
  std::optional<std::size_t> node_of_material_;  // what was chosen when the material was
  std::optional<Drag> drag_;
  std::function<void()> held_;  // a change for when the button is let go; empty for none
  bool held_is_due_ = false;    // it was let go while a scene was being read
};

}  // namespace ray
