#pragma once

#include <span>
#include <vector>

#include "grader/Diagnosis.h"
#include "grader/Results.h"
#include "grader/Suite.h"
#include "grader/Tone.h"

namespace ray::grade {

/// The images that a program left for a scene.
struct HandedIn {
  SceneImages* images;
  std::vector<R2::Image> runs;
  bool is_jpeg = false;
  std::size_t scene = 0;  // its number in StudentResult::scenes
};

/// Returns the encoding with which most pixels are right, if that is clear; otherwise linear.
Encoding EncodingOf(std::span<const HandedIn> handed_in);
std::vector<Exhibit> ExhibitsOf(std::span<const HandedIn> handed_in, Encoding encoding);

/// Sets the points of a scene, and the sentences about it, from its image alone.
void JudgeAlone(const Exhibit& exhibit, const Suite& suite, SceneResult& result);

/// The data behind a verdict.
struct Findings {
  Encoding encoding = Encoding::linear;
  std::optional<Diagnosis> diagnosis;  // std::nullopt if no image has more than one color
};

/// Sets the verdict on a student, and with it the points of all scenes.
Findings JudgeTogether(std::span<const HandedIn> handed_in, const Suite& suite, StudentResult& student);

}  // namespace ray::grade
