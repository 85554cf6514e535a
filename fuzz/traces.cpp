// Scenes that are right, of every shape and of extreme numbers: each accelerator must give the picture of none, to the
// bit, and no pixel may be other than a number.
#include <tbb/global_control.h>

#include <cmath>

#include "fuzz/Fuzz.h"
#include "source/render/Render.h"

namespace {

/// Takes decisions from the input; 0 once it is used up.
class Choices {
 public:
  explicit Choices(fuzz::Bytes bytes) : bytes_(bytes) {}

  bool IsOver() const { return at_ >= bytes_.size(); }
  unsigned Byte() { return IsOver() ? 0 : bytes_[at_++]; }
  std::string Number() {
    static const char* const numbers[] = {
        "0",     "1",     "-1",   "0.5",  "-0.5", "2",    "-2",   "1e-3",
        "-1e-3", "1e-9",  "1e3",  "-1e3", "1e6",  "-1e6", "1e-6", "0.3333333333333333",
        "1e9",   "1e-30", "1e30", "-0"};
    const unsigned byte = Byte();
    if (byte < std::size(numbers)) return numbers[byte];
    return std::to_string((static_cast<int>(byte) - 138) / 16.0);
  }
  std::string Size() {
    const std::string number = Number();
    return number[0] == '-' ? number.substr(1) : number;
  }

 private:
  fuzz::Bytes bytes_;
  std::size_t at_ = 0;
};

std::string Formula(Choices& choices) {
  static const char* const formulas[] = {"x^2 + y^2 + z^2 - 1",  "sin(4 x) + sin(4 y) + sin(4 z)",
                                         "x y z",                "sqrt(x) - y",
                                         "1 / x + y",            "max(abs(x), abs(y)) - 1",
                                         "exp(x) - log(y) - z",  "(x^2 + y^2 - z^2)^2 - 1e-6"};
  return formulas[choices.Byte() % std::size(formulas)] + (" - 0 " + choices.Size());
}

std::string SceneOf(Choices& choices) {
  std::string text = "camera 0.3 0.2 4  -0.05 -0.03 -1  0 1 0  0.5  0.1 100\nbackground 0.2 0.3 0.4\n";
  text += "material 0.1 0.1 0.1  0.5 0.4 0.3  0.2 0.2 0.2  0.2 0.2 0.2  0.1 0 0  10 1.5 0\n";
  text += "material 0.1 0.1 0.1  0.5 0.4 0.3  0.2 0.2 0.2  0.2 0.2 0.2  0 0 0  10 1.5 0\n";  // csg cannot emit
  text += choices.Byte() % 2 ? "point_light 1 1 1  2 3 4  1 0 0\n" : "sphere_light 1 1 1  2 3 4  0.5  1 0 0\n";
  int open = 0;
  for (int i = 0; i < 24 && !choices.IsOver(); ++i) {
    const unsigned kind = choices.Byte() % 14;
    const auto add = [&](const char* command, const char* arguments) {
      text += command;
      for (const char* a = arguments; *a; ++a) text += " " + (*a == 's' ? choices.Size() : choices.Number());
      text += '\n';
    };
    if (kind == 0) add("sphere 0", "nnns");
    if (kind == 1) add("box 0", "nnnnnn");
    if (kind == 2) add("cylinder 0", "nnnss");
    if (kind == 3) add("cone 0", "nnnss");
    if (kind == 4) add("tri 0", "nnnnnnnnn");
    if (kind == 5) text += "torus 0 " + choices.Number() + " 0 0  1 0.25\n";
    if (kind == 6) add("plane 0", "nnnnnn");
    if (kind == 7 && open < 4) add("begin 0", "nnnnnnnnnnnn"), text.insert(text.size() - 1, " 0 0 0 1"), ++open;
    if (kind == 8 && open > 0) text += "end\n", --open;
    if (kind == 9) add("paraboloid 0", "nnnss");
    if (kind == 10) add("blob 0 0.5", "nnnsnnnnsnnnnsn");
    if (kind == 11) add(choices.Byte() % 2 ? "bezier 0" : "bspline 0", std::string(48, 'n').c_str());
    if (kind == 12) text += "implicit 0 \"" + Formula(choices) + "\"", add("", "nnnnnn");
    // Solids alone, so that it is one.
    if (kind == 13) {
      static const char* const operations[] = {"union", "intersection", "difference"};
      text += std::string("csg ") + operations[choices.Byte() % 3] + " 1\n";
      add("sphere 1", "nnns"), add("box 1", "nnnnnn"), add("cylinder 1", "nnnss");
      text += "end\n";
    }
  }
  for (; open > 0; --open) text += "end\n";
  return text;
}

}  // namespace

int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  // Scenes are too small for threads to be worth their waking.
  static const tbb::global_control permission(tbb::global_control::max_allowed_parallelism, 1);
  Choices choices({data, size});
  ray::RenderSettings settings;
  settings.width = settings.height = 8;
  settings.threads = 1;
  settings.mode = choices.Byte() % 2 ? ray::RenderMode::path : ray::RenderMode::whitted;
  settings.trace.fresnel = choices.Byte() % 2;
  settings.trace.shadow_samples = 1;
  const std::string text = SceneOf(choices);
  try {
    const fuzz::Bytes bytes{reinterpret_cast<const unsigned char*>(text.data()), text.size()};
    const ray::ParsedScene parsed = ray::Parse(fuzz::FileOf("input.scn", bytes), {});
    const ray::World world(parsed.scene);
    const auto picture_by = [&](const char* kind) {
      const auto accelerator = ray::FindAcceleratorKind(kind)->Make(world, {.name = kind});
      return ray::Render(world, *accelerator, settings).image;
    };
    const R2::Image expected = picture_by("none");
    for (const float channel : expected.Channels())
      if (!std::isfinite(channel)) std::abort();
    for (const char* kind : {"graph", "grid", "octree", "bvh"})
      if (!(picture_by(kind) == expected)) std::abort();
  } catch (const ray::SceneErrors&) {  // a size of zero, a plane without a normal
  }
  return 0;
}
