#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grader/Results.h"
#include "grader/Suite.h"

namespace ray::grade {

/// The page of a student: one HTML file with its images in it.
std::string StudentPage(const StudentResult& student, const Suite& suite, const std::string& sandbox);

/// What Gradescope reads: one test per scene, with its output as HTML. What the other reports need to be made again is
/// in "extra_data".
///   identity   of all that results depend on but the student's program
///   source     Gradescope, Autograder specifications: results.json
std::string ResultsJson(const StudentResult& student, const std::string& identity);
/// What ResultsJson wrote, without images; nothing where the text is no such thing, or of another identity.
std::optional<StudentResult> ReadResultsJson(const std::string& text, const std::string& identity);

/// One line per student and scene, then those of the class: its maximum, mean and median in each scene.
std::string ClassCsv(const std::vector<StudentResult>& students);

/// A page for teachers: points, verdicts and remarks, and which students share a cause.
std::string ClassPage(const std::vector<StudentResult>& students, const Suite& suite);

/// Returns a student's page with another comment of the teacher in it; an empty one leaves none.
std::string WithComment(const std::string& page, const std::string& comment);

}  // namespace ray::grade
