#include <array>

#include "source/view/Viewer.h"
#include "source/view/overlay/SceneLines.h"

namespace ray {
namespace {

constexpr Modifiers plain{}, shift{true, false}, control{false, true};
constexpr double wider = 1.1;

/// What the pointer does, for the help.
constexpr std::array gestures{
    std::array{"left drag", "rotate about the pivot, or the center of the scene"},
    std::array{"Shift+left or middle drag", "zoom"},
    std::array{"Control+left drag", "pan"},
    std::array{"wheel", "zoom toward the point under the pointer"},
    std::array{"left click", "describe what is under the pointer"},
    std::array{"double click", "set the pivot to the point under the pointer"},
    std::array{"right click", "trace this pixel and show its rays; arrow keys step to the next pixel"},
    std::array{"right button held", "look around; W A S D Q E fly, Shift faster, Control slower, wheel sets the speed"},
    std::array{"file dropped", "open a scene or mesh, or use an image as the reference"},
};

}  // namespace

std::vector<Viewer::Binding> Viewer::MakeBindings() {
  const auto toggle = [](bool Viewer::*shows) {
    return [shows](Viewer& v) {
      v.*shows = !(v.*shows);
      v.InvalidateLines();
    };
  };
  const auto toggle_rays = [](ShownRays kind) {
    return [kind](Viewer& v) {
      v.rays_.Toggle(kind);
      v.section_lines_.reset();
      v.InvalidateLines();
    };
  };
  const auto live = [](std::optional<RenderMode> mode = {}) { return [mode](Viewer& v) { v.ToggleLive(mode); }; };
  const auto arrow = [](int right, int up) { return [right, up](Viewer& v) { v.MoveByArrow(right, up); }; };
  const auto step_bounce = [](int by) {
    return [by](Viewer& v) {
      v.rays_.StepBounce(by);
      v.InvalidateLines();
    };
  };
  const auto along = [](const R3::Vector& towards, const R3::Vector& up) {
    return [towards, up](Viewer& v) { v.navigator_.LookAlong(towards, up); };
  };

  std::vector<Binding> bindings{
      {Key::s, plain, "render the view and save the image", [](Viewer& v) { v.StartTrace(); }},
      {Key::escape, plain, "stop rendering; quit if nothing is being rendered", [](Viewer& v) { v.StopOrQuit(); }},
      {Key::q, plain, "quit", [](Viewer& v) { v.is_closed_ = true; }},
      {Key::p, plain, "toggle live rendering", live()},
      {Key::v, plain, "toggle the rendered image in space", toggle(&Viewer::shows_quad_)},
      {Key::c, plain, "print the camera as a scene-file line and copy it to the clipboard",
       [](Viewer& v) { v.PrintCamera(); }},
      {Key::space, plain, "", [](Viewer& v) { v.PrintCamera(); }},

      {Key::b, plain, "bounding boxes: none, scene graph, accelerator", [](Viewer& v) { v.CycleBoxes(); }},
      {Key::comma, plain, "bounding boxes one level up", [](Viewer& v) { v.ChangeBoxLevel(-1); }},
      {Key::period, plain, "bounding boxes one level down", [](Viewer& v) { v.ChangeBoxLevel(1); }},
      {Key::e, plain, "toggle edges", toggle(&Viewer::shows_edges_)},
      {Key::w, plain, "toggle faces", toggle(&Viewer::shows_faces_)},
      {Key::l, plain, "toggle lights", toggle(&Viewer::shows_lights_)},
      {Key::c, shift, "toggle the scene's camera", toggle(&Viewer::shows_camera_)},

      {Key::f, plain, "frame the whole scene", [](Viewer& v) { v.navigator_.Frame(v.navigator_.box()); }},
      {Key::f, shift, "frame the picked object", [](Viewer& v) { v.FramePicked(); }},
      {Key::t, plain, "toggle turntable rotation, which keeps the horizon level",
       [](Viewer& v) { v.navigator_.ToggleTurntable(); }},
      {Key::left_bracket, plain, "narrow the field of view", [](Viewer& v) { v.navigator_.Widen(1 / wider); }},
      {Key::right_bracket, plain, "widen the field of view", [](Viewer& v) { v.navigator_.Widen(wider); }},
      {Key::z, plain, "previous view", [](Viewer& v) { v.navigator_.Back(); }},
      {Key::z, shift, "next view", [](Viewer& v) { v.navigator_.Forward(); }},
      {Key::pad_1, plain, "look along -z", along({0, 0, -1}, {0, 1, 0})},
      {Key::pad_3, plain, "look along -x", along({-1, 0, 0}, {0, 1, 0})},
      {Key::pad_7, plain, "look along -y", along({0, -1, 0}, {0, 0, -1})},
      {Key::pad_0, plain, "the scene's camera", [](Viewer& v) { v.navigator_.Go(v.scene_->parsed.scene.camera); }},

      {Key::g, plain, "toggle the rays of every 25th pixel", [](Viewer& v) { v.ToggleGrid(); }},
      {Key::f2, plain, "toggle camera rays", toggle_rays(ShownRays::camera)},
      {Key::f3, plain, "toggle shadow rays", toggle_rays(ShownRays::shadow)},
      {Key::f4, plain, "toggle reflected and scattered rays", toggle_rays(ShownRays::reflection)},
      {Key::f5, plain, "toggle transmitted rays", toggle_rays(ShownRays::transmission)},
      {Key::f6, plain, "toggle normals at hit points",
       [](Viewer& v) {
         v.rays_.ToggleNormals();
         v.InvalidateLines();
       }},
      {Key::n, plain, "show one more bounce", step_bounce(1)},
      {Key::n, shift, "show one bounce fewer", step_bounce(-1)},
      {Key::o, plain, "save the rays as an .obj file", [](Viewer& v) { v.SaveRays(); }},
      {Key::backspace, plain, "clear the pixel's rays",
       [](Viewer& v) {
         v.rays_.ForgetPixel();
         v.InvalidateLines();
       }},
      {Key::left, plain, "step to the next pixel, or move the cross section", arrow(-1, 0)},
      {Key::right, plain, "", arrow(1, 0)},
      {Key::up, plain, "", arrow(0, 1)},
      {Key::down, plain, "", arrow(0, -1)},

      {Key::x, plain, "toggle the cross section",
       [](Viewer& v) {
         v.section_.Toggle();
         v.arrows_move_section_ = v.section_.IsShown();
         v.section_lines_.reset();
       }},
      {Key::x, shift, "plane of the cross section: camera row, xz, yz, xy",
       [](Viewer& v) {
         v.section_.NextPlane();
         v.arrows_move_section_ = true;
         v.section_lines_.reset();
       }},

      {Key::f7, plain, "live depth", live(RenderMode::depth)},
      {Key::f8, plain, "live normals", live(RenderMode::normal)},
      {Key::f9, plain, "live texture coordinates", live(RenderMode::uv)},
      {Key::f10, plain, "live primitive ids", live(RenderMode::id)},
      {Key::f11, plain, "live rays per pixel", live(RenderMode::rays)},
      {Key::f12, plain, "live cost per pixel", live(RenderMode::heat)},

      {Key::r, plain, "keep the rendered image as the reference", [](Viewer& v) { v.KeepReference(); }},
      {Key::tab, plain, "show the reference while held",
       [](Viewer& v) { v.Compare(TracedPictures::Comparing::reference); },
       [](Viewer& v) {
         if (v.pictures_.HowCompared() == TracedPictures::Comparing::reference)
           v.Compare(TracedPictures::Comparing::no);
       }},
      {Key::tab, shift, "toggle the difference from the reference",
       [](Viewer& v) { v.Compare(TracedPictures::Comparing::difference); }},
      {Key::up, control, "one stop brighter", [](Viewer& v) { v.ChangeExposure(1); }},
      {Key::down, control, "one stop darker", [](Viewer& v) { v.ChangeExposure(-1); }},
      {Key::digit_0, control, "reset the exposure", [](Viewer& v) { v.ChangeExposure(0); }},
      {Key::f1, plain, "save a screenshot", [](Viewer& v) { v.host_.SaveDrawing(); }},
      {Key::r, control, "reload the scene", [](Viewer& v) { v.Reload(); }},
      {Key::h, plain, "show this help, page by page", [](Viewer& v) { v.TurnHelpPage(); }},
      {Key::slash, plain, "", [](Viewer& v) { v.TurnHelpPage(); }},
      {Key::slash, shift, "", [](Viewer& v) { v.TurnHelpPage(); }},
  };
  for (int digit = 1; digit <= 9; ++digit) {
    const Key key = static_cast<Key>(static_cast<int>(Key::digit_0) + digit);
    bindings.push_back(
        {key, plain, digit == 1 ? "go to bookmark 1 to 9" : "", [digit](Viewer& v) { v.RecallBookmark(digit); }});
  }
  for (int digit = 1; digit <= 9; ++digit) {
    const Key key = static_cast<Key>(static_cast<int>(Key::digit_0) + digit);
    bindings.push_back({key, control, digit == 1 ? "save the view as bookmark 1 to 9" : "",
                        [digit](Viewer& v) { v.KeepBookmark(digit); }});
  }
  return bindings;
}

const std::vector<Viewer::Binding>& Viewer::Bindings() {
  static const std::vector<Binding> bindings = MakeBindings();
  return bindings;
}

std::vector<std::string> Viewer::Help() {
  std::vector<std::pair<std::string, std::string>> rows;
  for (const Binding& binding : Bindings()) {
    const std::string key = NameOf(binding.key, binding.modifiers);
    if (*binding.help)
      rows.emplace_back(key, binding.help);
    else
      rows.back().first += " " + key;
  }
  for (const auto& [gesture, help] : gestures) rows.emplace_back(gesture, help);
  std::vector<std::string> lines;
  constexpr std::size_t column = 26;
  for (auto& [keys, help] : rows) {
    if (keys.size() + 1 < column)
      keys.resize(column, ' ');
    else
      keys += "  ";
    lines.push_back(keys + help);
  }
  return lines;
}

}  // namespace ray
