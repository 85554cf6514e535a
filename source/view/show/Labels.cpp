#include "source/view/show/Show.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "source/text/NumberText.h"
#include "source/text/Words.h"
#include "source/view/HelpText.h"
#include "source/view/commands/Commands.h"

namespace ray {
namespace {

constexpr Rgba text_color{255, 255, 255, 255}, problem_color{255, 196, 186, 255};
constexpr std::array<Rgba, 3> channel_colors{{{255, 208, 208, 255}, {208, 255, 208, 255}, {216, 220, 255, 255}}};
constexpr double margin = 0.35;        // of text, in heights of its lines
constexpr double lines_at_bottom = 5;  // the message, names of the slider's sides, and half of a value
constexpr std::size_t letters_of_a_value = 5;

/// Returns the value in letters_of_a_value letters.
std::string ShortValue(float value) {
  const double v = static_cast<double>(value), size = std::abs(v);
  constexpr double of_two_decimals = 9.99, of_one = 99.9, whole = 9999;
  if (size < of_two_decimals) return Fixed(v, 2);
  if (size < of_one) return Fixed(v, 1);
  return size < whole ? Fixed(v, 0) : size < 1e9 ? Rounded(v, 1) : std::isfinite(v) ? "huge" : "inf";
}

/// Adds the values of pixels, if these are large enough.
///   split   the column from which on the pixels are the reference's
void AddValuesOfPixels(const ViewerState& viewer, std::vector<Label>& labels, const LetterSize& letters, double split) {
  const Frame& frame = viewer.FlatJob()->frame();
  const PixelBox place = viewer.PlaceOf(*viewer.FlatJob());
  const double side = place.width / frame.Width();
  if (side < std::max((letters_of_a_value + 1) * letters.width, 3 * letters.height)) return;
  const auto first = [&](double from) { return std::max(0, static_cast<int>(std::ceil(-from / side - 0.5))); };
  const std::shared_ptr<const R2::Image>& reference = viewer.traced.Reference();
  const DrawingSize view = viewer.layout().view;
  for (int y = first(place.bottom); y < frame.Height() && place.bottom + (y + 0.5) * side < view.height; ++y)
    for (int x = first(place.left); x < frame.Width() && place.left + (x + 0.5) * side < view.width; ++x) {
      const R2::Point middle{place.left + (x + 0.5) * side, place.bottom + (y + 0.5) * side};
      if (middle.y < lines_at_bottom * letters.height) continue;
      const bool is_beside = middle.x >= split;
      if (is_beside && (!reference || x >= reference->Width() || y >= reference->Height())) continue;
      const R2::Color value = is_beside ? reference->At(x, y) : frame.At(x, y);
      const std::array<double, 3> channels{value.r, value.g, value.b};
      for (std::size_t i = 0; i < channels.size(); ++i) {
        const std::string text = ShortValue(static_cast<float>(channels[i]));
        labels.push_back({middle.x - static_cast<double>(text.size()) * letters.width / 2,
                          middle.y + (0.5 - static_cast<double>(i)) * letters.height, text, channel_colors[i]});
      }
    }
}

/// Adds the values of pixels, and labels to both sides of the flat image's slider.
void AddLabelsOfFlat(const ViewerState& viewer, std::vector<Label>& labels, const LetterSize& letters) {
  if (!viewer.FlatJob() || viewer.traced.HowCompared() != TracedImages::Comparing::no) return;
  const DrawingSize view = viewer.layout().view;
  const double split = viewer.flat.Slider() < 1 ? viewer.flat.Slider() * view.width : view.width;
  const std::shared_ptr<const R2::Image>& reference = viewer.traced.Reference();
  AddValuesOfPixels(viewer, labels, letters, split);
  if (split < view.width) {
    const double y = 2 * letters.height, gap = letters.width;
    const std::string left = "image", right = reference ? "reference" : "preview";
    const auto wide = [&](const std::string& name) { return static_cast<double>(name.size()) * letters.width; };
    if (split > wide(left) + 2 * gap) labels.push_back({split - gap - wide(left), y, left});
    if (view.width - split > wide(right) + 2 * gap) labels.push_back({split + gap, y, right});
  }
}

/// Returns a note if the preview does not show the projection of the camera; empty if it does.
std::string TextOfProjection(const ViewerState& viewer) {
  const Camera& camera = viewer.navigator.camera();
  if (camera.IsPinhole() || viewer.flat.IsShown() || viewer.traced.IsLive()) return {};
  return std::string("preview of a pinhole; S traces the true projection, ") + camera.kind->name;
}

}  // namespace

std::string TextOfProblems(const ViewerState& viewer) {
  if (viewer.scene.Mistakes().empty()) return {};
  const SceneError& first = viewer.scene.Mistakes().front();
  std::string text = first.file;
  if (first.line > 0) text += ":" + std::to_string(first.line) + ":" + std::to_string(first.column);
  text += (text.empty() ? "" : ": ") + first.message.substr(0, first.message.find('\n'));
  const std::size_t more = viewer.scene.Mistakes().size() - 1;
  if (more > 0) text += ", and " + Counted(more, "more mistake");
  if (viewer.scene.MistakenFile() != viewer.settings.scene) return text + ". Escape closes this.";
  return text + (viewer.scene.ShowsNothing() ? ". The scene is shown once the file is right."
                                             : ". The scene from before is shown until the file is right.");
}

std::vector<Label> MakeLabels(const ViewerState& viewer) {
  const double strength = viewer.notices.Strength();
  const bool has_message = !viewer.notices.Message().empty() && strength > 0;
  // Above the view, whole texts, and their colors.
  std::vector<std::pair<std::string, Rgba>> upper;
  if (!viewer.scene.Mistakes().empty()) upper.emplace_back(TextOfProblems(viewer), problem_color);
  if (viewer.reader.IsBusy()) upper.emplace_back(viewer.reader.Describe(), text_color);
  if (viewer.section.IsShown()) {
    upper.emplace_back("cross section: " + viewer.section.Describe(viewer.screen.size.height), text_color);
    if (std::string text = TextOfSection(viewer); !text.empty()) upper.emplace_back(std::move(text), text_color);
  }
  if (viewer.scene.ShowsNothing() && viewer.scene.Mistakes().empty())
    upper.emplace_back("the scene has no shapes", text_color);
  if (viewer.Parts().bar && !viewer.status.MissingLight().empty())
    upper.emplace_back(viewer.status.MissingLight(), text_color);
  if (std::string text = viewer.traced.ScaleOfComparison(); !text.empty())
    upper.emplace_back(std::move(text), text_color);
  if (std::string text = TextOfProjection(viewer); !text.empty()) upper.emplace_back(std::move(text), text_color);
  if (viewer.selection.pick && !viewer.shows.panels)
    for (const std::string& text : viewer.selection.pick->text) upper.emplace_back(text, text_color);

  std::vector<Label> labels;
  if (upper.empty() && !has_message && !viewer.FlatJob()) return labels;
  const LetterSize letters = viewer.panels->Letters();
  const double edge = letters.height * margin;
  const int columns = static_cast<int>((viewer.layout().view.width - 2 * edge) / letters.width);
  if (viewer.section.IsShown())
    for (Label label : viewer.section_pane.drawing->labels)
      label.x += viewer.layout().view.width, labels.push_back(std::move(label));
  AddLabelsOfFlat(viewer, labels, letters);
  double y = viewer.layout().view.height - letters.height - edge;
  for (const auto& [text, color] : upper)
    for (const std::string& line : InLines(text, columns)) {
      labels.push_back({edge, y, line, color});
      y -= letters.height;
    }
  if (!has_message) return labels;
  const auto lines = InLines(viewer.notices.Message(), columns);
  const bool has_bar_over_view = viewer.Parts().bar && !viewer.Parts().column;
  y = edge + static_cast<double>(lines.size() - 1) * letters.height +
      (has_bar_over_view ? viewer.panels->HeightOfBar() : 0);
  for (const std::string& line : lines) {
    labels.push_back({edge, y, line, {255, 255, 255, static_cast<std::uint8_t>(255 * strength)}});
    y -= letters.height;
  }
  return labels;
}

}  // namespace ray
