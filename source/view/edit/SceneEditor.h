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

/// The direction of moves: an axis of the world, or in the plane through the object that faces the camera.
enum class MoveAxis { x, y, z, view };

/// Changes the scene of a viewer by edits of its text, which is then read again, and saves them in the lines of its
/// files. A refused edit shows a message and changes nothing.
class SceneEditor {
 public:
  /// Makes the editor of the viewer that it is a part of.
  explicit SceneEditor(ViewerState& viewer) : viewer_(viewer) {}

  /// Returns true if a change is not saved.
  bool HasUnsaved() const { return is_unsaved_; }
  /// "2 changes, 1 undone, not saved"; "none" before the first.
  std::string Describe() const;
  const EditHistory& History() const { return history_; }
  /// Returns the reason why the scene cannot be edited; empty if it can.
  std::string WhyNot() const;
  /// Forgets all changes, when the scene was read from the disk.
  void Forget();
  /// Returns true if the edits may be lost. If some are not saved, it shows a question and returns false; it returns
  /// true when called again at once for the same action. `next`: the name of the action, such as "quit".
  bool MayLose(const std::string& next);

  // The selection: a node, or a light.
  /// Returns the statement of the chosen node or light; std::nullopt without a selection, or if no statement made it.
  std::optional<std::uint32_t> ChosenStatement() const;
  std::optional<std::size_t> ChosenLight() const;
  void ChooseLight(std::size_t light);
  /// Index into Scene::materials: that of the chosen node, unless another was chosen since.
  std::optional<std::size_t> ChosenMaterial() const;
  void ChooseMaterial(std::size_t material);

  // Changes.
  /// `continues`: extends the change of the same slider or picker, so that one undo reverts all of it.
  void SetField(std::uint32_t statement, const ScnField& field, const std::vector<double>& values, bool continues);
  /// Changes a setting of the scene, by the name of its option.
  void SetSetting(const std::string& option, const std::string& value, bool continues);
  /// "mirror" or "gloss", which the material does not have yet: with numbers that change the image little.
  void AddToMaterial(std::size_t material, const std::string& command);
  /// The name of the image, as the scene has it; empty for none.
  void SetTexture(std::size_t material, const std::string& name);
  MoveAxis Axis() const { return axis_; }
  void SetAxis(MoveAxis axis);
  void NextAxis();
  /// Moves the selection by that many steps along the axis; with MoveAxis::view, to the right.
  void MoveBySteps(double steps);
  /// Returns a round number, about 1/20 of the scene's radius, in the scene's unit of length.
  double Step() const;
  void Delete();
  void Duplicate();
  /// Sets the scene's camera to that of the view.
  void KeepCamera();
  /// Focuses on a point; opens the lens if the scene has no aperture.
  void FocusOn(const std::optional<R3::Point>& point);

  /// Makes the change of a slider or picker on release of the button, if reading the scene takes too long to follow the
  /// drag.
  void DoHeld();
  /// Makes that change when it had to wait for the scene being read.
  void DoDue();

  // A drag of the selection. Rays are through the pointer.
  /// Returns true if there is something to drag.
  bool BeginDrag(const R3::Ray& ray);
  void DragTo(const R3::Ray& ray);
  void EndDrag();
  bool IsDragging() const { return drag_.has_value(); }

  void Undo();
  void Redo();
  void Save();
  /// Saves a copy next to the scene, under the first free name: "room-2.scn".
  void SaveCopy();

  /// The axis of moves, drawn at the selection. `size_at` gives its length at a point.
  Lines Marks(const DrawingSpace& space, const std::function<double(const R3::Point&)>& size_at) const;

 private:
  struct Drag {
    R3::Point from;         // the middle of the selection at the press
    R3::Ray pressed;        // through the pointer then
    R3::Vector done, left;  // the distances moved and still to move
  };

  /// The object to move, and the coordinate system of its statement.
  struct Target {
    std::uint32_t statement = 0;
    std::uint32_t frame = 0;  // into World::Frames: the coordinates that the statement is in
    R3::Box box{};            // in the world; may be empty
  };

  /// Returns std::nullopt, with a message that says why, if nothing can be edited.
  std::optional<Target> ChosenTarget() const;
  std::optional<Target> TargetOf() const;
  std::optional<EditPlace> PlaceOf(std::optional<std::uint32_t> statement) const;
  /// Chooses the statement there, if there is one.
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
  std::shared_ptr<const EditedFiles> copied_;  // the files of the last saved copy
  bool is_unsaved_ = false;
  MoveAxis axis_ = MoveAxis::x;
  std::optional<std::size_t> light_, material_;
  std::optional<std::size_t> node_of_material_;  // the selection when the material was chosen
  std::optional<Drag> drag_;
  std::function<void()> held_;  // a change to make on release of the button; empty for none
  bool held_is_due_ = false;    // the button was released while a scene was being read
};

}  // namespace ray
