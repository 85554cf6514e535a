#include "grader/Reports.h"

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <sstream>

#include "grader/Html.h"
#include "source/text/NumberText.h"
#include "source/text/Quoting.h"

namespace ray::grade {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array outcome_names{"right", "known", "different", "failed"};
const char* NameOf(SceneResult::Outcome outcome) { return outcome_names[static_cast<std::size_t>(outcome)]; }

std::string PointsText(double points) { return Rounded(points, 4); }

std::string Figure(const R2::Image& image, const std::string& caption) {
  return "<figure class=\"third\">" + ImageTag(image, caption) + "<figcaption>" + HtmlOf(caption) +
         "</figcaption></figure>\n";
}

std::string Paragraphs(const std::vector<std::string>& sentences) {
  std::string html;
  for (const std::string& sentence : sentences) html += "<p>" + HtmlOf(sentence) + "</p>\n";
  return html;
}

std::string WorstPixel(const SceneResult& scene) {
  if (scene.worst_x < 0) return {};
  constexpr int reach = 6, scale = 12;
  const std::string where = std::to_string(scene.worst_x) + " " + std::to_string(scene.worst_y);
  return "<h3>The pixel that differs most clearly in " + HtmlOf(scene.title) + ": " + where +
         " (from the lower left)</h3>\n" +
         Figure(CropAround(scene.expected, scene.worst_x, scene.worst_y, reach, scale), "expected") +
         Figure(CropAround(scene.actual, scene.worst_x, scene.worst_y, reach, scale), "yours") +
         "<p>What rays do there in a correct program, and what each of them contributes:</p><pre>" +
         HtmlOf(scene.ray_tree) + "</pre>\n";
}

std::string ProgramOutput(const SceneResult& scene) {
  if (scene.program_output.empty()) return {};
  return "<p>What the program printed:</p><pre>" + HtmlOf(scene.program_output.substr(0, 4000)) + "</pre>\n";
}

std::string BuildSection(const StudentResult& student) {
  if (student.build_log.empty() && student.problem.empty()) return {};
  const bool is_built = student.problem.empty();
  const std::string log = student.build_log.empty() ? "" : "<pre>" + HtmlOf(student.build_log) + "</pre>\n";
  return "<h2>Build</h2>\n<p class=\"" + std::string(is_built ? "right" : "failed") + "\">" +
         HtmlOf(is_built ? "The program was built." : "The program " + student.problem + ".") + "</p>\n" + log;
}

/// Returns the section of a scene.
///   pixel   false if the page shows the worst pixel elsewhere
std::string SceneSection(const SceneResult& scene, bool pixel = true) {
  std::string html = "<h2 id=\"" + HtmlOf(scene.scene) + "\">" + HtmlOf(scene.title) + ": " + PointsText(scene.score) +
                     " of " + PointsText(scene.points) + " points</h2>\n";
  if (!scene.teaches.empty()) html += "<p><em>" + HtmlOf(scene.teaches) + "</em></p>\n";
  html += "<p class=\"" + std::string(NameOf(scene.outcome)) + "\">" + HtmlOf(scene.headline) + "</p>\n" +
          Paragraphs(scene.remarks) + ProgramOutput(scene);
  if (scene.expected.Width() > 0)
    html += Figure(scene.expected, "expected") + Figure(scene.actual, "yours") +
            Figure(scene.difference, "difference times 4: red too bright, blue too dark");
  return pixel ? html + WorstPixel(scene) : html;
}

std::string SceneLink(const std::string& scene, const std::string& title) {
  return "<a href=\"#" + HtmlOf(scene) + "\">" + HtmlOf(title) + "</a>";
}

/// Returns the verdict, the scenes that show it, and the pixel that shows it best.
std::string VerdictSection(const StudentResult& student) {
  const StudentVerdict& verdict = student.verdict;
  if (verdict.headline.empty()) return {};
  const bool is_right = student.Score() == student.Points();
  std::string html = "<p class=\"" +
                     std::string(is_right                   ? "right"
                                 : verdict.mistakes.empty() ? "different"
                                                            : "known") +
                     "\"><strong>" + HtmlOf(verdict.headline) + "</strong></p>\n" + Paragraphs(verdict.remarks);
  std::string links, pixel;
  for (const SceneResult& scene : student.scenes) {
    if (std::ranges::find(verdict.scenes, scene.scene) != verdict.scenes.end())
      links += (links.empty() ? "" : ", ") + SceneLink(scene.scene, scene.title);
    if (scene.scene == verdict.best_scene) pixel = WorstPixel(scene);
  }
  if (!links.empty()) html += "<p>Shown by: " + links + ".</p>\n";
  return html + pixel;
}

std::string Overview(const StudentResult& student) {
  std::string html = "<table><tr><th>scene<th>points<th>result</tr>\n";
  for (const SceneResult& scene : student.scenes)
    html += "<tr class=\"" + std::string(NameOf(scene.outcome)) + "\"><td>" + SceneLink(scene.scene, scene.title) +
            "<td class=\"n\">" + PointsText(scene.score) + " / " + PointsText(scene.points) +
            "<td>" + HtmlOf(scene.headline) + "</tr>\n";
  return html + "</table>\n";
}

Json JsonOf(const SceneResult& scene) {
  return {{"scene", scene.scene},
          {"title", scene.title},
          {"points", scene.points},
          {"score", scene.score},
          {"outcome", NameOf(scene.outcome)},
          {"headline", scene.headline},
          {"mistakes", scene.mistakes},
          {"note", scene.note},
          {"explained", scene.explained},
          {"percent", scene.percent},
          {"seconds", scene.seconds}};
}

SceneResult ResultOf(const Json& json) {
  SceneResult scene;
  json.at("scene").get_to(scene.scene);
  json.at("title").get_to(scene.title);
  json.at("points").get_to(scene.points);
  json.at("score").get_to(scene.score);
  json.at("headline").get_to(scene.headline);
  json.at("mistakes").get_to(scene.mistakes);
  json.at("note").get_to(scene.note);
  json.at("explained").get_to(scene.explained);
  json.at("percent").get_to(scene.percent);
  json.at("seconds").get_to(scene.seconds);
  const auto name = std::ranges::find(outcome_names, json.at("outcome").get<std::string>());
  if (name == outcome_names.end()) throw Json::other_error::create(501, "no such outcome", &json);
  scene.outcome = static_cast<SceneResult::Outcome>(name - outcome_names.begin());
  return scene;
}

std::string StudentLink(const std::string& name) {
  return "<a href=\"" + HtmlOf(name) + "/index.html\">" + HtmlOf(name) + "</a>";
}

/// Returns the causes and notes of a class, the most common first, each with its students.
std::string CommonCauses(const std::vector<StudentResult>& students) {
  std::map<std::string, std::set<std::string>> students_with;
  for (const StudentResult& student : students)
    for (const SceneResult& scene : student.scenes) {
      std::istringstream causes(scene.mistakes);
      for (std::string cause; std::getline(causes, cause, '+');) students_with[cause].insert(student.name);
      if (!scene.note.empty()) students_with[scene.note].insert(student.name);
    }
  std::vector<std::pair<std::string, std::set<std::string>>> sorted(students_with.begin(), students_with.end());
  std::ranges::stable_sort(sorted, [](const auto& a, const auto& b) { return a.second.size() > b.second.size(); });
  std::string html = "<h2>Common causes</h2>\n<table><tr><th>cause<th>students<th>who</tr>\n";
  for (const auto& [cause, names] : sorted) {
    std::string links;
    for (const std::string& name : names) links += (links.empty() ? "" : ", ") + StudentLink(name);
    const std::string count = std::to_string(names.size());
    html += "<tr><td>" + HtmlOf(cause) + "<td><span class=\"bar\" style=\"width:" + count + "em\"></span> " + count +
            "<td>" + links + "</tr>\n";
  }
  return html + "</table>\n";
}

/// A row below the students of a table: its name, and its function of the points.
struct Statistic {
  const char* name;
  double (*of)(std::vector<double> points);
};

constexpr std::array statistics{
    Statistic{"maximum", [](std::vector<double> points) { return *std::ranges::max_element(points); }},
    Statistic{"mean",
              [](std::vector<double> points) {
                return std::accumulate(points.begin(), points.end(), 0.0) / static_cast<double>(points.size());
              }},
    Statistic{"median", [](std::vector<double> points) {
                std::ranges::sort(points);
                return (points[(points.size() - 1) / 2] + points[points.size() / 2]) / 2;
              }}};

std::vector<double> TotalsOf(const std::vector<StudentResult>& students) {
  std::vector<double> totals;
  for (const StudentResult& student : students) totals.push_back(student.Score());
  return totals;
}

std::vector<double> ScoresIn(const std::vector<StudentResult>& students, std::size_t scene) {
  std::vector<double> scores;
  for (const StudentResult& student : students)
    if (scene < student.scenes.size()) scores.push_back(student.scenes[scene].score);
  return scores;
}

/// Returns the notes of a student's scenes, without repetition.
std::string NotesOf(const StudentResult& student) {
  std::set<std::string> notes;
  for (const SceneResult& scene : student.scenes)
    if (!scene.note.empty()) notes.insert(scene.note);
  std::string text;
  for (const std::string& note : notes) text += (text.empty() ? "" : ", ") + note;
  return text;
}

std::string ClassTable(const std::vector<StudentResult>& students, const Suite& suite) {
  std::string html = "<h2>Points</h2>\n<table><tr><th>student<th>points";
  for (const SuiteScene& scene : suite.scenes) html += "<th>" + HtmlOf(scene.name);
  html += "<th>verdict<th>remarks</tr>\n";
  for (const StudentResult& student : students) {
    html += "<tr><td>" + StudentLink(student.name) + "<td class=\"n\">" + PointsText(student.Score());
    for (const SceneResult& scene : student.scenes)
      html += "<td class=\"n " + std::string(NameOf(scene.outcome)) + "\" title=\"" + HtmlOf(scene.headline) + "\">" +
              PointsText(scene.score);
    const std::string verdict =
        student.problem.empty() ? student.verdict.headline : "The program " + student.problem + ".";
    const std::string notes = NotesOf(student), between = notes.empty() || student.comment.empty() ? "" : "; ";
    html += "<td>" + HtmlOf(verdict) + "<td>" + HtmlOf(notes + between + student.comment) + "</tr>\n";
  }
  for (const Statistic& statistic : statistics) {
    html +=
        "<tr><th>" + std::string(statistic.name) + "<th class=\"n\">" + PointsText(statistic.of(TotalsOf(students)));
    for (std::size_t i = 0; i < suite.scenes.size(); ++i)
      html += "<th class=\"n\">" + PointsText(statistic.of(ScoresIn(students, i)));
    html += "<th><th></tr>\n";
  }
  return html + "</table>\n";
}

constexpr const char* comment_begins = "<!-- comment -->";
constexpr const char* comment_ends = "<!-- end of comment -->";

}  // namespace

double StudentResult::Score() const {
  return std::accumulate(scenes.begin(), scenes.end(), 0.0,
                         [](double sum, const SceneResult& scene) { return sum + scene.score; });
}

double StudentResult::Points() const {
  return std::accumulate(scenes.begin(), scenes.end(), 0.0,
                         [](double sum, const SceneResult& scene) { return sum + scene.points; });
}

std::string StudentPage(const StudentResult& student, const Suite& suite, const std::string& sandbox) {
  std::string body =
      "<p>" + PointsText(student.Score()) + " of " + PointsText(suite.Points()) + " points.</p>\n" +
      comment_begins + comment_ends + "\n" + VerdictSection(student) +
                     Overview(student) +
      "<p>Only steady pixels are compared: those that do not change when the camera is moved by less than "
      "half a pixel. Differences of rounding, and at edges, do not count. A cause is named if it explains "
      "more than 95% of the difference in every scene.</p>\n";
  body += BuildSection(student);
  for (const SceneResult& scene : student.scenes)
    body += SceneSection(scene, scene.scene != student.verdict.best_scene);
  return Page(suite.name + (student.name.empty() ? "" : ": " + student.name),
              body + "<p>" + HtmlOf(sandbox) + "</p>\n");
}

std::string ResultsJson(const StudentResult& student, const std::string& identity) {
  Json json{{"score", student.Score()}, {"visibility", "visible"}, {"tests", Json::array()}};
  Json scenes = Json::array();
  for (const SceneResult& scene : student.scenes) {
    json["tests"].push_back({{"name", scene.title},
                             {"score", scene.score},
                             {"max_score", scene.points},
                             {"status", scene.outcome == SceneResult::Outcome::right ? "passed" : "failed"},
                             {"output", SceneSection(scene)},
                             {"output_format", "html"},
                             {"visibility", "visible"}});
    scenes.push_back(JsonOf(scene));
  }
  json["output"] = VerdictSection(student) + BuildSection(student);
  json["output_format"] = "html";
  const StudentVerdict& verdict = student.verdict;
  json["extra_data"] = {{"graded_by", identity},
                        {"student", student.name},
                        {"complete", student.is_complete},
                        {"problem", student.problem},
                        {"verdict",
                         {{"headline", verdict.headline},
                          {"remarks", verdict.remarks},
                          {"mistakes", verdict.mistakes},
                          {"scenes", verdict.scenes}}},
                        {"scenes", scenes}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::optional<StudentResult> ReadResultsJson(const std::string& text, const std::string& identity) {
  try {
    const Json json = Json::parse(text).at("extra_data");
    if (json.at("graded_by") != identity) return {};
    StudentResult student;
    json.at("student").get_to(student.name);
    json.at("complete").get_to(student.is_complete);
    json.at("problem").get_to(student.problem);
    const Json& verdict = json.at("verdict");
    verdict.at("headline").get_to(student.verdict.headline);
    verdict.at("remarks").get_to(student.verdict.remarks);
    verdict.at("mistakes").get_to(student.verdict.mistakes);
    verdict.at("scenes").get_to(student.verdict.scenes);
    for (const Json& scene : json.at("scenes")) student.scenes.push_back(ResultOf(scene));
    return student;
  } catch (const Json::exception&) {
    return {};
  }
}

std::string ClassCsv(const std::vector<StudentResult>& students) {
  std::string csv = "student,scene,points,score,outcome,mistakes,remark,percent_differing,seconds,cause,comment\n";
  for (const StudentResult& student : students)
    for (const SceneResult& scene : student.scenes)
      csv += CsvField(student.name) + "," + CsvField(scene.scene) + "," + ToText(scene.points) + "," +
             PointsText(scene.score) + "," + NameOf(scene.outcome) + "," + CsvField(scene.mistakes) + "," +
             CsvField(scene.note) + "," + Rounded(scene.percent, 4) + "," + Rounded(scene.seconds, 3) + "," +
             CsvField(student.verdict.mistakes) + "," + CsvField(student.comment) + "\n";
  if (students.empty()) return csv;
  for (const Statistic& statistic : statistics)
    for (std::size_t i = 0; i < students[0].scenes.size(); ++i)
      csv += "(" + std::string(statistic.name) + ")," + CsvField(students[0].scenes[i].scene) + "," +
             ToText(students[0].scenes[i].points) + "," + PointsText(statistic.of(ScoresIn(students, i))) + ",,,,,,,\n";
  return csv;
}

std::string ClassPage(const std::vector<StudentResult>& students, const Suite& suite) {
  return Page(suite.name, students.empty() ? "" : ClassTable(students, suite) + CommonCauses(students));
}

std::string WithComment(const std::string& page, const std::string& comment) {
  const std::size_t begin = page.find(comment_begins), end = page.find(comment_ends);
  if (begin == std::string::npos || end == std::string::npos || end < begin) return page;
  const std::string html = comment.empty() ? "" : "<h2>Comment</h2>\n<p>" + HtmlOf(comment) + "</p>\n";
  return page.substr(0, begin) + comment_begins + html + page.substr(end);
}

}  // namespace ray::grade
