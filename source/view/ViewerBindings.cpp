#include <array>

#include "source/view/Viewer.h"
#include "source/view/overlay/SceneLines.h"

namespace ray {
namespace {

constexpr Modifiers plain{}, shift{true, false}, control{false, true};
constexpr double wider = 1.1;

/// What the pointer does, for the help.
constexpr std::array gestures{
    std::array{"left drag", "turn about the pivot, or the middle of the scene"},
    std::array{"Shift+left or middle drag", "nearer and farther"},
    std::array{"Control+left drag", "move sideways with what is under the pointer"},
    std::array{"wheel", "towards what is under the pointer"},
    std::array{"left click", "tell what is under the pointer"},
    std::array{"double click", "put the pivot there"},
    std::array{"right click", "trace this pixel and show its rays; arrows go to the next one"},
    std::array{"right held", "look around; W A S D Q E fly, Shift faster, Control slower, wheel sets the speed"},
    std::array{"drop", "open a scene or a mesh, or take a picture as the reference"},
};

}  // namespace

std::vector<Viewer::Binding> Viewer::MakeBindings() {
  const auto toggle = [](bool Viewer::*shows) {
    return [shows](Viewer& v) {
      v.*shows = !(v.*shows);
      v.LinesHaveChanged();
    };
  };
  const auto toggle_rays = [](ShownRays kind) {
    return [kind](Viewer& v) {
      v.rays_.Toggle(kind);
      v.section_lines_.reset();
      v.LinesHaveChanged();
    };
  };
  const auto live = [](std::optional<RenderMode> mode = {}) { return [mode](Viewer& v) { v.ToggleLive(mode); }; };
  const auto arrow = [](int right, int up) { return [right, up](Viewer& v) { v.MoveByArrow(right, up); }; };
  const auto step_bounce = [](int by) {
    return [by](Viewer& v) {
      v.rays_.StepBounce(by);
      v.LinesHaveChanged();
    };
  };
  const auto along = [](const R3::Vector& towards, const R3::Vector& up) {
    return [towards, up](Viewer& v) { v.navigator_.LookAlong(towards, up); };
  };

  std::vector<Binding> bindings{
      {Key::s, plain, "trace the view and write the picture", [](Viewer& v) { v.StartTrace(); }},
      {Key::escape, plain, "stop the trace; without one, quit", [](Viewer& v) { v.StopOrQuit(); }},
      {Key::q, plain, "quit", [](Viewer& v) { v.is_closed_ = true; }},
      {Key::p, plain, "live picture on and off", live()},
      {Key::v, plain, "the traced picture in space on and off", toggle(&Viewer::shows_quad_)},
      {Key::c, plain, "print the camera as a line of a scene", [](Viewer& v) { v.PrintCamera(); }},
      {Key::space, plain, "", [](Viewer& v) { v.PrintCamera(); }},

      {Key::b, plain, "boxes: none, of nodes, of the accelerator", [](Viewer& v) { v.CycleBoxes(); }},
      {Key::comma, plain, "boxes one level up", [](Viewer& v) { v.ChangeBoxLevel(-1); }},
      {Key::period, plain, "boxes one level down", [](Viewer& v) { v.ChangeBoxLevel(1); }},
      {Key::e, plain, "edges on and off", toggle(&Viewer::shows_edges_)},
      {Key::w, plain, "faces on and off", toggle(&Viewer::shows_faces_)},
      {Key::l, plain, "lights on and off", toggle(&Viewer::shows_lights_)},
      {Key::c, shift, "the scene's camera on and off", toggle(&Viewer::shows_camera_)},

      {Key::f, plain, "frame the whole scene", [](Viewer& v) { v.navigator_.Frame(v.navigator_.TheBox()); }},
      {Key::f, shift, "frame what was clicked", [](Viewer& v) { v.FramePicked(); }},
      {Key::t, plain, "turntable: keep the horizon level", [](Viewer& v) { v.navigator_.ToggleTurntable(); }},
      {Key::left_bracket, plain, "narrower view", [](Viewer& v) { v.navigator_.Widen(1 / wider); }},
      {Key::right_bracket, plain, "wider view", [](Viewer& v) { v.navigator_.Widen(wider); }},
      {Key::z, plain, "the view before", [](Viewer& v) { v.navigator_.Back(); }},
      {Key::z, shift, "the view after", [](Viewer& v) { v.navigator_.Forward(); }},
      {Key::pad_1, plain, "look along -z", along({0, 0, -1}, {0, 1, 0})},
      {Key::pad_3, plain, "look along -x", along({-1, 0, 0}, {0, 1, 0})},
      {Key::pad_7, plain, "look along -y", along({0, -1, 0}, {0, 0, -1})},
      {Key::pad_0, plain, "the scene's own view", [](Viewer& v) { v.navigator_.Go(v.scene_->parsed.scene.camera); }},

      {Key::g, plain, "rays of every 25th pixel on and off", [](Viewer& v) { v.ToggleGrid(); }},
      {Key::f2, plain, "camera rays on and off", toggle_rays(ShownRays::camera)},
      {Key::f3, plain, "shadow rays on and off", toggle_rays(ShownRays::shadow)},
      {Key::f4, plain, "reflected and scattered rays on and off", toggle_rays(ShownRays::reflection)},
      {Key::f5, plain, "transmitted rays on and off", toggle_rays(ShownRays::transmission)},
      {Key::f6, plain, "normals where rays end on and off",
       [](Viewer& v) {
         v.rays_.ToggleNormals();
         v.LinesHaveChanged();
       }},
      {Key::n, plain, "one bounce more", step_bounce(1)},
      {Key::n, shift, "one bounce fewer", step_bounce(-1)},
      {Key::o, plain, "write the rays as an .obj file", [](Viewer& v) { v.SaveRays(); }},
      {Key::backspace, plain, "forget the pixel's rays",
       [](Viewer& v) {
         v.rays_.ForgetPixel();
         v.LinesHaveChanged();
       }},
      {Key::left, plain, "the next pixel, or the cut moved", arrow(-1, 0)},
      {Key::right, plain, "", arrow(1, 0)},
      {Key::up, plain, "", arrow(0, 1)},
      {Key::down, plain, "", arrow(0, -1)},

      {Key::x, plain, "cut through the scene on and off",
       [](Viewer& v) {
         v.section_.Toggle();
         v.arrows_move_section_ = v.section_.IsShown();
         v.section_lines_.reset();
       }},
      {Key::x, shift, "cut along the camera's row, xz, yz, xy",
       [](Viewer& v) {
         v.section_.NextPlane();
         v.arrows_move_section_ = true;
         v.section_lines_.reset();
       }},

      {Key::f7, plain, "depths, live", live(RenderMode::depth)},
      {Key::f8, plain, "normals, live", live(RenderMode::normal)},
      {Key::f9, plain, "texture coordinates, live", live(RenderMode::uv)},
      {Key::f10, plain, "primitives, live", live(RenderMode::id)},
      {Key::f11, plain, "how many rays pixels take, live", live(RenderMode::rays)},
      {Key::f12, plain, "what pixels cost, live", live(RenderMode::heat)},

      {Key::r, plain, "keep the traced picture as the reference", [](Viewer& v) { v.KeepReference(); }},
      {Key::tab, plain, "held: show the reference", [](Viewer& v) { v.Compare(TracedPictures::Comparing::reference); },
       [](Viewer& v) {
         if (v.pictures_.HowCompared() == TracedPictures::Comparing::reference)
           v.Compare(TracedPictures::Comparing::no);
       }},
      {Key::tab, shift, "show the difference from it",
       [](Viewer& v) { v.Compare(TracedPictures::Comparing::difference); }},
      {Key::up, control, "show twice the light", [](Viewer& v) { v.ChangeExposure(1); }},
      {Key::down, control, "show half the light", [](Viewer& v) { v.ChangeExposure(-1); }},
      {Key::digit_0, control, "show the light as it is", [](Viewer& v) { v.ChangeExposure(0); }},
      {Key::f1, plain, "write what is drawn", [](Viewer& v) { v.host_.SaveDrawing(); }},
      {Key::r, control, "read the scene again", [](Viewer& v) { v.Reload(); }},
      {Key::h, plain, "this help, page by page", [](Viewer& v) { v.TurnHelpPage(); }},
      {Key::slash, plain, "", [](Viewer& v) { v.TurnHelpPage(); }},
      {Key::slash, shift, "", [](Viewer& v) { v.TurnHelpPage(); }},
  };
  for (int digit = 1; digit <= 9; ++digit) {
    const Key key = static_cast<Key>(static_cast<int>(Key::digit_0) + digit);
    bindings.push_back(
        {key, plain, digit == 1 ? "go to the bookmark 1 to 9" : "", [digit](Viewer& v) { v.RecallBookmark(digit); }});
  }
  for (int digit = 1; digit <= 9; ++digit) {
    const Key key = static_cast<Key>(static_cast<int>(Key::digit_0) + digit);
    bindings.push_back({key, control, digit == 1 ? "keep the view as a bookmark 1 to 9" : "",
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
