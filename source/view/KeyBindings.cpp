#include "source/view/KeyBindings.h"

#include <array>
#include <cctype>
#include <type_traits>

#include "source/view/commands/Commands.h"

namespace ray {
namespace {

constexpr Modifiers plain{}, shift{true, false}, control{false, true}, both{true, true};
constexpr double wider = 1.1;

/// The actions of the pointer, for the help.
constexpr std::array gestures{
    std::array{"left drag", "rotate about the pivot, or the center of the scene"},
    std::array{"Shift+left or middle drag", "zoom"},
    std::array{"Control+left drag", "pan"},
    std::array{"wheel", "zoom toward the point under the pointer; over the cross section, move its plane"},
    std::array{"left click", "describe what is under the pointer"},
    std::array{"double click", "set the pivot to the point under the pointer"},
    std::array{"Control+Shift+left drag", "move the chosen object or light along the axis of key A"},
    std::array{"Control+right drag", "a crop: the rectangle of the view that S renders"},
    std::array{"right click", "trace this pixel and show its rays; arrow keys step to the next pixel"},
    std::array{"right button held", "look around; W A S D Q E fly, Shift faster, Control slower, wheel sets the speed"},
    std::array{"file dropped", "open a scene or mesh, or use an image as the reference"},
};

/// The beginning of a group of keys in the table, for the help.
struct Heading {
  Key key;
  Modifiers modifiers;
  const char* text;
};
constexpr std::array headings{
    Heading{Key::s, plain, "Rendering"},     Heading{Key::tab, plain, "What is shown"},
    Heading{Key::f, plain, "Camera"},        Heading{Key::g, plain, "Rays"},
    Heading{Key::x, plain, "Cross section"}, Heading{Key::f7, plain, "False colors"},
    Heading{Key::r, plain, "Comparing"},     Heading{Key::up, control, "Exposure"},
    Heading{Key::a, plain, "Editing"},       Heading{Key::o, control, "Scenes"},
    Heading{Key::f1, plain, "Program"},      Heading{Key::digit_1, plain, "Bookmarks"},
};

/// An action: the command with that argument.
template <typename Argument>
std::function<void(ViewerState&)> With(void (*command)(ViewerState&, Argument),
                                       std::type_identity_t<Argument> argument) {
  return [command, argument](ViewerState& viewer) { command(viewer, argument); };
}

std::function<void(ViewerState&)> Toggles(const char* what, bool SpaceOverlays::*shows) {
  return [what, shows](ViewerState& viewer) { Toggle(viewer, what, shows); };
}

std::function<void(ViewerState&)> Arrow(int right, int up) {
  return [right, up](ViewerState& viewer) { MoveByArrow(viewer, right, up); };
}

std::function<void(ViewerState&)> Along(const R3::Vector& towards, const R3::Vector& up, const char* name) {
  return [=](ViewerState& viewer) { LookAlong(viewer, towards, up, name); };
}

std::vector<KeyBinding> Rendering() {
  return {
      {Key::s, plain, "render the view and save the image", StartTrace},
      {Key::i, plain,
       "the rendered image flat: wheel zooms, drag moves, Shift+drag slides against reference or preview", ToggleFlat},
      {Key::escape, plain,
       "stop reading a scene, close the help or the flat image, clear the crop, forget the pick, close the cross "
       "section, stop rendering",
       Peel},
      {Key::q, plain, "quit; while an image is being rendered, when pressed twice", Quit},
      {Key::p, plain, "pause or continue tracing what the view shows", PauseOrResume},
      {Key::p, shift, "toggle the traced image: without it, the preview alone", ToggleTraced},
      {Key::m, plain, "toggle denoising, of images that get all their samples", ToggleDenoising},
      {Key::v, plain, "toggle the rendered image in space", Toggles("rendered image in space", &SpaceOverlays::quad)},
      {Key::c, plain, "print the camera as a scene-file line and copy it to the clipboard", PrintCamera},
      {Key::space, plain, "", PrintCamera},
  };
}

std::vector<KeyBinding> WhatIsShown() {
  return {
      {Key::tab, plain, "toggle the panels: scene, picked pixel, settings, statistics", TogglePanels},
      {Key::b, plain, "bounding boxes: none, scene graph, accelerator", CycleBoxes},
      {Key::comma, plain, "bounding boxes one level up", With(ChangeBoxLevel, -1)},
      {Key::period, plain, "bounding boxes one level down", With(ChangeBoxLevel, 1)},
      {Key::e, plain, "toggle edges", Toggles("edges", &SpaceOverlays::edges)},
      {Key::w, plain, "toggle faces", Toggles("faces", &SpaceOverlays::faces)},
      {Key::l, plain, "toggle lights; F frames them as well", ToggleLights},
      {Key::l, shift, "toggle shadows of the preview, from its two strongest lights",
       Toggles("shadows", &SpaceOverlays::shadows)},
      {Key::c, shift, "toggle the scene's camera", Toggles("the scene's camera", &SpaceOverlays::camera)},
  };
}

std::vector<KeyBinding> CameraMoves() {
  return {
      {Key::f, plain, "frame the whole scene", FrameScene},
      {Key::f, shift, "frame the picked object", FramePicked},
      {Key::t, plain, "rotation as a turntable, with a level horizon, or freely", ToggleTurntable},
      {Key::left_bracket, plain, "narrow the field of view", With(Widen, 1 / wider)},
      {Key::right_bracket, plain, "widen the field of view", With(Widen, wider)},
      {Key::z, plain, "previous view", GoBack},
      {Key::z, shift, "next view", GoForward},
      {Key::pad_1, plain, "look along -z", Along({0, 0, -1}, {0, 1, 0}, "-z")},
      {Key::pad_3, plain, "look along -x", Along({-1, 0, 0}, {0, 1, 0}, "-x")},
      {Key::pad_7, plain, "look along -y", Along({0, -1, 0}, {0, 0, -1}, "-y")},
      {Key::pad_0, plain, "the scene's camera", GoToSceneCamera},
  };
}

std::vector<KeyBinding> Rays() {
  return {
      {Key::g, plain, "toggle the rays of every 25th pixel", ToggleGrid},
      {Key::f2, plain, "toggle camera rays", With(ToggleRays, ShownRays::camera)},
      {Key::f3, plain, "toggle shadow rays", With(ToggleRays, ShownRays::shadow)},
      {Key::f4, plain, "toggle reflected and scattered rays", With(ToggleRays, ShownRays::reflection)},
      {Key::f5, plain, "toggle transmitted rays", With(ToggleRays, ShownRays::transmission)},
      {Key::f6, plain, "toggle normals at hit points", ToggleNormals},
      {Key::n, plain, "show one more bounce", With(StepBounce, 1)},
      {Key::n, shift, "show one bounce fewer", With(StepBounce, -1)},
      {Key::o, plain, "save the rays as an .obj file", SaveRays},
      {Key::backspace, plain, "clear the pixel's rays", ForgetPixel},
      {Key::left, plain, "step to the next pixel, or move the cross section", Arrow(-1, 0)},
      {Key::right, plain, "", Arrow(1, 0)},
      {Key::up, plain, "", Arrow(0, 1)},
      {Key::down, plain, "", Arrow(0, -1)},
  };
}

std::vector<KeyBinding> CrossSection() {
  return {
      {Key::x, plain, "toggle the cross section", ToggleSection},
      {Key::x, shift, "plane of the cross section: camera row, xz, yz, xy", NextPlane},
  };
}

std::vector<KeyBinding> FalseColors() {
  return {
      {Key::f7, plain, "depth", With(ToggleMode, RenderMode::depth)},
      {Key::f8, plain, "normals", With(ToggleMode, RenderMode::normal)},
      {Key::f9, plain, "texture coordinates", With(ToggleMode, RenderMode::uv)},
      {Key::f10, plain, "primitive ids", With(ToggleMode, RenderMode::id)},
      {Key::f11, plain, "rays per pixel", With(ToggleMode, RenderMode::rays)},
      {Key::f12, plain, "cost per pixel", With(ToggleMode, RenderMode::heat)},
  };
}

std::vector<KeyBinding> ComparingAndTheRest() {
  return {
      {Key::r, plain, "keep the rendered image as the reference", KeepReference},
      {Key::r, shift, "show the reference while held", With(Compare, TracedImages::Comparing::reference),
       StopShowingReference},
      {Key::d, plain, "toggle the difference from the reference", With(Compare, TracedImages::Comparing::difference)},
      {Key::d, shift, "the difference in false colors with their scale; pressed again, FLIP", CompareInFalseColors},
      {Key::page_down, control, "flip through the images made so far: the next, or the current one",
       With(FlipImages, 1)},
      {Key::page_up, control, "the one before", With(FlipImages, -1)},
      {Key::up, control, "one stop brighter", With(ChangeExposure, 1)},
      {Key::down, control, "one stop darker", With(ChangeExposure, -1)},
      {Key::up, both, "a quarter of a stop brighter", With(ChangeExposure, 0.25)},
      {Key::down, both, "a quarter of a stop darker", With(ChangeExposure, -0.25)},
      {Key::digit_0, control, "reset the exposure", With(ChangeExposure, 0)},
      {Key::f1, plain, "save a screenshot", [](ViewerState& viewer) { viewer.host.SaveDrawing(); }},
      {Key::r, control, "reload the scene", ReadFromDisk},
      {Key::h, plain, "this help, which can be searched", ToggleHelp},
      {Key::slash, plain, "", ToggleHelp},
      {Key::slash, shift, "", ToggleHelp},
  };
}

std::vector<KeyBinding> Editing() {
  const auto edit = [](void (SceneEditor::*act)()) { return [act](ViewerState& viewer) { (viewer.editor.*act)(); }; };
  const auto move = [](double steps) { return [steps](ViewerState& viewer) { viewer.editor.MoveBySteps(steps); }; };
  constexpr double many = 10;
  return {
      {Key::a, plain, "the axis that the chosen object or light moves along: x, y, z, the plane facing the camera",
       edit(&SceneEditor::NextAxis)},
      {Key::equal, plain, "move it forward along the axis; with Shift ten steps", move(1)},
      {Key::equal, shift, "", move(many)},
      {Key::minus, plain, "move it backward along the axis; with Shift ten steps", move(-1)},
      {Key::minus, shift, "", move(-many)},
      {Key::d, control, "duplicate it", edit(&SceneEditor::Duplicate)},
      {Key::del, plain, "delete it", edit(&SceneEditor::Delete)},
      {Key::k, plain, "focus the lens on the point under the pointer", FocusUnderPointer},
      {Key::k, shift, "make the view the scene's camera", edit(&SceneEditor::KeepCamera)},
      {Key::z, control, "undo", edit(&SceneEditor::Undo)},
      {Key::y, control, "redo", edit(&SceneEditor::Redo)},
      {Key::z, both, "", edit(&SceneEditor::Redo)},
      {Key::s, control, "save the changed lines into the scene's files", edit(&SceneEditor::Save)},
      {Key::s, both, "save the changed scene as a copy beside it", edit(&SceneEditor::SaveCopy)},
  };
}

std::vector<KeyBinding> Scenes() {
  return {
      {Key::o, control, "list the scenes to open: of this folder, and recent ones", ToggleSceneList},
      {Key::page_down, plain, "open the next scene of the folder", With(OpenNeighbor, 1)},
      {Key::page_up, plain, "open the previous scene of the folder", With(OpenNeighbor, -1)},
  };
}

std::vector<KeyBinding> OfBookmarks() {
  std::vector<KeyBinding> bindings;
  const auto key = [](int digit) { return static_cast<Key>(static_cast<int>(Key::digit_0) + digit); };
  for (int digit = 1; digit <= 9; ++digit)
    bindings.push_back({key(digit), plain, digit == 1 ? "go to bookmark 1 to 9" : "", With(RecallBookmark, digit)});
  for (int digit = 1; digit <= 9; ++digit)
    bindings.push_back(
        {key(digit), control, digit == 1 ? "save the view as bookmark 1 to 9" : "", With(KeepBookmark, digit)});
  return bindings;
}

std::vector<KeyBinding> All() {
  std::vector<KeyBinding> all;
  for (const auto& group : {Rendering(), WhatIsShown(), Editing(), Scenes(), CameraMoves(), Rays(), CrossSection(),
                            FalseColors(), ComparingAndTheRest(), OfBookmarks()})
    all.insert(all.end(), group.begin(), group.end());
  return all;
}

}  // namespace

const std::vector<KeyBinding>& KeyBindings() {
  static const std::vector<KeyBinding> bindings = All();
  return bindings;
}

std::vector<HelpRow> RowsOfHelp() {
  std::vector<HelpRow> rows{{"", "Mouse"}};
  for (const auto& [gesture, help] : gestures) rows.push_back({gesture, help});
  for (const KeyBinding& binding : KeyBindings()) {
    for (const Heading& heading : headings)
      if (heading.key == binding.key && heading.modifiers == binding.modifiers) rows.push_back({"", heading.text});
    const std::string key = NameOf(binding.key, binding.modifiers);
    if (*binding.help)
      rows.push_back({key, binding.help});
    else if (std::isdigit(static_cast<unsigned char>(key.back())))  // "Control+1-9"
      rows.back().keys = rows.back().keys.substr(0, rows.back().keys.find('-')) + "-" + key.back();
    else
      rows.back().keys += " " + key;
  }
  return rows;
}

std::vector<std::string> LinesOfHelp() { return HelpLines(RowsOfHelp()); }

}  // namespace ray
