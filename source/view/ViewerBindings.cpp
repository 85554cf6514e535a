#include <array>
#include <cctype>

#include "source/view/Viewer.h"
#include "source/view/overlay/SceneLines.h"

namespace ray {
namespace {

constexpr Modifiers plain{}, shift{true, false}, control{false, true}, both{true, true};
constexpr double wider = 1.1;
constexpr const char* no_rays = "no rays are shown; press G or right-click a pixel first";

/// What the pointer does, for the help.
constexpr std::array gestures{
    std::array{"left drag", "rotate about the pivot, or the center of the scene"},
    std::array{"Shift+left or middle drag", "zoom"},
    std::array{"Control+left drag", "pan"},
    std::array{"wheel", "zoom toward the point under the pointer; over the cross section, move its plane"},
    std::array{"left click", "describe what is under the pointer"},
    std::array{"double click", "set the pivot to the point under the pointer"},
    std::array{"Control+Shift+left drag", "move the chosen object or light along the axis of key A"},
    std::array{"right click", "trace this pixel and show its rays; arrow keys step to the next pixel"},
    std::array{"right button held", "look around; W A S D Q E fly, Shift faster, Control slower, wheel sets the speed"},
    std::array{"file dropped", "open a scene or mesh, or use an image as the reference"},
};

/// Where a group of keys begins in the table, for the help.
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

}  // namespace

/// What keys do, one function for each group of them.
struct Viewer::BindingTable {
  static auto Toggle(const char* what, bool Viewer::*shows) {
    return [what, shows](Viewer& v) {
      v.*shows = !(v.*shows);
      v.InvalidateLines();
      v.ShowMessage(std::string(what) + (v.*shows ? " on" : " off"));
    };
  }

  static auto ToggleRays(ShownRays kind) {
    return [kind](Viewer& v) { v.ToggleRays(kind); };
  }

  static auto Live(std::optional<RenderMode> mode = {}) {
    return [mode](Viewer& v) { v.ToggleLive(mode); };
  }

  static auto Arrow(int right, int up) {
    return [right, up](Viewer& v) { v.MoveByArrow(right, up); };
  }

  static auto StepBounce(int by) {
    return [by](Viewer& v) {
      if (v.rays_.Shown().empty()) return v.ShowMessage(no_rays);
      v.rays_.StepBounce(by);
      v.InvalidateLines();
      const int deepest = v.rays_.Look().deepest;
      v.ShowMessage(deepest < 0 ? "rays of all bounces" : "rays of up to " + std::to_string(deepest) + " bounces");
    };
  }

  static auto Along(const R3::Vector& towards, const R3::Vector& up, const char* name) {
    return [towards, up, name](Viewer& v) {
      v.navigator_.LookAlong(towards, up);
      v.ShowMessage(std::string("looking along ") + name + " at the " + (v.navigator_.Pivot() ? "pivot" : "scene"));
    };
  }

  static auto Widen(double factor) {
    return [factor](Viewer& v) {
      v.navigator_.Widen(factor);
      v.ShowMessage("field of view " + v.AngleInWords());
    };
  }

  static std::vector<Binding> Rendering() {
    return {
        {Key::s, plain, "render the view and save the image", [](Viewer& v) { v.StartTrace(); }},
        {Key::i, plain,
         "the rendered image flat: wheel zooms, drag moves, Shift+drag slides against reference or preview",
         [](Viewer& v) { v.ToggleFlat(); }},
        {Key::escape, plain,
         "close the help or the flat image, forget the pick, close the cross section, stop rendering",
         [](Viewer& v) { v.Peel(); }},
        {Key::q, plain, "quit; while a picture is being rendered, when pressed twice", [](Viewer& v) { v.Quit(); }},
        {Key::p, plain, "toggle live rendering", Live()},
        {Key::m, plain, "toggle denoising, of images that get all their samples",
         [](Viewer& v) { v.ToggleDenoising(); }},
        {Key::v, plain, "toggle the rendered image in space", Toggle("rendered image in space", &Viewer::shows_quad_)},
        {Key::c, plain, "print the camera as a scene-file line and copy it to the clipboard",
         [](Viewer& v) { v.PrintCamera(); }},
        {Key::space, plain, "", [](Viewer& v) { v.PrintCamera(); }},
    };
  }

  static std::vector<Binding> WhatIsShown() {
    return {
        {Key::tab, plain, "toggle the panels: scene, picked pixel, settings, statistics",
         [](Viewer& v) { v.TogglePanels(); }},
        {Key::b, plain, "bounding boxes: none, scene graph, accelerator", [](Viewer& v) { v.CycleBoxes(); }},
        {Key::comma, plain, "bounding boxes one level up", [](Viewer& v) { v.ChangeBoxLevel(-1); }},
        {Key::period, plain, "bounding boxes one level down", [](Viewer& v) { v.ChangeBoxLevel(1); }},
        {Key::e, plain, "toggle edges", Toggle("edges", &Viewer::shows_edges_)},
        {Key::w, plain, "toggle faces", Toggle("faces", &Viewer::shows_faces_)},
        {Key::l, plain, "toggle lights; F frames them as well", [](Viewer& v) { v.ToggleLights(); }},
        {Key::l, shift, "toggle shadows of the preview, from as many of the strongest lights as there is room for",
         Toggle("shadows", &Viewer::shows_shadows_)},
        {Key::c, shift, "toggle the scene's camera", Toggle("the scene's camera", &Viewer::shows_camera_)},
    };
  }

  static std::vector<Binding> CameraMoves() {
    return {
        {Key::f, plain, "frame the whole scene", [](Viewer& v) { v.FrameScene(); }},
        {Key::f, shift, "frame the picked object", [](Viewer& v) { v.FramePicked(); }},
        {Key::t, plain, "rotation as a turntable, with a level horizon, or freely",
         [](Viewer& v) {
           v.navigator_.ToggleTurntable();
           v.ShowMessage(v.navigator_.IsTurntable() ? "rotates as a turntable" : "rotates freely");
         }},
        {Key::left_bracket, plain, "narrow the field of view", Widen(1 / wider)},
        {Key::right_bracket, plain, "widen the field of view", Widen(wider)},
        {Key::z, plain, "previous view",
         [](Viewer& v) { v.ShowMessage(v.navigator_.Back() ? "back to the view before" : "there is no view before"); }},
        {Key::z, shift, "next view",
         [](Viewer& v) { v.ShowMessage(v.navigator_.Forward() ? "on to the view after" : "there is no view after"); }},
        {Key::pad_1, plain, "look along -z", Along({0, 0, -1}, {0, 1, 0}, "-z")},
        {Key::pad_3, plain, "look along -x", Along({-1, 0, 0}, {0, 1, 0}, "-x")},
        {Key::pad_7, plain, "look along -y", Along({0, -1, 0}, {0, 0, -1}, "-y")},
        {Key::pad_0, plain, "the scene's camera",
         [](Viewer& v) {
           v.navigator_.Go(v.scene_->parsed.scene.camera);
           v.ShowMessage("back at the scene's camera");
         }},
    };
  }

  static std::vector<Binding> Rays() {
    return {
        {Key::g, plain, "toggle the rays of every 25th pixel", [](Viewer& v) { v.ToggleGrid(); }},
        {Key::f2, plain, "toggle camera rays", ToggleRays(ShownRays::camera)},
        {Key::f3, plain, "toggle shadow rays", ToggleRays(ShownRays::shadow)},
        {Key::f4, plain, "toggle reflected and scattered rays", ToggleRays(ShownRays::reflection)},
        {Key::f5, plain, "toggle transmitted rays", ToggleRays(ShownRays::transmission)},
        {Key::f6, plain, "toggle normals at hit points", [](Viewer& v) { v.ToggleNormals(); }},
        {Key::n, plain, "show one more bounce", StepBounce(1)},
        {Key::n, shift, "show one bounce fewer", StepBounce(-1)},
        {Key::o, plain, "save the rays as an .obj file", [](Viewer& v) { v.SaveRays(); }},
        {Key::backspace, plain, "clear the pixel's rays",
         [](Viewer& v) {
           if (!v.rays_.Pixel()) return v.ShowMessage("no pixel's rays are shown; right-click a pixel first");
           v.rays_.ForgetPixel();
           v.InvalidateLines();
           v.ShowMessage("the pixel's rays are cleared");
         }},
        {Key::left, plain, "step to the next pixel, or move the cross section", Arrow(-1, 0)},
        {Key::right, plain, "", Arrow(1, 0)},
        {Key::up, plain, "", Arrow(0, 1)},
        {Key::down, plain, "", Arrow(0, -1)},
    };
  }

  static std::vector<Binding> CrossSection() {
    return {
        {Key::x, plain, "toggle the cross section", [](Viewer& v) { v.ToggleSection(); }},
        {Key::x, shift, "plane of the cross section: camera row, xz, yz, xy",
         [](Viewer& v) {
           v.section_.NextPlane();
           v.arrows_move_section_ = true;
           v.section_drawing_.reset();
           if (v.section_.IsShown()) v.MakeSection();
           v.ShowMessage("cross section: " + v.section_.Describe(v.size_.height));
         }},
    };
  }

  static std::vector<Binding> FalseColors() {
    return {
        {Key::f7, plain, "live depth", Live(RenderMode::depth)},
        {Key::f8, plain, "live normals", Live(RenderMode::normal)},
        {Key::f9, plain, "live texture coordinates", Live(RenderMode::uv)},
        {Key::f10, plain, "live primitive ids", Live(RenderMode::id)},
        {Key::f11, plain, "live rays per pixel", Live(RenderMode::rays)},
        {Key::f12, plain, "live cost per pixel", Live(RenderMode::heat)},
    };
  }

  static std::vector<Binding> ComparingAndTheRest() {
    return {
        {Key::r, plain, "keep the rendered image as the reference", [](Viewer& v) { v.KeepReference(); }},
        {Key::r, shift, "show the reference while held",
         [](Viewer& v) { v.Compare(TracedPictures::Comparing::reference); },
         [](Viewer& v) {
           if (v.pictures_.HowCompared() != TracedPictures::Comparing::reference) return;
           v.Compare(TracedPictures::Comparing::no);
         }},
        {Key::d, plain, "toggle the difference from the reference",
         [](Viewer& v) { v.Compare(TracedPictures::Comparing::difference); }},
        {Key::d, shift, "the difference in false colors with their scale; pressed again, FLIP",
         [](Viewer& v) {
           v.Compare(v.pictures_.HowCompared() == TracedPictures::Comparing::false_colors
                         ? TracedPictures::Comparing::flip
                         : TracedPictures::Comparing::false_colors);
         }},
        {Key::page_down, control, "flip through the images made so far: the next, or the current one",
         [](Viewer& v) { v.FlipImages(1); }},
        {Key::page_up, control, "the one before", [](Viewer& v) { v.FlipImages(-1); }},
        {Key::up, control, "one stop brighter", [](Viewer& v) { v.ChangeExposure(1); }},
        {Key::down, control, "one stop darker", [](Viewer& v) { v.ChangeExposure(-1); }},
        {Key::up, both, "a quarter of a stop brighter", [](Viewer& v) { v.ChangeExposure(0.25); }},
        {Key::down, both, "a quarter of a stop darker", [](Viewer& v) { v.ChangeExposure(-0.25); }},
        {Key::digit_0, control, "reset the exposure", [](Viewer& v) { v.ChangeExposure(0); }},
        {Key::f1, plain, "save a screenshot", [](Viewer& v) { v.host_.SaveDrawing(); }},
        {Key::r, control, "reload the scene", [](Viewer& v) { v.ReadFromDisk(); }},
        {Key::h, plain, "this help, which can be searched", [](Viewer& v) { v.ToggleHelp(); }},
        {Key::slash, plain, "", [](Viewer& v) { v.ToggleHelp(); }},
        {Key::slash, shift, "", [](Viewer& v) { v.ToggleHelp(); }},
    };
  }

  static std::vector<Binding> Editing() {
    const auto edit = [](auto what) { return [what](Viewer& v) { what(v.editor_, v); }; };
    const auto move = [&](double steps) {
      return edit([steps](SceneEditor& e, Viewer& v) { e.MoveBySteps(v, steps); });
    };
    constexpr double many = 10;
    return {
        {Key::a, plain, "the axis that the chosen object or light moves along: x, y, z, the plane facing the camera",
         edit([](SceneEditor& e, Viewer& v) { e.NextAxis(v); })},
        {Key::equal, plain, "move it forward along the axis; with Shift ten steps", move(1)},
        {Key::equal, shift, "", move(many)},
        {Key::minus, plain, "move it backward along the axis; with Shift ten steps", move(-1)},
        {Key::minus, shift, "", move(-many)},
        {Key::d, control, "duplicate it", edit([](SceneEditor& e, Viewer& v) { e.Duplicate(v); })},
        {Key::del, plain, "delete it", edit([](SceneEditor& e, Viewer& v) { e.Delete(v); })},
        {Key::k, plain, "focus the lens on the point under the pointer", [](Viewer& v) { v.FocusUnderPointer(); }},
        {Key::k, shift, "make the view the scene's camera", edit([](SceneEditor& e, Viewer& v) { e.KeepCamera(v); })},
        {Key::z, control, "undo", edit([](SceneEditor& e, Viewer& v) { e.Undo(v); })},
        {Key::y, control, "redo", edit([](SceneEditor& e, Viewer& v) { e.Redo(v); })},
        {Key::z, both, "", edit([](SceneEditor& e, Viewer& v) { e.Redo(v); })},
        {Key::s, control, "save the changed lines into the scene's files",
         edit([](SceneEditor& e, Viewer& v) { e.Save(v); })},
        {Key::s, both, "save the changed scene as a copy beside it",
         edit([](SceneEditor& e, Viewer& v) { e.SaveCopy(v); })},
    };
  }

  static std::vector<Binding> Scenes() {
    return {
        {Key::o, control, "list the scenes to open: of this folder, and recent ones",
         [](Viewer& v) { v.ToggleSceneList(); }},
        {Key::page_down, plain, "open the next scene of the folder", [](Viewer& v) { v.OpenNeighbor(1); }},
        {Key::page_up, plain, "open the previous scene of the folder", [](Viewer& v) { v.OpenNeighbor(-1); }},
    };
  }

  static std::vector<Binding> OfBookmarks() {
    std::vector<Binding> bindings;
    const auto key = [](int digit) { return static_cast<Key>(static_cast<int>(Key::digit_0) + digit); };
    for (int digit = 1; digit <= 9; ++digit)
      bindings.push_back({key(digit), plain, digit == 1 ? "go to bookmark 1 to 9" : "",
                          [digit](Viewer& v) { v.RecallBookmark(digit); }});
    for (int digit = 1; digit <= 9; ++digit)
      bindings.push_back({key(digit), control, digit == 1 ? "save the view as bookmark 1 to 9" : "",
                          [digit](Viewer& v) { v.KeepBookmark(digit); }});
    return bindings;
  }

  static std::vector<Binding> All() {
    std::vector<Binding> all;
    for (const auto& group : {Rendering(), WhatIsShown(), Editing(), Scenes(), CameraMoves(), Rays(), CrossSection(),
                              FalseColors(), ComparingAndTheRest(), OfBookmarks()})
      all.insert(all.end(), group.begin(), group.end());
    return all;
  }
};

const std::vector<Viewer::Binding>& Viewer::Bindings() {
  static const std::vector<Binding> bindings = BindingTable::All();
  return bindings;
}

std::vector<HelpRow> Viewer::HelpRows() {
  std::vector<HelpRow> rows{{"", "Mouse"}};
  for (const auto& [gesture, help] : gestures) rows.push_back({gesture, help});
  for (const Binding& binding : Bindings()) {
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

std::vector<std::string> Viewer::Help() { return HelpLines(HelpRows()); }

}  // namespace ray
