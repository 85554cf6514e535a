#pragma once

#include <string>
#include <vector>

#include "R2/Color.h"
#include "R2/Image.h"
#include "R2/Point.h"
#include "R3/Vector.h"
#include "source/sample/DiscreteDistribution.h"
#include "source/scene/EnvironmentLayout.h"
#include "source/scene/LightSamples.h"

namespace ray {

/// The position of a direction on a map, in texels from the lower left, by approximate arctangents.
struct QuickPlace {
  double column, row;
  double margin;  // above 0 if the direction is certainly in this texel
};

/// An environment light: light from all around at infinity, given by an image.
///
/// Radiance is constant on each texel of a latitude-longitude map: it is not interpolated between texels, so that
/// sampling directions by texel is exact. An angular probe and a cross are converted to such a map once; that has as
/// many rows as the probe, or twice as many as a face of the cross (at least 128, at most 8192), and each of its texels
/// is the mean over four points. A single bright pixel counts for the points that fall on it: every pixel of a cross
/// has some, and of a probe every one up to 0.8 of its radius (tested); beyond, where pixels are narrow, some are
/// skipped.
class Environment {
 public:
  /// Makes an environment. The layout is determined by the shape: see EnvironmentLayout. Throws std::invalid_argument,
  /// with a message for the user, for an image of another shape, and for one with a value that is negative or not
  /// finite.
  ///   file   the file that the image was read from; empty for none
  explicit Environment(R2::Image image, std::string file = {});

  EnvironmentLayout Layout() const { return layout_; }
  const std::string& File() const { return file_; }

  /// Returns the radiance that arrives from a direction of any length but 0; at a pole or a seam it is one of the
  /// adjacent texels.
  R2::Color Radiance(const R3::Vector& direction) const;

  struct Seen {
    R2::Color radiance;
    double pdf;  // of Draw returning the direction, per solid angle
  };
  /// Returns the radiance and the pdf of Draw for a direction: together, since finding a texel takes two arctangents.
  Seen SeenTowards(const R3::Vector& direction) const;

  struct Sample {
    R3::Vector direction;  // unit, towards the light
    R2::Color radiance;    // both bit-identical to SeenTowards(direction)
    double pdf;            // > 0
  };

  /// Samples a direction with a pdf proportional to the luminance that arrives from it: pdf = luminance / integral of
  /// luminance over the sphere, within 2^-53 of a map's width and height times the largest pdf. Then luminance / pdf is
  /// the same for all directions, and no channel over pdf exceeds that by more than 1 / 0.11, the inverse of the
  /// smallest weight in luminance. A black environment gives all directions the same pdf.
  ///   u        in [0, 1]^2
  ///   source   Pharr, Jakob, Humphreys, Physically Based Rendering (2023), section 12.5.2: first a row by the
  ///            luminance of its texels times their solid angle, then a texel of the row, then, unlike there, a point
  ///            of the texel uniformly by solid angle: uniformly in longitude and in the sine of latitude, as a
  ///            sphere's zones have areas as their heights (Archimedes). With luminance L of the texel and its solid
  ///            angle A, the pdf is (L A / sum of L A) / A, with no sine left in it.
  Sample Draw(const R2::Point& u) const;

  /// Draw for many samples, bit-identical: from each sample's u and v computes the direction to the light, radiance /
  /// pdf as its irradiance, and the pdf.
  void DrawEach(LightSamples& samples, LightSamples::Each& pdfs) const;
  /// SeenTowards for each sample's direction to the light, bit-identical: the radiance as its irradiance, and the pdf.
  void SeeEach(LightSamples& samples, LightSamples::Each& pdfs) const;

  bool IsBlack() const { return is_black_; }
  /// Returns the largest luminance of a texel.
  double Brightest() const { return brightest_; }
  /// Returns the latitude-longitude map to which it was converted: width twice the height.
  const R2::Image& Map() const { return map_; }

 private:
  struct Texel {
    int column = 0, row = 0;
    friend bool operator==(const Texel&, const Texel&) = default;
  };

  /// A texel, relative positions in its longitude and its sine of latitude, and its Pdf.
  struct Drawn {
    Texel texel;
    R2::Point shares;
    double pdf = 0;
  };

  Texel At(const R3::Vector& direction) const;
  /// Returns the texel of the place, or if that is uncertain, the one given by exact arctangents of the direction.
  Texel TexelOf(const QuickPlace& place, const R3::Vector& direction) const;
  Drawn DrawInRow(const DiscreteDistribution::Drawn& row, double u) const;
  double Pdf(const Texel& texel) const;
  R2::Color RadianceOf(const Texel& texel) const { return map_.At(texel.column, texel.row); }
  /// Returns the direction at shares of the texel's longitude and of its sine of latitude.
  R3::Vector Inside(const Texel& texel, const R2::Point& shares) const;
  /// Returns a drawn direction that certainly receives light from this texel. A point at the very edge may round to the
  /// neighbor, which may be black; the texel's center then replaces it.
  R3::Vector Kept(const R3::Vector& direction, const Texel& texel, const R2::Point& shares) const;

  std::string file_;
  EnvironmentLayout layout_;
  R2::Image map_;  // a latitude-longitude map
  bool is_black_;
  double brightest_;
  std::vector<double> sines_;                  // of the latitudes of the rows' lower edges and the topmost upper edge
  std::vector<double> solid_angles_;           // of a texel in each row
  std::vector<DiscreteDistribution> columns_;  // one per row, by luminance
  DiscreteDistribution rows_;                  // by luminance times solid angle
};

}  // namespace ray
