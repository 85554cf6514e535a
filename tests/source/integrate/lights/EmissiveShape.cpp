#include "source/integrate/lights/EmissiveShape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "R3/Warp.h"
#include "tests/ChiSquare.h"
#include "tests/Crossings.h"
#include "tests/Draw.h"
#include "tests/Project.h"

namespace ray {
namespace {

constexpr const char* frames[] = {
    "begin -1  1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1 begin -1  1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1 ",
    // A rotation, then scales of 1, 3 and -1/2, then a shear and a translation.
    "begin -1  1 0.7 0 2  0 1 0 -1  0 0.2 1 0.5  0 0 0 1 "
    "begin -1  0.8 0 0.3 0  0 3 0 0  0.6 0 -0.4 0  0 0 0 1 "};

/// One emissive shape in two groups, alone in its scene.
struct Lamp {
  Lamp(const R3::ShapeKind& kind, const std::string& frame) : stage(project::FromText(Text(kind, frame))) {
    accelerator = FindAcceleratorKind("none")->Make(stage.world, {});
  }

  static std::string Text(const R3::ShapeKind& kind, const std::string& frame) {
    std::string text = "material 0 0 0  0 0 0  0 0 0  0 0 0  1 1 1  10 1 0 " + frame + kind.name + " 0";
    for (const double x : kind.example) text += " " + std::to_string(x);
    return text + " end end";
  }

  EmissiveShape Shape() const { return EmissiveShapes(stage.world).at(0); }
  R3::Box Bounds() const { return stage.world.InWorld(stage.world.Instances()[0].frame, LocalBounds()); }
  R3::Box LocalBounds() const { return R3::Bounds(*stage.world.Instances()[0].shape); }

  /// Returns the pdf of the direction in which this place of the light is visible, by rays; 0 if they miss.
  double PdfOf(const EmissiveShape& shape, const R3::Point& from, const R3::Vector& direction) {
    const R3::Ray ray{from, direction};
    const auto hit = accelerator->Intersect(ray, workspace);
    return hit ? shape.Pdf(from, hit->t * direction, stage.world.At(ray, *hit).normal, 0) : 0;
  }

  bool IsInside(const R3::Point& point) const {
    return crossings::Count(*stage.world.Instances()[0].shape,
                            stage.world.Back(stage.world.Instances()[0].frame, R3::Ray{point, {0.3, 0.5, 0.7}})) %
               2 ==
           1;
  }

  project::Stage stage;
  std::unique_ptr<const Accelerator> accelerator;
  Workspace workspace;
};

/// Calls check(lamp, from, is_convex, name) for points next to every shape that can be sampled, and inside it if it has
/// an inside.
template <typename Check>
void ForManyViews(const Check& check) {
  for (const auto* kind : R3::ShapeKinds()) {
    const auto shape = kind->make(kind->example);
    if (!shape->CanBeSampled()) continue;
    for (const char* frame : frames) {
      Lamp lamp(*kind, frame);
      const R3::Transform& world_from_local = lamp.stage.world.Frames()[lamp.stage.world.Instances()[0].frame];
      Draw draw(31);
      std::vector<R3::Point> places;
      if (shape->IsSolid()) places.push_back(world_from_local * crossings::PointInside(*shape));
      for (const double distance : {0.6, 1.0, 3.0})
        places.push_back(lamp.Bounds().Center() + distance * lamp.Bounds().Radius() * draw.Direction());
      for (const R3::Point& from : places) check(lamp, from, crossings::IsConvex(*shape), kind->name);
    }
  }
}

constexpr int rows = 8, columns = 16;

/// Directions to all visible parts of a box, divided into cells of equal solid angle.
struct Cells {
  Cells(const R3::Box& box, const R3::Point& from) {
    const R3::Vector to_center = box.Center() - from;
    const double sine = box.Radius() / Length(to_center);
    if (sine < 1) axis = Unit(to_center), one_minus_cosine = 1 - std::sqrt(1 - sine * sine);
  }

  /// Rings by u.x, sectors by u.y: zones of a sphere have areas proportional to their heights.
  R3::Vector Direction(const R2::Point& u) const {
    const double height = u.x * one_minus_cosine;
    return FromTangents(R3::FromPolar(std::sqrt(height * (2 - height)), 1 - height, u.y), axis);
  }
  std::size_t CellOf(const R3::Vector& direction) const {
    const R3::Tangents tangents = TangentsOf(axis);
    const R3::Vector d = Unit(direction);
    const double turn = std::atan2(Dot(d, tangents.second), Dot(d, tangents.first)) / (2 * std::numbers::pi);
    const double x = (1 - Dot(d, axis)) / one_minus_cosine, y = turn < 0 ? turn + 1 : turn;
    return static_cast<std::size_t>(std::clamp(static_cast<int>(x * rows), 0, rows - 1) * columns +
                                    std::clamp(static_cast<int>(y * columns), 0, columns - 1));
  }
  double SolidAngle() const { return 2 * std::numbers::pi * one_minus_cosine / (rows * columns); }

  R3::Vector axis{0, 0, 1};
  double one_minus_cosine = 2;
};

/// Returns the mean of f over the directions of a cell, on a grid of this many steps.
template <typename Function>
double MeanOf(const Cells& cells, int cell, int steps, const Function& f) {
  double sum = 0;
  for (int i = 0; i < steps * steps; ++i)
    sum += f(cells.Direction({(cell / columns + (i % steps + 0.5) / steps) / rows,
                              (cell % columns + (i / steps + 0.5) / steps) / columns}));
  return sum / (steps * steps);
}

/// Returns MeanOf for each cell.
template <typename Function>
std::vector<double> MeanOfEach(const Cells& cells, int steps, const Function& f) {
  std::vector<double> means;
  for (int cell = 0; cell < rows * columns; ++cell) means.push_back(MeanOf(cells, cell, steps, f));
  return means;
}

TEST(EmissiveShape, SamplesOverPdfSumToTheVisibleSolidAngle) {
  // Cell by cell: a pdf that is wrong anywhere would count the part visible there too much or too little.
  constexpr int samples = 20'000;
  ForManyViews([&](Lamp& lamp, const R3::Point& from, bool, const char* name) {
    const EmissiveShape shape = lamp.Shape();
    const Cells cells(lamp.Bounds(), from);
    const auto covered = MeanOfEach(cells, 24, [&](const R3::Vector& direction) {
      return lamp.accelerator->IsOccluded({from, direction}, lamp.workspace) ? 1.0 : 0.0;
    });
    std::vector<double> sums(rows * columns), squares(rows * columns);
    Draw draw(16);
    for (int i = 0; i < samples; ++i) {
      const auto sample = shape.SampleTowards(from, {draw.Between(0, 1), draw.Between(0, 1)}, 0);
      if (!sample || lamp.accelerator->IsOccluded({from, sample->towards, 0, 1}, lamp.workspace)) continue;
      const double share = 1 / (sample->pdf * cells.SolidAngle());  // of the cell's solid angle
      sums[cells.CellOf(sample->towards)] += share / samples;
      squares[cells.CellOf(sample->towards)] += share * share / samples;
    }
    const auto inverse_pdf = MeanOfEach(cells, 24, [&](const R3::Vector& direction) {
      const double pdf = lamp.PdfOf(shape, from, direction);
      return pdf > 0 ? 1 / pdf : 0;
    });
    int compared = 0;
    for (std::size_t i = 0; i < sums.size(); ++i) {
      // If a surface is very close to the point, a small area fills much of the view: too few samples fall there.
      if (inverse_pdf[i] > cells.SolidAngle() * samples / 20) continue;
      compared += covered[i] > 0;
      const double deviation = std::sqrt((squares[i] - sums[i] * sums[i]) / samples);
      const double known_within = 0.04;  // where an outline crosses the grid
      EXPECT_LT(std::abs(sums[i] - covered[i]), 5 * deviation + known_within)
          << name << ", cell " << i << ": " << sums[i] << ", not " << covered[i];
    }
    EXPECT_GT(compared, 5) << name;
  });
}

TEST(EmissiveShape, IsSampledByItsPdfWhichIntegratesToOne) {
  // Compares the pdf at the hits of rays, integrated over all directions, with the frequency of places. If an area is
  // seen at a grazing angle, no grid integrates its pdf; that of a sphere is bounded, and all are from inside. Parts
  // hidden behind the rest of a shape that is not convex have the remainder.
  constexpr int views = 15, samples = 20'000;
  ForManyViews([&](Lamp& lamp, const R3::Point& from, bool is_convex, const char* name) {
    const EmissiveShape shape = lamp.Shape();
    if (name != std::string("sphere") && !lamp.IsInside(from)) return;
    const Cells cells(lamp.Bounds(), from);
    const auto pdf = [&](const R3::Vector& direction) { return lamp.PdfOf(shape, from, direction); };
    auto probabilities = MeanOfEach(cells, 48, pdf);
    double visible = 0;
    for (double& probability : probabilities) visible += probability *= cells.SolidAngle();
    if (is_convex) {
      EXPECT_NEAR(visible, 1, 0.005) << name;
      for (double& probability : probabilities) probability /= visible;
    }
    EXPECT_LT(visible, 1.005) << name;
    probabilities.push_back(is_convex ? 0 : 1 - visible);

    std::vector<double> counts(rows * columns + 1);
    Draw draw(17);
    for (int i = 0; i < samples; ++i) {
      const auto sample = shape.SampleTowards(from, {draw.Between(0, 1), draw.Between(0, 1)}, 0);
      const bool is_seen = sample && !lamp.accelerator->IsOccluded({from, sample->towards, 0, 1}, lamp.workspace);
      ++counts[is_seen ? cells.CellOf(sample->towards) : rows * columns];
    }
    for (int cell = 0; cell < rows * columns; ++cell) {  // an outline may cut off a corner between steps of the grid
      const auto i = static_cast<std::size_t>(cell);
      if (counts[i] > 0 && probabilities[i] == 0)
        probabilities[i] = MeanOf(cells, cell, 1000, pdf) * cells.SolidAngle();
    }
    EXPECT_LT(chi_square::OverQuantile(counts, probabilities, 0.01 / views), 1) << name;
  });
}

TEST(EmissiveShape, SamplesAndRaysAgreeOnThePdf) {
  ForManyViews([](Lamp& lamp, const R3::Point& from, bool, const char* name) {
    const EmissiveShape shape = lamp.Shape();
    Draw draw(18);
    int compared = 0;
    for (int i = 0; i < 2000; ++i) {
      const auto sample = shape.SampleTowards(from, {draw.Between(0, 1), draw.Between(0, 1)}, 0);
      if (!sample || lamp.accelerator->IsOccluded({from, sample->towards, 0, 1}, lamp.workspace)) continue;
      const R3::Ray ray{from, sample->towards};
      const auto hit = lamp.accelerator->Intersect(ray, lamp.workspace);
      if (!hit) continue;  // the place is on the outline
      const R3::Normal normal = lamp.stage.world.At(ray, *hit).normal;
      if (std::abs(Dot(normal, Unit(sample->towards))) < 1e-3) continue;  // rounding decides grazing hits
      EXPECT_NEAR(hit->t, 1, 1e-9) << name;
      EXPECT_NEAR(shape.Pdf(from, hit->t * sample->towards, normal, 0) / sample->pdf, 1, 1e-6) << name;
      ++compared;
    }
    EXPECT_GT(compared, 300) << name;
  });
}

TEST(EmissiveShape, ConvexShapesAreNeverSampledOnTheBack) {
  ForManyViews([](Lamp& lamp, const R3::Point& from, bool is_convex, const char* name) {
    if (!is_convex) return;
    const EmissiveShape shape = lamp.Shape();
    Draw draw(19);
    for (int i = 0; i < 2000; ++i) {
      const auto sample = shape.SampleTowards(from, {draw.Between(0, 1), draw.Between(0, 1)}, 0);
      ASSERT_TRUE(sample) << name;
      EXPECT_FALSE(lamp.accelerator->IsOccluded({from, sample->towards, 0, 1}, lamp.workspace)) << name;
    }
  });
}

TEST(EmissiveShape, SpheresAreSampledInTheirSubtendedConeHoweverNarrow) {
  const auto sphere = R3::MakeShape("sphere", {0, 0, 0, 1});
  for (const double height : {1e-12, 1e-6, 1.0, 1e6, 1e12}) {
    const R3::Point from{0, 0, 1 + height};
    const double d = from.z, above = d - 1;
    const double one_minus_cosine = 1 / (d * d) / (1 + std::sqrt(above / d * (1 + 1 / d)));
    const auto sample = sphere->Sample(from, {0.3, 0.6}, 0);
    ASSERT_TRUE(sample) << height;
    EXPECT_NEAR(sample->pdf * 2 * std::numbers::pi * one_minus_cosine, 1, 1e-6) << height;
    EXPECT_NEAR(Length(FromOrigin(sample->at.position)), 1, 1e-14) << height;
    EXPECT_GE(Dot(sample->at.normal, from - sample->at.position), -1e-14 * d) << height;
  }
}

TEST(EmissiveShape, BatchedSamplesEqualSingleOnesBitForBit) {
  for (const R3::ShapeKind* kind : R3::ShapeKinds()) {
    Lamp lamp(*kind, frames[0]);
    if (EmissiveShapes(lamp.stage.world).empty()) continue;
    const EmissiveShape shape = lamp.Shape();
    ASSERT_TRUE(shape.CanSampleEach());
    // From beside it, from places of which some are inside, and from so far away that squares leave the range.
    for (const double reach : {20.0, 1.0, 1e200}) {
      Draw draw(904);
      LightSamples samples;
      samples.count = LightSamples::most - 3;
      for (std::uint32_t i = 0; i < samples.count; ++i) {
        samples.from.Set(i, {draw.Between(-reach, reach), draw.Between(-reach, reach), draw.Between(-reach, reach)});
        const double u = draw.Between(0, 1), v = draw.Between(0, 1);
        samples.random.Set(i, {u, v});
      }
      LightSamples::Each pdfs;
      shape.SampleEach(samples, pdfs);
      for (std::uint32_t i = 0; i < samples.count; ++i) {
        const auto alone = shape.SampleTowards(samples.from[i], samples.random[i], 0);
        EXPECT_EQ(pdfs[i], alone ? alone->pdf : 0) << kind->name;
        EXPECT_EQ(samples.color[i], alone ? shape.Emission() / alone->pdf : R2::Color{}) << kind->name;
        EXPECT_TRUE(!alone || samples.to_light[i] == alone->towards) << kind->name;
      }
    }
  }
}

}  // namespace
}  // namespace ray
