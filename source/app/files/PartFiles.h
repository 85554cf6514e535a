#pragma once

#include <string>
#include <vector>

#include "source/app/files/OutputFile.h"
#include "source/app/options/RenderOptions.h"
#include "source/render/Render.h"

/// Files in which machines that render an image together exchange samples: a part, "out.png.part-3-of-8", is a
/// compressed checkpoint with the blocks of one part; a plan, "out.png.plan", is one without samples that specifies the
/// next round.
namespace ray {

std::string PartName(const std::string& image_name, const ImagePart& part);
std::string PlanName(const std::string& image_name);

/// Returns the files that match a shell pattern, sorted. Literal names take precedence: a file or folder of exactly
/// that name, then the image's own name at the beginning of the pattern, then the pattern with literal brackets and
/// backslashes, so that "shot[1].png.part-*" means parts of "shot[1].png". The whole pattern is used only if none of
/// these match.
///   image_name   the image's file name, as typed
std::vector<std::string> FilesLike(const std::string& pattern, const std::string& image_name);

/// The contents of the file of a part.
struct PartFile {
  ImagePart part;
  RenderState state;
};

/// The contents of the file of a plan.
struct Plan {
  double seconds = 0;  // from the start of the render to the writing of the plan
  RenderState state;
};

/// A reader of the parts of an image.
///   image_name   its file name, as typed
///   identity     see IdentityOf
class PartReader {
 public:
  PartReader(const RenderSettings& settings, const std::string& image_name, const std::string& identity);

  /// Reads a part. Returns std::nullopt with a warning for a damaged file, since its samples can be rendered again, and
  /// without one for a missing file, since another job for the image removes parts when it has the image. Throws
  /// SceneErrors for a file that cannot be read, or belongs to another scene, other settings or another version.
  std::optional<PartFile> Read(const std::string& name);
  /// Returns the initial state of the round: the plan next to the image, or the first round. Throws SceneErrors.
  RenderState Round() const;
  /// Returns the time since the start of the render with the plan; std::nullopt if there is no plan. Uses the clock of
  /// the file system of the image's folder, so that the machines' clocks need not agree. Throws SceneErrors.
  std::optional<double> SecondsSinceBegin() const;
  /// Returns the round with the samples of all parts in these files. Throws SceneErrors also if files are parts of
  /// different divisions, or if two files of one part disagree.
  ///   of   required number of parts; 0: as stated in the files
  RenderState Joined(const std::vector<std::string>& names, int of);

  const Film& film() const { return film_; }
  const std::string& ImageName() const { return image_name_; }
  /// Returns PartsOfBlocks, computed once per value of `of`.
  const std::vector<int>& PartsOf(int of);

 private:
  RenderState Decoded(std::span<const unsigned char> bytes) const;
  /// Reads a plan; throws SceneErrors if the file is not one.
  Plan ReadPlan(const std::string& name) const;

  const RenderSettings& settings_;
  const std::string image_name_, identity_;
  const Film film_;
  int of_ = 0;
  std::vector<int> parts_;  // of each block, for a division into of_ parts
};

/// Returns the initial state of assembling: the samples of all files whose names match the pattern. If there are none,
/// prints a message that everything is rendered here. Throws SceneErrors.
RenderState StateOfParts(PartReader&& reader, const std::string& pattern);

/// Writes files of parts, each completely or not at all.
///   identity     see IdentityOf
class PartWriter {
 public:
  PartWriter(const RenderSettings& settings, const FileOptions& files, const std::string& identity);
  /// Writes a part. Throws OutputError; the bytes are then saved elsewhere, see WriteWhole.
  void WritePart(RenderState&& state) const;
  /// Writes a plan.
  ///   seconds   since the start of the render; only measured with -time
  void WritePlan(RenderState&& state, double seconds) const;

 private:
  const RenderSettings& settings_;
  const FileOptions& files_;
  const std::string identity_;
};

}  // namespace ray
