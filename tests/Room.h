#pragma once

#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "R3/Matrix.h"
#include "R3/Point.h"
#include "tests/Draw.h"

/// A closed room drawn at random, as a scene of one kind of walls, and places in it to aim at: its corners, its edges
/// and its faces. Nothing is outside of it.
class Room {
 public:
  static constexpr std::array kinds{"box", "boxes", "plane", "quad", "polygon", "tri", "mesh", "concave"};

  /// `frame` places it.
  Room(Draw& draw, const std::string& kind, const R3::Matrix& frame) : draw_(draw), frame_(frame) {
    for (int axis = 0; axis < 3; ++axis) {
      low_[axis] = Round(draw.Between(-3, -1)), high_[axis] = Round(draw.Between(1, 3));
    }
    MakePrism(kind == "concave");
    text = "material 0 0 0  .5 .5 .5  .4 .4 .4  0 0 0  0 0 0  10 1 0 point_light 1 1 1 0 0 0 1 0 0\nbegin 0";
    for (const auto& row : frame.m) Say({row[0], row[1], row[2], row[3]});
    text += " 0 0 0 1\n";
    if (kind == "box") {
      Add("box 0", {low_[0], low_[1], low_[2], high_[0], high_[1], high_[2]});
    } else if (kind == "boxes") {
      AddBoxes();
    } else if (kind == "plane") {
      AddPlanes();
    } else {
      AddWalls(kind);
    }
    text += "end\n";
  }

  std::string text;
  std::string mesh;  // the content of the file room.off, if the scene names it

  /// Places in the world. What is between those inside and any other is free, unless the room is concave.
  R3::Point Inside() { return frame_ * (R3::Point{} + draw_.Between(0, 0.5) * draw_.Direction()); }
  R3::Point OnSeam() {
    const auto& [a, b] = edges_[static_cast<std::size_t>(draw_.Whole(0, static_cast<int>(edges_.size()) - 1))];
    const int where = draw_.Whole(0, 9);
    const double share = where == 0 ? 0 : where == 1 ? 0.5 : draw_.Between(0, 1);
    return frame_ * (a + share * (b - a));
  }
  R3::Point OnWall() {
    const auto& face = faces_[static_cast<std::size_t>(draw_.Whole(0, static_cast<int>(faces_.size()) - 1))];
    const double u = draw_.Between(0, 1), v = draw_.Between(0, 1);
    const bool flip = u + v > 1;
    const double a = flip ? 1 - u : u, b = flip ? 1 - v : v;
    return frame_ * (face[0] + a * (face[1] - face[0]) + b * (face[2] - face[0]));
  }

  /// Whether a ray runs along a wall that it starts on. Two such rays in a row are one of 2^26 cases, in which
  /// R3/Departure.h promises nothing; drawn on purpose they are many.
  bool IsAlongWall(const R3::Point& from, const R3::Vector& direction) const {
    const double size = Length(frame_ * R3::Vector{1, 0, 0});
    const double rounding = 0x1p-40 * MaxComponent(Abs(FromOrigin(from)));
    for (const auto& face : faces_) {
      const R3::Point a = frame_ * face[0], b = frame_ * face[1], c = frame_ * face[2];
      const R3::Vector n = Unit(Cross(b - a, c - a));
      if (std::abs(Dot(n, from - a)) < 1e-3 * size && std::abs(Dot(n, Unit(direction))) < 0x1p-13 + rounding / size)
        return true;
    }
    return false;
  }

 private:
  static double Round(double x) { return std::round(x * 64) / 64; }  // seams are where several coordinates are the same

  void Say(std::initializer_list<double> numbers) {
    char number[32];
    for (const double x : numbers) {
      std::snprintf(number, sizeof number, " %.17g", x);
      text += number;
    }
  }
  void Add(const std::string& command, std::initializer_list<double> numbers) {
    text += command;
    Say(numbers);
    text += '\n';
  }

  /// An upright prism: over a rectangle, or over a star.
  void MakePrism(bool is_star) {
    const int corners = is_star ? draw_.Whole(5, 9) : 4;
    for (int i = 0; i < corners; ++i) {
      if (!is_star) {
        base_.push_back({i == 0 || i == 3 ? low_[0] : high_[0], i < 2 ? low_[2] : high_[2]});
        continue;
      }
      const double angle = 6.283185307179586 * i / corners, radius = draw_.Between(0.8, 3);
      base_.push_back({Round(radius * std::cos(angle)), Round(radius * std::sin(angle))});
    }
    const auto at = [&](int i, double y) {
      const auto& corner = base_[static_cast<std::size_t>(i % corners)];
      return R3::Point{corner[0], y, corner[1]};
    };
    for (int i = 0; i < corners; ++i) {
      const R3::Point a = at(i, low_[1]), b = at(i + 1, low_[1]), c = at(i + 1, high_[1]), d = at(i, high_[1]);
      walls_.push_back({a, b, c, d});
      edges_.insert(edges_.end(), {{a, b}, {a, d}, {d, c}, {a, c}});
      const R3::Point below{0, low_[1], 0}, above{0, high_[1], 0};
      faces_.insert(faces_.end(), {{a, b, c}, {a, c, d}, {below, a, b}, {above, d, c}});
      edges_.insert(edges_.end(), {{below, a}, {above, d}});
    }
  }

  void AddBoxes() {
    const auto& l = low_;
    const auto& h = high_;
    Add("box 0", {l[0] - 1, l[1], l[2], l[0], h[1], h[2]});
    Add("box 0", {h[0], l[1], l[2], h[0] + 1, h[1], h[2]});
    Add("box 0", {l[0] - 1, l[1] - 1, l[2] - 1, h[0] + 1, l[1], h[2] + 1});
    Add("box 0", {l[0] - 1, h[1], l[2] - 1, h[0] + 1, h[1] + 1, h[2] + 1});
    Add("box 0", {l[0] - 1, l[1], l[2] - 1, h[0] + 1, h[1], l[2]});
    Add("box 0", {l[0] - 1, l[1], h[2], h[0] + 1, h[1], h[2] + 1});
  }

  void AddPlanes() {
    for (int axis = 0; axis < 3; ++axis)
      for (const bool is_high : {false, true}) {
        std::array<double, 3> point{0.1, 0.2, 0.3}, normal{};
        point[static_cast<std::size_t>(axis)] = is_high ? high_[axis] : low_[axis];
        normal[static_cast<std::size_t>(axis)] = is_high ? -1 : 1;
        Add("plane 0", {point[0], point[1], point[2], normal[0], normal[1], normal[2]});
      }
  }

  void AddWalls(const std::string& kind) {
    if (kind == "mesh" || kind == "concave") return AddMesh();
    for (const auto& [a, b, c, d] : walls_) AddWall(kind, {a, b, c, d});
    for (const double y : {low_[1], high_[1]}) {
      std::vector<R3::Point> corners;
      for (const auto& p : base_) corners.push_back({p[0], y, p[1]});
      AddWall(kind, corners);
    }
  }
  void AddWall(const std::string& kind, const std::vector<R3::Point>& p) {
    if (kind == "tri") {
      for (std::size_t i = 1; i + 1 < p.size(); ++i) {
        text += "tri 0";
        for (const R3::Point& q : {p[0], p[i], p[i + 1]}) Say({q.x, q.y, q.z});
        text += '\n';
      }
      return;
    }
    text += kind + " 0" + (kind == "polygon" ? " " + std::to_string(p.size()) : "");
    for (const R3::Point& q : p) Say({q.x, q.y, q.z});
    text += '\n';
  }
  /// Adds a mesh of triangles about the middles of floor and ceiling.
  void AddMesh() {
    text += "mesh 0 room.off\n";
    const std::size_t n = base_.size();
    std::string faces;
    char line[96];
    mesh = "OFF\n" + std::to_string(2 * n + 2) + " " + std::to_string(4 * n) + " 0\n";
    for (const double y : {low_[1], high_[1]}) {
      for (const auto& p : base_) {
        std::snprintf(line, sizeof line, "%.17g %.17g %.17g\n", p[0], y, p[1]);
        mesh += line;
      }
    }
    for (const double y : {low_[1], high_[1]}) {
      std::snprintf(line, sizeof line, "0 %.17g 0\n", y);
      mesh += line;
    }
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = (i + 1) % n;
      const auto face = [&](std::size_t a, std::size_t b, std::size_t c) {
        std::snprintf(line, sizeof line, "3 %zu %zu %zu\n", a, b, c);
        mesh += line;
      };
      face(i, j, n + j), face(i, n + j, n + i), face(2 * n, i, j), face(2 * n + 1, n + j, n + i);
    }
  }

  Draw& draw_;
  R3::Matrix frame_;
  double low_[3], high_[3];
  std::vector<std::array<double, 2>> base_;  // the corners of the floor, x and z
  std::vector<std::array<R3::Point, 4>> walls_;
  std::vector<std::array<R3::Point, 2>> edges_;
  std::vector<std::array<R3::Point, 3>> faces_;
};
