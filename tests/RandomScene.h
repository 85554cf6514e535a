#pragma once

#include <array>
#include <charconv>
#include <map>
#include <string>
#include <vector>

#include "R3/ShapeKind.h"
#include "source/scene/Light.h"
#include "tests/BoundedShapes.h"
#include "tests/Draw.h"

/// A scene file of anything that the language has, drawn at random; what shapes and lights there are it takes from
/// their tables. In one of three, things stand on a lattice, so that they share faces, edges and corners, seen from
/// frames that round differently.
class RandomScene {
 public:
  struct Light {
    double brightness = 1;    // all that shines is this many times brighter, and the scene otherwise the same
    bool is_furnace = false;  // only an even gray sky of 1 shines, on surfaces that give back no more than they get
  };

  RandomScene(std::uint64_t seed, const Light& light) : draw_(seed), light_(light), touches_(seed % 3 == 2) {
    AddFiles();
    AddSurroundings();
    for (int i = draw_.Whole(1, 4); i > 0; --i) AddMaterial();
    for (int i = draw_.Whole(1, 4); i > 0; --i) AddLight();
    // Without scales too, so that more than one shape is in view.
    AddGroup(3, draw_.Whole(0, 1) ? 0 : draw_.Between(0, 2));
  }

  std::string text;                          // of the scene
  std::map<std::string, std::string> files;  // that it names: meshes and pictures

 private:
  void AddFiles() {
    files["texture.ppm"] = Picture(4, 4, 1);
    if (!light_.is_furnace && Chance(0.3)) files["sky.pfm"] = Picture(8, 4, light_.brightness);
    for (const char* name : {"a.obj", "b.obj"}) files[name] = Ball(draw_.Whole(3, 7), draw_.Whole(3, 5));
  }

  void AddSurroundings() {
    if (Chance(0.5))
      Add("camera", {0, 0, 6, 0, 0, -1, draw_.Between(-0.5, 0.5), 1, 0, draw_.Between(0.1, 1.4), 0.1, 100});
    if (Chance(0.2)) Add("view", {draw_.Between(0, 2), draw_.Between(-0.5, 0.5), draw_.Between(-0.5, 0.5)});
    if (Chance(0.1)) Add("shadow_bias", {draw_.Scale(-6, -1)});
    if (light_.is_furnace) return Add("background", {1, 1, 1});
    Color("background");
    Color("ambient");
    if (files.contains("sky.pfm")) text += "environment sky.pfm\n";
  }

  /// Less than 1 together where nothing may be added to light.
  void AddMaterial() {
    const double most = light_.is_furnace ? 1.0 / 3 : 1;
    text += "material";
    Reflectance(light_.is_furnace ? 0 : 1);
    for (int i = 0; i < 3; ++i) Reflectance(Chance(0.6) ? most : 0);  // kd, ks, kt
    Shining(!light_.is_furnace && Chance(0.2) ? 1 : 0);
    Numbers({draw_.Whole(0, 3) ? draw_.Whole(0, 60) : draw_.Scale(-2, 4), Chance(0.3) ? 1 : draw_.Between(0.5, 2.5)});
    text += Chance(0.3) ? " texture.ppm\n" : " 0\n";
    const std::string id = " " + std::to_string(materials_++);
    if (Chance(0.2)) text += "absorb" + id, Reflectance(1), text += '\n';
    if (Chance(0.2)) text += "bump" + id + " texture.ppm", Numbers({draw_.Between(-1, 1)}), text += '\n';
    if (Chance(0.2)) text += "texture_ambient" + id + '\n';
    if (touches_ && Chance(0.3))
      text += "priority" + id, Numbers({static_cast<double>(draw_.Whole(0, 2))}), text += '\n';
    if (light_.is_furnace) return;
    if (Chance(0.2)) text += "mirror" + id, Reflectance(1), text += '\n';
    if (Chance(0.2)) text += "coat" + id, Numbers({draw_.Between(1, 2)}), text += '\n';
    if (Chance(0.2)) text += "flat_color" + id, Reflectance(1), text += '\n';
  }

  void AddLight() {
    if (light_.is_furnace) return Add("point_light", {0, 0, 0, 0, 9, 0, 1, 0, 0});  // none is no default ones
    const auto kinds = ray::LightKinds();
    const auto& kind = *kinds[static_cast<std::size_t>(draw_.Whole(0, static_cast<int>(kinds.size()) - 1))];
    text += kind.name;
    Shining(Chance(0.9) ? 1 : 0);
    for (std::size_t i = 3; i < kind.arguments.size(); ++i) AddArgument(kind.arguments[i], kind.example[i]);
    text += '\n';
  }

  /// Sizes keep their proportions, without which some shapes are none; groups change them.
  void AddShape() {
    const auto kinds = JudgedShapeKinds();
    const int which = draw_.Whole(0, static_cast<int>(kinds.size()) + 1);
    if (which >= static_cast<int>(kinds.size())) {
      text +=
          std::string("mesh") + Material() + (Chance(0.5) ? " a.obj" : " b.obj") + (Chance(0.5) ? " smooth\n" : "\n");
      return;
    }
    const R3::ShapeKind& kind = *kinds[static_cast<std::size_t>(which)];
    text += kind.name + Material();
    for (std::size_t i = 0; i < kind.arguments.size(); ++i)
      if (kind.arguments[i].may_be_negative)
        AddArgument(kind.arguments[i], kind.example[i]);
      else
        Numbers({kind.example[i]});
    text += '\n';
  }

  void AddGroup(int levels, double powers) {
    if (touches_ && Chance(0.5)) return AddTurnedBack(levels);
    text += "begin" + Material();
    const R3::Matrix transform = !touches_ && Chance(0.7) ? draw_.Affine(powers) : R3::Matrix{};
    for (const auto& row : transform.m) Numbers({row[0], row[1], row[2], row[3]});
    text += " 0 0 0 1\n";
    if (!touches_ && Chance(0.2)) Add("motion", {draw_.Between(-1, 1), draw_.Between(-1, 1), draw_.Between(-1, 1)});
    for (int i = draw_.Whole(1, 4); i > 0; --i)
      if (levels > 0 && Chance(0.4))
        AddGroup(levels - 1, powers);
      else
        AddShape();
    text += "end\n";
  }

  /// A group that is turned, and one in it that is turned back.
  void AddTurnedBack(int levels) {
    const R3::Matrix turn = draw_.Rotation();
    for (const bool back : {false, true}) {
      text += "begin" + Material();
      for (std::size_t i = 0; i < 3; ++i)
        back ? Numbers({turn.m[0][i], turn.m[1][i], turn.m[2][i], 0})
             : Numbers({turn.m[i][0], turn.m[i][1], turn.m[i][2], 0});
      text += " 0 0 0 1\n";
    }
    for (int i = draw_.Whole(1, 4); i > 0; --i)
      if (levels > 0 && Chance(0.3))
        AddGroup(levels - 1, 0);
      else
        AddShape();
    text += "end end\n";
  }

  void AddArgument(const R3::Argument& argument, double example) {
    if (!argument.may_be_negative) return Numbers({example * draw_.Scale(-0.5, 0.5)});
    Numbers({example + (touches_ ? 0.5 * draw_.Whole(-2, 2) : draw_.Between(-1, 1))});
  }

  bool Chance(double probability) { return draw_.Between(0, 1) < probability; }
  std::string Material() { return " " + std::to_string(draw_.Whole(-1, materials_ - 1)); }
  void Add(const std::string& command, const std::vector<double>& numbers) {
    text += command;
    Numbers(numbers);
    text += '\n';
  }
  void Color(const std::string& command) {
    text += command;
    Shining(1);
    text += '\n';
  }
  void Reflectance(double most) {
    const double gray = draw_.Between(0, most);
    const double red = draw_.Between(0, most), green = draw_.Between(0, most), blue = draw_.Between(0, most);
    if (light_.is_furnace)
      Numbers({gray, gray, gray});
    else
      Numbers({red, green, blue});
  }
  void Shining(double most) {
    const double red = draw_.Between(0, most), green = draw_.Between(0, most), blue = draw_.Between(0, most);
    Numbers({light_.brightness * red, light_.brightness * green, light_.brightness * blue});
  }
  void Numbers(const std::vector<double>& numbers) {
    for (const double number : numbers) text += " " + Word(number);
  }
  /// The shortest that reads as the same number.
  static std::string Word(double number) {
    std::array<char, 32> word{};
    return {word.data(), std::to_chars(word.data(), word.data() + word.size(), number).ptr};
  }

  /// A .pfm of random values below `most`, gray in a furnace, under whatever name.
  std::string Picture(int width, int height, double most) {
    std::string bytes = "PF\n" + std::to_string(width) + " " + std::to_string(height) + "\n-1\n";
    auto value = static_cast<float>(most);
    for (int i = 0; i < 3 * width * height; ++i) {
      if (!light_.is_furnace || i % 3 == 0) value = static_cast<float>(most * draw_.Between(0, 1));
      bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    return bytes;
  }

  /// A bumpy ball with normals that are not those of its triangles, and texture coordinates.
  std::string Ball(int sides, int rings) {
    std::string obj;
    for (int ring = 0; ring <= rings; ++ring)
      for (int side = 0; side < sides; ++side) {
        const double a = 3.14 * ring / rings, b = 6.28 * side / sides, r = draw_.Between(0.8, 1.2);
        const std::vector<double> at{r * std::sin(a) * std::cos(b), r * std::cos(a), r * std::sin(a) * std::sin(b)};
        for (const char* word : {"\nv", "\nvn"}) {
          obj += word;
          for (const double x : at) obj += " " + Word(x);
        }
        obj += "\nvt " + Word(draw_.Between(-2, 2)) + " " + Word(draw_.Between(-2, 2));
      }
    const auto corner = [&](int ring, int side) {
      const std::string index = std::to_string(ring * sides + side % sides + 1);
      return " " + index + "/" + index + "/" + index;
    };
    for (int ring = 0; ring < rings; ++ring)
      for (int side = 0; side < sides; ++side)
        obj +=
            "\nf" + corner(ring, side) + corner(ring, side + 1) + corner(ring + 1, side + 1) + corner(ring + 1, side);
    return obj + "\n";
  }

  Draw draw_;
  Light light_;
  bool touches_;
  int materials_ = 0;
};
