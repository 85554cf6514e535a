#pragma once

#include <string>
#include <utility>
#include <vector>

#include "source/app/Answers.h"
#include "source/app/manual/Manual.h"
#include "source/app/options/OptionTable.h"

namespace ray {

inline std::vector<std::string> Shells() { return {"bash"}; }

inline std::vector<std::string> CommandLinesOfCourses() { return {"comp30019"}; }

template <const Program& program>
std::vector<std::string> HelpSubjects() {
  std::vector<std::string> subjects = CommandNamesOf(program);
  for (const std::string& topic : OptionTopics(program)) subjects.push_back(topic);
  subjects.emplace_back("markdown");
  if (program == Program::raypro)
    for (const std::string& course : CommandLinesOfCourses()) subjects.push_back(course);
  return subjects;
}

template <const Program& program>
std::vector<std::string> SubjectsOfList() {
  return ListSubjects(program);
}

// clang-format would split entries over many lines.
// clang-format off
/// The rows at the end of each program's table.
template <const Program& program>
std::vector<OptionKind> AboutOptions() {
  using enum Fact;
  using enum KnownTo;
  return {
      {"help", all, ElsewhereCalled{"?", "usage"},
       {"h"}, {"topic"}, Request{answer::Help, false, Request::perhaps, HelpSubjects<program>}, "", "about",
       "print this help, or that on one topic, command or option"},
      {"version", all, ElsewhereCalled{"V"},
       {}, {}, Request{answer::Version}, "", "about", "print version, commit and compiled features"},
      {"as", raypro, {}, {}, {"course"}, Request{nullptr, false, Request::always, CommandLinesOfCourses}, "", "about",
       "must come first: accept that course's command line (raypro -help comp30019)"},
      {"list", both, ElsewhereCalled{"l"},
       {}, {"what"}, Request{answer::List, false, Request::perhaps, SubjectsOfList<program>}, "", "about",
       "list what this program knows"},
      {"info", raypro, {}, {}, {"image"}, Request{answer::Info, false, Request::always, nullptr, FileKind::image}, "", "about",
       "print how an image was made, from its own metadata"},
      {"complete", all, {}, {}, {"shell"}, Request{answer::Complete, false, Request::always, Shells}, "", "about",
       "print the completion script of a shell"},
      {"man", all, {}, {}, {"page"}, Request{answer::Manual, false, Request::perhaps, ManualPages}, "", "about",
       "print the manual page, or that of the scene language"},
  };
}
// clang-format on

/// Returns a program's table: those of the given rows and of the common rows that apply to it.
template <const Program& program>
std::vector<OptionKind> WithAboutOptions(std::vector<OptionKind> rows) {
  const std::vector<OptionKind> about = AboutOptions<program>();
  rows.insert(rows.end(), about.begin(), about.end());
  return KnownOptions(std::move(rows), program);
}

}  // namespace ray
