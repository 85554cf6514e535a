#include <algorithm>
#include <array>
#include <cmath>

#include "R1/Elementary.h"
#include "source/text/NumberText.h"
#include "source/view/Viewer.h"

/// The rendered picture shown flat.
namespace ray {
namespace {

constexpr double zoom_of_a_step = 1.25;
constexpr double reach_of_slider = 5;       // pixels to each side in which it is taken hold of
constexpr double largest_preview = 16'384;  // pixels a side: OpenGL's least limit of a viewport, where it has one
constexpr double largest_picture = 262'144;
constexpr double lines_at_bottom = 5;  // the message, names of the slider's sides, and half of a value
constexpr std::size_t letters_of_a_value = 5;
constexpr std::array<Rgba, 3> channel_colors{{{255, 208, 208, 255}, {208, 255, 208, 255}, {216, 220, 255, 255}}};

/// In letters_of_a_value letters.
std::string ShortValue(float value) {
  const double v = static_cast<double>(value), size = std::abs(v);
  constexpr double of_two_decimals = 9.99, of_one = 99.9, whole = 9999;
  if (size < of_two_decimals) return Fixed(v, 2);
  if (size < of_one) return Fixed(v, 1);
  return size < whole ? Fixed(v, 0) : size < 1e9 ? Rounded(v, 1) : std::isfinite(v) ? "huge" : "inf";
}

}  // namespace

const RenderJob* Viewer::FlatJob() const {
  if (!flat_.IsShown()) return nullptr;
  return pictures_.IsLive() ? pictures_.Live() : pictures_.Trace();
}

RenderSettings Viewer::SettingsOfPicture() const {
  const RenderJob* job = FlatJob();
  return job ? job->Settings() : SettingsOfView();
}

Camera Viewer::CameraOfPicture() const {
  const RenderJob* job = FlatJob();
  return job ? job->Settings().view.value_or(scene_->parsed.scene.camera) : navigator_.camera();
}

DrawingSize Viewer::SizeOfPreview() const {
  const RenderJob* job = FlatJob();
  return job ? DrawingSize{job->Settings().width, job->Settings().height} : ViewSize();
}

void Viewer::ToggleFlat() {
  InvalidateLines();
  if (flat_.IsShown()) {
    flat_.Hide();
    return ShowMessage("flat image off");
  }
  if (!pictures_.Trace() && !pictures_.IsLive()) return ShowMessage("nothing is rendered yet; press S or P first");
  flat_.Show();
  ShowMessage("flat image: wheel zooms, drag moves, Shift+drag slides against the " +
              std::string(pictures_.Reference() ? "reference" : "preview"));
}

void Viewer::DragFlat(const R2::Point& from, const R2::Point& to) {
  if (press_->moves_slider) {
    if (!pictures_.Reference() && PlaceOfPicture().width > largest_preview)
      return ShowMessage("zoom out to slide against the preview");
    flat_.SetSlider(to.x / ViewSize().width);
    ShowMessage("slider at " + Rounded(100 * flat_.Slider(), 3) + " %");
  } else {
    flat_.Pan(to - from);
  }
  needs_redraw_ = true;
}

bool Viewer::TakesSlider(const ButtonEvent& event) const {
  return event.modifiers.shift || std::abs(event.x - flat_.Slider() * ViewSize().width) <= reach_of_slider;
}

void Viewer::ZoomFlat(const ScrollEvent& event) {
  flat_.Zoom(R1::Pow(zoom_of_a_step, event.steps), {event.x, event.y}, FittingPicture(),
             pictures_.Reference() || flat_.Slider() == 1 ? largest_picture : largest_preview);
  ShowMessage("zoom " + Fixed(100 * PlaceOfPicture().width / SettingsOfPicture().width, 0) + " %");
}

void Viewer::ShowFlat(FrameState& shown) const {
  if (!FlatJob() || !shown.picture) return;
  static const auto no_lines = std::make_shared<const Lines>();
  shown.lines = no_lines;
  shown.marks = shown.lit = nullptr;
  shown.shows_edges = false;
  shown.split = static_cast<int>(std::lround(flat_.Slider() * shown.view.width));
  if (!pictures_.Reference()) return;
  shown.beside = FrameState::Picture{};
  shown.beside->image = pictures_.Reference();
  shown.beside->exposure = shown.picture->exposure;
  shown.beside->place = shown.picture->place;
}

void Viewer::AddLabelsOfFlat(std::vector<Label>& labels, const LetterSize& letters) const {
  if (!FlatJob() || pictures_.HowCompared() != TracedPictures::Comparing::no) return;
  const DrawingSize view = ViewSize();
  const double split = flat_.Slider() < 1 ? flat_.Slider() * view.width : view.width;
  const std::shared_ptr<const R2::Image>& reference = pictures_.Reference();
  AddValuesOfPixels(labels, letters, split);
  if (split < view.width) {
    const double y = 2 * letters.height, gap = letters.width;
    const std::string left = "image", right = reference ? "reference" : "preview";
    const auto wide = [&](const std::string& name) { return static_cast<double>(name.size()) * letters.width; };
    if (split > wide(left) + 2 * gap) labels.push_back({split - gap - wide(left), y, left});
    if (view.width - split > wide(right) + 2 * gap) labels.push_back({split + gap, y, right});
  }
}

void Viewer::AddValuesOfPixels(std::vector<Label>& labels, const LetterSize& letters, double split) const {
  const Frame& frame = FlatJob()->frame();
  const PixelBox place = PlaceOfPicture();
  const double side = place.width / SettingsOfPicture().width;
  if (side < std::max((letters_of_a_value + 1) * letters.width, 3 * letters.height)) return;
  const auto first = [&](double from) { return std::max(0, static_cast<int>(std::ceil(-from / side - 0.5))); };
  const std::shared_ptr<const R2::Image>& reference = pictures_.Reference();
  const DrawingSize view = ViewSize();
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

}  // namespace ray
