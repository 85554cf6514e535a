#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grader/Results.h"
#include "grader/Suite.h"

namespace ray::grade {

/// Returns the page of a student: one HTML file that includes its images.
std::string StudentPage(const StudentResult& student, const Suite& suite, const std::string& sandbox);

/// Returns the results for Gradescope: one test per scene, with its output as HTML. "extra_data" contains the data from
/// which the other reports can be made again.
///   identity   identifies everything that results depend on except the student's program
///   source     Gradescope, Autograder specifications: results.json
std::string ResultsJson(const StudentResult& student, const std::string& identity);
/// Reads the output of ResultsJson, without images; std::nullopt for any other text, or another identity.
std::optional<StudentResult> ReadResultsJson(const std::string& text, const std::string& identity);

/// Returns a line per student and scene, then those of the class: its maximum, mean and median in each scene.
std::string ClassCsv(const std::vector<StudentResult>& students);

/// Returns a page for teachers: points, verdicts and remarks, and the students that share a cause.
std::string ClassPage(const std::vector<StudentResult>& students, const Suite& suite);

/// Returns a student's page with another comment of the teacher; an empty one removes it.
std::string WithComment(const std::string& page, const std::string& comment);

}  // namespace ray::grade
