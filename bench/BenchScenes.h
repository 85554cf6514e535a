#pragma once

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "R3/Mesh.h"
#include "source/parse/Files.h"
#include "source/parse/SceneError.h"
#include "source/parse/meshes/MeshFormat.h"

/// Meshes to measure with: generated ones, and public scans where they lie beside the checkout. All coordinates are
/// floats, so that programs in single precision see the same scene.
namespace bench {

struct View {
  R3::MeshData mesh;
  R3::Point eye, target, light;
};

inline R3::Point Float(const R3::Point& p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

class Modeler {
 public:
  R3::MeshData mesh;

  void Triangle(const R3::Point& a, const R3::Point& b, const R3::Point& c) {
    const auto n = static_cast<std::uint32_t>(mesh.positions.size());
    for (const auto& p : {a, b, c}) mesh.positions.push_back(Float(p));
    mesh.triangles.push_back({n, n + 1, n + 2});
  }
  void Quad(const R3::Point& corner, const R3::Vector& u, const R3::Vector& v, int cells = 1) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const auto side = static_cast<std::uint32_t>(cells);
    for (std::uint32_t i = 0; i <= side; ++i)
      for (std::uint32_t j = 0; j <= side; ++j)
        mesh.positions.push_back(Float(corner + (double(i) / side) * u + (double(j) / side) * v));
    for (std::uint32_t i = 0; i < side; ++i)
      for (std::uint32_t j = 0; j < side; ++j) {
        const std::uint32_t a = first + i * (side + 1) + j, b = a + side + 1;
        mesh.triangles.push_back({a, b, b + 1});
        mesh.triangles.push_back({a, b + 1, a + 1});
      }
  }
  void Box(const R3::Point& low, const R3::Point& high, int cells = 1) {
    const R3::Vector s = high - low, x{s.x, 0, 0}, y{0, s.y, 0}, z{0, 0, s.z};
    Quad(low, x, y, cells), Quad(low, x, z, cells), Quad(low, y, z, cells);
    Quad(low + x, y, z, cells), Quad(low + y, x, z, cells), Quad(low + z, x, y, cells);
  }
  void Column(const R3::Point& foot, double radius, double height, int sides, int rings) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const auto s = static_cast<std::uint32_t>(sides), r = static_cast<std::uint32_t>(rings);
    for (std::uint32_t k = 0; k <= r; ++k)
      for (std::uint32_t i = 0; i < s; ++i) {
        const double turn = 2 * M_PI * i / s, wide = radius * (1 + 0.1 * std::cos(8 * turn));
        mesh.positions.push_back(
            Float(foot + R3::Vector{wide * std::cos(turn), height * k / r, wide * std::sin(turn)}));
      }
    for (std::uint32_t k = 0; k < r; ++k)
      for (std::uint32_t i = 0; i < s; ++i) {
        const std::uint32_t a = first + k * s + i, b = first + k * s + (i + 1) % s;
        mesh.triangles.push_back({a, b, b + s});
        mesh.triangles.push_back({a, b + s, a + s});
      }
  }
  void Add(const R3::MeshData& other) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const auto& p : other.positions) mesh.positions.push_back(Float(p));
    for (const auto& t : other.triangles) mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  R3::Box Bounds() const {
    R3::Box box;
    for (const auto& p : mesh.positions) box.Extend(p);
    return box;
  }
};

/// A bumpy sphere of about `triangles` triangles.
inline R3::MeshData Blob(std::size_t triangles) {
  Modeler m;
  const auto rings = static_cast<std::uint32_t>(std::max(4.0, std::sqrt(static_cast<double>(triangles) / 4)));
  const std::uint32_t sides = 2 * rings;
  for (std::uint32_t k = 0; k <= rings; ++k)
    for (std::uint32_t i = 0; i < sides; ++i) {
      const double a = M_PI * k / rings, b = 2 * M_PI * i / sides;
      const R3::Vector d{std::sin(a) * std::cos(b), std::cos(a), std::sin(a) * std::sin(b)};
      const double r =
          1 + 0.1 * std::sin(9 * d.x) * std::sin(7 * d.y + 1) + 0.05 * std::sin(31 * d.z) * std::sin(27 * d.x);
      m.mesh.positions.push_back(Float(R3::Point{} + r * d));
    }
  for (std::uint32_t k = 0; k < rings; ++k)
    for (std::uint32_t i = 0; i < sides; ++i) {
      const std::uint32_t a = k * sides + i, b = k * sides + (i + 1) % sides;
      if (k > 0) m.mesh.triangles.push_back({a, b, b + sides});
      if (k + 1 < rings) m.mesh.triangles.push_back({a, b + sides, a + sides});
    }
  return m.mesh;
}

/// Triangles anywhere in a cube; `slim` < 1 makes them thin in proportion.
inline R3::MeshData Soup(std::size_t triangles, double size, double slim) {
  Modeler m;
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto vector = [&] { return R3::Vector{number(random), number(random), number(random)}; };
  for (std::size_t i = 0; i < triangles; ++i) {
    const R3::Point p = R3::Point{} + vector();
    const R3::Vector along = size * Unit(vector()), across = slim * size * Unit(Cross(along, vector()));
    m.Triangle(p, p + along, p + 0.5 * along + across);
  }
  return m.mesh;
}

inline std::optional<R3::MeshData> Scan(const std::string& file) {
  const std::filesystem::path path = std::filesystem::path("../shared/meshes") / file;
  FILE* in = std::fopen(path.c_str(), "rb");
  if (!in) return {};
  std::string bytes(std::filesystem::file_size(path), '\0');
  bytes.resize(std::fread(bytes.data(), 1, bytes.size(), in));
  std::fclose(in);
  ray::Report report;
  R3::MeshData data = ray::MeshFormatForName(file)->read({file, std::move(bytes)}, report).data;
  for (auto& p : data.positions) p = Float(p);
  data.normals.clear(), data.uvs.clear();
  return data;
}

/// The mesh scaled to height 2, standing on a floor; or in a room.
inline View Placed(const R3::MeshData& mesh, bool in_room) {
  Modeler m;
  m.Add(mesh);
  const R3::Box box = m.Bounds();
  const double scale = 2 / MaxComponent(box.Size());
  const R3::Point foot{box.Center().x, box.low.y, box.Center().z};
  for (auto& p : m.mesh.positions) p = Float(R3::Point{} + scale * (p - foot));
  if (in_room)
    m.Box({-4, 0, -4}, {4, 5, 4});
  else
    m.Quad({-6, 0, -6}, {12, 0, 0}, {0, 0, 12}, 4);
  return {std::move(m.mesh), {0.8, 1.6, 3.2}, {0, 0.9, 0}, {2, 4.5, 2.5}};
}

inline std::vector<std::string> SceneNames() {
  return {"rabbit", "head", "bust", "blob", "soup", "hairs", "colonnade", "city"};
}

/// Nothing when a scan is not there.
inline std::optional<View> MakeView(const std::string& name) {
  if (name == "rabbit" || name == "head" || name == "bust") {
    const auto scan = Scan(name == "rabbit" ? "stanford-bunny.obj" : name == "head" ? "igea.ply" : "nefertiti.obj");
    if (!scan) return {};
    return Placed(*scan, name == "bust");
  }
  if (name == "blob") return View{Blob(1'000'000), {0, 1, 3}, {0, 0, 0}, {3, 4, 3}};
  if (name.starts_with("blob:")) return View{Blob(std::stoul(name.substr(5))), {0, 1, 3}, {0, 0, 0}, {3, 4, 3}};
  if (name == "soup") return View{Soup(1'000'000, 0.02, 0.7), {0, 0.5, 3}, {0, 0, 0}, {3, 4, 3}};
  if (name == "hairs") return View{Soup(100'000, 0.6, 0.004), {0, 0.5, 3}, {0, 0, 0}, {3, 4, 3}};
  if (name == "colonnade") {
    Modeler m;
    m.Box({-10, 0, -10}, {10, 6, 10}, 8);
    for (int i = -4; i <= 4; ++i)
      for (int k = -4; k <= 4; ++k) m.Column({2.0 * i, 0, 2.0 * k}, 0.4, 6, 32, 12);
    return View{std::move(m.mesh), {1, 2, 9}, {-1, 2, -3}, {1, 5.5, 1}};
  }
  if (name == "city") {
    Modeler m;
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> number(0, 1);
    m.Quad({-50, 0, -50}, {100, 0, 0}, {0, 0, 100}, 2);
    for (int i = -45; i < 45; ++i)
      for (int k = -45; k < 45; ++k) {
        const double x = i + 0.3 * number(random), z = k + 0.3 * number(random);
        m.Box(R3::Point{x, 0, z}, R3::Point{x + 0.6, 0.3 + 4 * std::pow(number(random), 3), z + 0.6});
      }
    return View{std::move(m.mesh), {3, 3, 40}, {0, 0.5, 0}, {30, 40, 30}};
  }
  return {};
}

}  // namespace bench
