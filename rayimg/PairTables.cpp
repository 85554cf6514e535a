#include "rayimg/PairTables.h"

#include <nlohmann/json.hpp>

#include "grader/Html.h"
#include "rayimg/Images.h"
#include "source/app/Status.h"
#include "source/text/EnumNames.h"
#include "source/text/Quoting.h"
#include "source/text/Words.h"

namespace ray::rayimg {
namespace {

using grade::HtmlOf;

/// Returns FLIP, linear RMSE and the largest difference; empty if nothing was measured.
std::vector<std::string> Numbers(const PairResult& result) {
  if (!result.found) return {"", "", ""};
  const R2::Difference& d = result.found->difference;
  return {Rounded(result.found->flip), Rounded(d.rmse), Rounded(d.largest.value)};
}

std::string Count(const std::vector<PairResult>& results) {
  std::array<std::size_t, outcome_names.size()> counts{};
  for (const PairResult& result : results) ++counts[static_cast<std::size_t>(result.outcome)];
  std::string text;
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (counts[i] > 0) text += (text.empty() ? "" : ", ") + std::to_string(counts[i]) + " " + outcome_names[i];
  return Counted(results.size(), "image") + ": " + text;
}

const char* ClassOf(Outcome outcome) {
  return outcome == Outcome::equal ? "right" : outcome == Outcome::differs ? "known" : "failed";
}

std::string Section(const PairResult& result, std::size_t number) {
  std::string html = "<h2 id=\"p" + std::to_string(number) + "\">" + HtmlOf(result.pair.name) + "</h2>\n";
  const std::string summary = Summary(result);
  if (!summary.empty()) html += "<p>" + HtmlOf(summary) + "</p>\n";
  if (result.cause && !result.cause->hint.empty()) html += "<p><em>" + HtmlOf(result.cause->hint) + "</em></p>\n";
  return html + result.figures;
}

std::span<const unsigned char> BytesOf(const std::string& text) {
  return {reinterpret_cast<const unsigned char*>(text.data()), text.size()};
}

}  // namespace

PairTables::PairTables(const ImageOptions& options, std::span<const std::string> inputs)
    : title_(options.names[0] + " against " + options.names[1]) {
  if (!options.html.empty()) page_ = CheckOutput(options.html, inputs);
  if (!options.csv.empty()) table_ = CheckOutput(options.csv, inputs);
  if (page_ && table_ && page_->target == table_->target)
    throw UsageError("-html and -csv cannot both be " + Quoted(options.html));
}

void PairTables::Write(const std::vector<PairResult>& results) const {
  if (page_) WriteWhole(*page_, BytesOf(PageOf(results, title_)));
  if (table_) WriteWhole(*table_, BytesOf(CsvOf(results)));
}

std::string TextOf(const std::vector<PairResult>& results) {
  static constexpr std::size_t column_width = 13;
  const auto cell = [](std::string text) {
    text.resize(std::max(column_width, text.size() + 1), ' ');
    return text;
  };
  std::string table = cell("FLIP") + cell("linear RMSE") + cell("largest") + "image\n";
  for (const PairResult& result : results) {
    for (const std::string& number : Numbers(result)) table += cell(number.empty() ? "-" : number);
    const std::string summary = Summary(result);
    table += Escaped(result.pair.name) + (summary.empty() ? "" : ": " + summary) + "\n";
  }
  return table + Count(results) + "\n";
}

std::string JsonOf(const std::vector<PairResult>& results, const ImageOptions& options) {
  using Json = nlohmann::ordered_json;
  Json images = Json::array();
  const auto text = [](const std::string& name) { return name.empty() ? Json() : Json(name); };
  for (const PairResult& result : results) {
    Json json{{"name", result.pair.name},
              {"picture", text(result.pair.image)},
              {"reference", text(result.pair.reference)},
              {"outcome", NameOf(result.outcome)},
              {"remark", text(result.remark)},
              {"cause", Json()}};
    if (result.cause)
      json["cause"] = {{"name", result.cause->name}, {"title", result.cause->title}, {"share", result.cause->share}};
    if (result.found) json.update(JsonOf(*result.found, {}));
    images.push_back(std::move(json));
  }
  const Json json{{"pictures", options.names[0]}, {"references", options.names[1]}, {"images", images}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string CsvOf(const std::vector<PairResult>& results) {
  std::string csv =
      "image,picture,reference,outcome,flip,rmse,relative_mse,display_rmse,psnr,largest,pixels,cause,share,remark\n";
  for (const PairResult& result : results) {
    for (const std::string& text : {result.pair.name, result.pair.image, result.pair.reference})
      csv += CsvField(text) + ",";
    csv += NameOf(result.outcome);
    if (result.found) {
      const R2::Difference& d = result.found->difference;
      for (const double number : {result.found->flip, d.rmse, d.relative_mse, d.display_rmse, d.psnr, d.largest.value})
        csv += "," + ToText(number);
      csv += "," + std::to_string(d.pixels);
    } else {
      csv += ",,,,,,,";
    }
    csv += "," + (result.cause ? result.cause->name + "," + Rounded(result.cause->share) : ",") + "," +
           CsvField(result.remark) + "\n";
  }
  return csv;
}

std::string PageOf(const std::vector<PairResult>& results, const std::string& title) {
  std::string table =
      "<p>" + HtmlOf(Count(results)) + ".</p>\n<table><tr><th>image<th>FLIP<th>linear RMSE<th>largest<th></tr>\n";
  std::string sections;
  for (std::size_t i = 0; i < results.size(); ++i) {
    const PairResult& result = results[i];
    table += std::string("<tr class=\"") + ClassOf(result.outcome) + "\"><td><a href=\"#p" + std::to_string(i) + "\">" +
             HtmlOf(result.pair.name) + "</a>";
    for (const std::string& number : Numbers(result)) table += "<td class=\"n\">" + number;
    table += "<td>" + HtmlOf(Summary(result)) + "</tr>\n";
    sections += Section(result, i);
  }
  return grade::Page(title, table + "</table>\n" + sections);
}

}  // namespace ray::rayimg
