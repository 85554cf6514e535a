#pragma once

#include <string>
#include <vector>

#include "source/app/files/OutputFile.h"
#include "source/app/options/RenderOptions.h"
#include "source/render/Render.h"

/// Files by which machines that render an image together exchange samples: a part, "out.png.part-3-of-8", is a
/// compressed checkpoint that holds the blocks of one part; a plan, "out.png.plan", is one without samples that says
/// what the next round takes.
namespace ray {

std::string PartName(const std::string& picture, const ImagePart& part);
std::string PlanName(const std::string& picture);

/// Returns the files that a pattern of the shell names, sorted. Names come first: a file or folder of just that name,
/// then the image's own name at its beginning, then the pattern with brackets and backslashes as letters of the names,
/// so that "shot[1].png.part-*" means parts of "shot[1].png"; and only where nothing is named so, the whole pattern.
///   picture   the image's file name, as typed
std::vector<std::string> FilesLike(const std::string& pattern, const std::string& picture);

/// What a file of a part holds.
struct PartFile {
  ImagePart part;
  RenderState state;
};

/// What a file of a plan holds.
struct Plan {
  double seconds = 0;  // from the beginning of the render to the plan's writing
  RenderState state;
};

/// Reads parts of an image.
///   picture    its file name, as typed
///   identity   see IdentityOf
class PartReader {
 public:
  PartReader(const RenderSettings& settings, const std::string& picture, const std::string& identity);

  /// Nothing, and a warning, for a file that is damaged: its samples can be rendered again. Nothing for one that is
  /// gone: another job of the image's name removes parts once it has the image. Throws SceneErrors for a file that
  /// cannot be read, or is of another scene, other settings or another version.
  std::optional<PartFile> Read(const std::string& name);
  /// What the round begins with: the plan beside the image, else the first round. Throws SceneErrors.
  RenderState Round() const;
  /// How long ago the render began that the plan is of; nothing where there is no plan. Time passes here as the file
  /// system of the image's folder counts it, so that machines need no clocks that agree. Throws SceneErrors.
  std::optional<double> SecondsSinceBegin() const;
  /// The round with the samples of all parts in these files. Throws SceneErrors also when files are parts of different
  /// divisions, or when two of one part disagree.
  ///   of   how many parts there must be; 0: as many as the files say
  RenderState Joined(const std::vector<std::string>& names, int of);

  const Film& film() const { return film_; }
  const std::string& Picture() const { return picture_; }
  /// PartsOfBlocks, found once for as long as `of` stays the same.
  const std::vector<int>& PartsOf(int of);

 private:
  RenderState Decoded(std::span<const unsigned char> bytes) const;
  /// The file of that name; throws SceneErrors for one that is no plan.
  Plan ReadPlan(const std::string& name) const;

  const RenderSettings& settings_;
  const std::string picture_, identity_;
  const Film film_;
  int of_ = 0;
  std::vector<int> parts_;  // of each block, where there are of_
};

/// What assembling begins with: the samples of all files whose names match the pattern. Where none does, a message says
/// that all is rendered here. Throws SceneErrors.
RenderState StateOfParts(PartReader&& reader, const std::string& pattern);

/// Writes files of parts, each whole or not at all.
///   identity   see IdentityOf
class PartWriter {
 public:
  PartWriter(const RenderSettings& settings, const FileOptions& files, const std::string& identity);
  /// Throws OutputError; the bytes are then kept elsewhere, see WriteWhole.
  void WritePart(RenderState&& state) const;
  ///   seconds   since the render began; some clock counts them only where -time is given
  void WritePlan(RenderState&& state, double seconds) const;

 private:
  const RenderSettings& settings_;
  const FileOptions& files_;
  const std::string identity_;
};

}  // namespace ray
