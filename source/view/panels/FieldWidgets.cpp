#include "source/view/panels/FieldWidgets.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "source/text/Number.h"
#include "source/text/NumberText.h"
#include "source/text/Words.h"

namespace ray {
namespace {

constexpr std::size_t longest_field = 256;
constexpr float share_of_fields = 0.55F;  // of the width

/// A number of Dear ImGui, which has singles, as the shortest decimal that stands for it.
double FromSingle(float single) { return ParseNumber(ToText(single)).value; }

std::string TextOf(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : " ") + ToText(value);
  return text;
}

/// Returns std::nullopt unless the text is that many numbers.
std::optional<std::vector<double>> NumbersIn(const std::string& text, std::size_t count) {
  std::vector<double> numbers;
  for (const std::string& word : SplitWords(text)) {
    const auto [value, problem] = ParseNumber(word);
    if (problem) return {};
    numbers.push_back(value);
  }
  if (numbers.size() != count) return {};
  return numbers;
}

/// A field for several numbers; returns the entered numbers once they are valid.
std::optional<std::vector<double>> DrawText(PanelFrame& frame, const std::string& name,
                                            const std::vector<double>& values) {
  std::array<char, longest_field> text{};
  TextOf(values).copy(text.data(), text.size() - 1);
  constexpr auto flags = ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll;
  const float all = ImGui::GetContentRegionAvail().x;
  const float label = ImGui::CalcTextSize(name.c_str()).x + ImGui::GetStyle().ItemSpacing.x;
  ImGui::SetNextItemWidth(std::min(share_of_fields * all, all - label));
  const bool is_entered = ImGui::InputText("##text", text.data(), text.size(), flags);
  frame.Note(name);
  ImGui::SameLine();
  ImGui::TextUnformatted(name.c_str());
  if (!is_entered) return {};
  auto numbers = NumbersIn(text.data(), values.size());
  if (!numbers) {
    const std::string rule = values.size() == 1 ? " must be a number" : " must be three numbers with blanks between";
    frame.Ask([message = name + rule](ViewerState& v) { v.notices.Show(message); });
  }
  return numbers;
}

/// Returns the text of the slider while it is moved.
std::optional<double> DrawSlider(PanelFrame& frame, const std::string& name, double value,
                                 const FieldWidgets::Range& range) {
  auto single = static_cast<float>(value);
  const bool is_logarithm = range.least > 0;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  const bool is_moved =
      ImGui::SliderFloat("##slider", &single, static_cast<float>(range.least), static_cast<float>(range.most), "",
                         is_logarithm ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
  frame.Note("slide " + name);
  if (!is_moved) return {};
  constexpr int digits = 3;  // as fine as pixels of a slider are
  return ParseNumber(Rounded(FromSingle(single), digits)).value;
}

/// The ranges of sliders, by the names of FieldsOf.
std::optional<FieldWidgets::Range> RangeOf(const ScnField& field) {
  struct Known {
    const char* name;
    FieldWidgets::Range range;
  };
  static const std::array known{
      Known{"shininess (n)", {1, 1000}},
      Known{"refraction index", {1, 3}},
      Known{"gloss exponent", {1, 10'000}},
      Known{"half angle, radians", {0.05, 1.4}},
      Known{"whole angle, degrees", {5, 160}},
      Known{"cutoff (sc)", {0, 1.6}},
  };
  const auto found = std::ranges::find_if(known, [&](const Known& k) { return field.name == k.name; });
  return found == known.end() ? std::nullopt : std::optional(found->range);
}

void AskForValues(PanelFrame& frame, std::uint32_t statement, const ScnField& field, std::vector<double> values,
                  bool continues) {
  frame.Ask([statement, field, values = std::move(values), continues](ViewerState& v) {
    v.editor.SetField(statement, field, values, continues);
  });
}

}  // namespace

bool DrawSwatch(PanelFrame& frame, const std::string& name, const std::vector<double>& color) {
  const double brightest = std::max({1.0, color[0], color[1], color[2]});
  const auto shown = [&](std::size_t i) { return static_cast<float>(color[i] / brightest); };
  constexpr auto flags = ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop | ImGuiColorEditFlags_NoAlpha;
  const bool is_clicked = ImGui::ColorButton("##swatch", {shown(0), shown(1), shown(2), 1}, flags);
  frame.Note(name);
  return is_clicked;
}

void FieldWidgets::DrawNumber(PanelFrame& frame, const std::string& name, double value, const Range& range,
                              const std::function<void(double, bool)>& set) {
  ImGui::PushID(name.c_str());
  if (const auto numbers = DrawText(frame, name, {value})) set(numbers->front(), false);
  if (const auto slid = DrawSlider(frame, name, value, range)) set(*slid, !ImGui::IsItemActivated());
  ImGui::PopID();
}

void FieldWidgets::Draw(PanelFrame& frame, std::uint32_t statement) {
  for (const ScnField& field : FieldsOf(frame.viewer.scene.Loaded().places, statement)) {
    ImGui::PushID(field.name.c_str());
    DrawField(frame, statement, field);
    ImGui::PopID();
  }
}

void FieldWidgets::DrawField(PanelFrame& frame, std::uint32_t statement, const ScnField& field) {
  if (!field.problem.empty()) return frame.Fact(field.name, field.problem);
  if (field.kind == ScnField::Kind::color) {
    if (DrawSwatch(frame, "pick " + field.name, field.values))
      picked_ = picked_ == field.name ? std::string() : field.name;
    ImGui::SameLine();
  }
  if (auto values = DrawText(frame, field.name, field.values))
    AskForValues(frame, statement, field, std::move(*values), false);
  if (field.kind == ScnField::Kind::color && picked_ == field.name) DrawPicker(frame, statement, field);
  if (field.kind != ScnField::Kind::number) return;
  const auto range = RangeOf(field);
  if (!range) return;
  if (const auto slid = DrawSlider(frame, field.name, field.values[0], *range))
    AskForValues(frame, statement, field, {*slid}, !ImGui::IsItemActivated());
}

void FieldWidgets::DrawPicker(PanelFrame& frame, std::uint32_t statement, const ScnField& field) {
  const std::vector<double>& color = field.values;
  // A light may be brighter than a picker goes: its hue is picked, and its brightness stays.
  const double brightest = std::max({1.0, color[0], color[1], color[2]});
  std::array<float, 3> shown{};
  for (std::size_t i = 0; i < 3; ++i) shown[i] = static_cast<float>(color[i] / brightest);
  constexpr auto flags = ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_NoSmallPreview |
                         ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoLabel | ImGuiColorEditFlags_NoOptions |
                         ImGuiColorEditFlags_NoDragDrop | ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_Float |
                         ImGuiColorEditFlags_PickerHueBar;
  constexpr float share_of_width = 0.7F;
  ImGui::SetNextItemWidth(share_of_width * ImGui::GetContentRegionAvail().x);
  const bool is_moved = ImGui::ColorPicker3("##picker", shown.data(), flags);
  frame.Note("picker of " + field.name);
  if (!is_moved) return;
  std::vector<double> picked;
  constexpr double levels = 1000;
  for (const float channel : shown)
    picked.push_back(std::round(brightest * static_cast<double>(channel) * levels) / levels);
  AskForValues(frame, statement, field, std::move(picked), !ImGui::IsItemActivated());
}

}  // namespace ray
