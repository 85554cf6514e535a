#include "source/view/panels/Panels.h"

#include <imgui.h>
#include <imgui_internal.h>  // LogBuffer

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "source/view/panels/HelpSheet.h"
#include "source/view/panels/Panel.h"
#include "source/view/panels/PanelLook.h"

namespace ray {

extern const PanelPart errors_part, open_part, outliner_part, edit_part, image_part, layers_part, pixel_part,
    statistics_part, settings_part, accelerators_part, display_part, look_part;

namespace {

/// The panels, from the top, and their parts.
struct PanelKind {
  const char* title;
  bool is_open_at_first;
  std::vector<const PanelPart*> parts;
};
const std::array<PanelKind, 7> panel_kinds{{{"Errors", true, {&errors_part}},
                                            {"Open", true, {&open_part}},
                                            {"Scene", true, {&outliner_part, &edit_part}},
                                            {"Image", false, {&image_part, &layers_part}},
                                            {"Pixel", true, {&pixel_part}},
                                            {"Render", false, {&statistics_part, &settings_part, &accelerators_part}},
                                            {"View", false, {&display_part, &look_part}}}};

constexpr double narrowest = 150;                      // units: the titles, and short words
constexpr double widest_share = 0.9;                   // of the drawing: some of it stays to be clicked
constexpr double column_width = 330;                   // units at most, and at first
constexpr double column_share = 0.49;                  // of a drawing too narrow for that
constexpr double bar_padding = 4;                      // units, above and below the text of the status bar
constexpr double help_wide = 1240, help_share = 0.94;  // units at most; of the width that there is
constexpr float shortest_time = 1e-3F;                 // seconds; Dear ImGui wants some between frames

constexpr auto fixed_window =
    ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav;

/// The position of the pointer if there is none.
constexpr float nowhere = -std::numeric_limits<float>::max();

Rgba ColorOf(ImU32 color) {
  const auto byte = [&](int shift) { return static_cast<std::uint8_t>(color >> shift); };
  return {byte(IM_COL32_R_SHIFT), byte(IM_COL32_G_SHIFT), byte(IM_COL32_B_SHIFT), byte(IM_COL32_A_SHIFT)};
}

std::shared_ptr<const PanelDrawing> AsDrawing(const ImDrawData& data, std::shared_ptr<const InkSheet> sheet) {
  auto drawing = std::make_shared<PanelDrawing>();
  drawing->sheet = std::move(sheet);
  const auto width = static_cast<int>(data.DisplaySize.x), height = static_cast<int>(data.DisplaySize.y);
  for (int i = 0; i < data.CmdListsCount; ++i) {
    const ImDrawList& list = *data.CmdLists[i];
    const auto first_corner = static_cast<std::uint32_t>(drawing->corners.size());
    for (const ImDrawVert& v : list.VtxBuffer)
      drawing->corners.push_back({v.pos.x, v.pos.y, v.uv.x, v.uv.y, ColorOf(v.col)});
    for (const ImDrawCmd& command : list.CmdBuffer) {
      const ImVec4& clip = command.ClipRect;
      const PanelDrawing::Part part{std::clamp(static_cast<int>(clip.x), 0, width),
                                    std::clamp(static_cast<int>(clip.y), 0, height),
                                    std::clamp(static_cast<int>(clip.z), 0, width),
                                    std::clamp(static_cast<int>(clip.w), 0, height),
                                    drawing->indices.size(),
                                    command.ElemCount};
      for (unsigned int k = 0; k < command.ElemCount; ++k)
        drawing->indices.push_back(first_corner + command.VtxOffset +
                                   list.IdxBuffer[static_cast<int>(command.IdxOffset + k)]);
      if (part.left < part.right && part.top < part.bottom) drawing->parts.push_back(part);
    }
  }
  return drawing;
}

/// The keys that panels understand, and their codes in Dear ImGui.
constexpr std::pair<ImGuiKey, Key> key_names[] = {
    {ImGuiKey_LeftArrow, Key::left},
    {ImGuiKey_RightArrow, Key::right},
    {ImGuiKey_UpArrow, Key::up},
    {ImGuiKey_DownArrow, Key::down},
    {ImGuiKey_PageUp, Key::page_up},
    {ImGuiKey_PageDown, Key::page_down},
    {ImGuiKey_Home, Key::home},
    {ImGuiKey_End, Key::end},
    {ImGuiKey_Backspace, Key::backspace},
    {ImGuiKey_Delete, Key::del},
    {ImGuiKey_Enter, Key::enter},
    {ImGuiKey_Escape, Key::escape},
    {ImGuiKey_A, Key::a},
    {ImGuiKey_C, Key::c},
    {ImGuiKey_V, Key::v},
    {ImGuiKey_X, Key::x},
    {ImGuiKey_Y, Key::y},
    {ImGuiKey_Z, Key::z},
};

/// Panels by Dear ImGui, in a context of their own. A frame is made for every event, so that its effects do not
/// depend on the times of drawings.
class ImGuiPanels : public Panels {
 public:
  ImGuiPanels() : context_(ImGui::CreateContext()) {
    Use();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = io.LogFilename = nullptr;  // no unexpected files
    // The latter lets edges be dragged, whatever the pointer looks like then.
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset | ImGuiBackendFlags_HasMouseCursors;
    io.ConfigInputTextCursorBlink = false;
    io.KeyRepeatDelay = std::numeric_limits<float>::max();  // keys that are held come again as events
    io.ClipboardUserData = this;
    io.SetClipboardTextFn = [](void* self, const char* text) {
      auto& panels = *static_cast<ImGuiPanels*>(self);
      panels.clipboard_ = text;
      if (panels.viewer_) panels.viewer_->host.SetClipboard(text);
    };
    io.GetClipboardTextFn = [](void* self) { return static_cast<ImGuiPanels*>(self)->clipboard_.c_str(); };
    NameKeys(io);
    for (const PanelKind& kind : panel_kinds)
      for (const PanelPart* part : kind.parts) parts_of_[&kind].push_back(part->make());
  }
  ~ImGuiPanels() override { ImGui::DestroyContext(context_); }
  ImGuiPanels(const ImGuiPanels&) = delete;

  bool Take(const Event& event, ViewerState& viewer) override {
    Use();
    // What came up since the last frame is to be there; a field that gets the keyboard reports it in the third.
    if (std::exchange(has_new_parts_, false))
      for (int i = 0; i < 3; ++i) MakeFrame(viewer);
    return std::visit([&](const auto& e) { return On(e, viewer); }, event);
  }

  void SetParts(const PanelParts& parts) override {
    if ((parts_.column && !parts.column) || (parts_.help && !parts.help)) LetGo();
    if (parts.help && !parts_.help) {
      help_.Open();
      ignores_text_ = true;
    }
    parts_ = parts;
    has_new_parts_ = true;
  }

  std::shared_ptr<const PanelDrawing> Draw(ViewerState& viewer, const std::vector<Label>& labels) override {
    Use();
    labels_ = labels;
    MakeFrame(viewer);
    // Again: what an event has changed may need another frame to find its size.
    if (parts_.column || parts_.help) MakeFrame(viewer);
    labels_.clear();
    return AsDrawing(*ImGui::GetDrawData(), sheet_);
  }

  std::string Text(ViewerState& viewer) override {
    Use();
    MakeFrame(viewer);
    wants_text_ = true;
    MakeFrame(viewer);
    wants_text_ = false;
    return text_;
  }

  double Width(double all) const override {
    const double widest = std::floor(widest_share * all);
    const double usual = std::min(Pixels(column_width), std::floor(column_share * all));
    return look_.width > 0 ? std::clamp(Pixels(look_.width), std::min(Pixels(narrowest), widest), widest) : usual;
  }

  double HeightOfBar() const override { return std::floor(letter_height * Scale() + 0.5) + 2 * Pixels(bar_padding); }

  LetterSize Letters() override {
    Use();
    Dress();
    return LettersOfLabels(Scale());
  }

  bool Reveal(ViewerState& viewer, const std::string& name) override {
    Use();
    const auto is_there = [&] {
      return std::ranges::any_of(items_, [&](const PanelItem& item) { return item.name.starts_with(name); });
    };
    MakeFrame(viewer);
    // What is outside of a list that is scrolled is not drawn at all.
    for (scroll_ = 0; !is_there() && scroll_ <= farthest_scroll_; scroll_ = *scroll_ + ImGui::GetIO().DisplaySize.y / 2)
      for (int i = 0; i < 2; ++i) MakeFrame(viewer);
    scroll_.reset();
    sought_ = name;
    MakeFrame(viewer);
    sought_.clear();
    MakeFrame(viewer);  // where it is then
    return is_there();
  }
  const std::vector<PanelItem>& Items() const override { return items_; }
  void SetLook(const PanelSettings& look) override {
    if (look == look_) return;
    look_ = look;
    look_.letters = std::clamp(look.letters, smallest_letters, largest_letters);
    Undress();
  }
  const PanelSettings& Look() const override { return look_; }
  void SetScale(double scale) override {
    if (scale == screen_) return;
    screen_ = scale;
    Undress();
  }

 private:
  enum class Holder { nobody, panels, viewer };

  void LetGo() {
    Use();
    ImGuiIO& io = ImGui::GetIO();
    for (const Key key : std::exchange(keys_down_, {})) PutKey(key, false);
    std::ranges::fill(io.MouseDown, false);
    io.MousePos = {nowhere, nowhere};
    ImGui::ClearActiveID();
    holder_ = Holder::nobody;
  }

  void Use() const { ImGui::SetCurrentContext(context_); }

  double Pixels(double units) const { return std::floor(units * Scale()); }
  double Scale() const { return screen_ * look_.letters; }
  void Dress() {
    if (!sheet_) sheet_ = UseLetters(Scale());
    if (!std::exchange(is_dressed_, true)) UseLook(look_.theme, Scale());
  }
  void Undress() {
    sheet_.reset();
    is_dressed_ = false;
  }

#if IMGUI_VERSION_NUM >= 18900
  // Keys are events of their own from 1.87 on, as modifiers are from 1.89 on; the arrays are gone since 1.91.5.
  static void NameKeys(ImGuiIO& io) { io.ConfigInputTrickleEventQueue = false; }  // a frame takes all that came
  static void PutKey(Key key, bool is_down) {
    for (const auto& [theirs, ours] : key_names)
      if (ours == key) ImGui::GetIO().AddKeyEvent(theirs, is_down);
  }
  static void PutModifiers(const Modifiers& modifiers) {
    ImGui::GetIO().AddKeyEvent(ImGuiMod_Ctrl, modifiers.control);
    ImGui::GetIO().AddKeyEvent(ImGuiMod_Shift, modifiers.shift);
  }
#else
  static void NameKeys(ImGuiIO& io) {
    for (const auto& [theirs, ours] : key_names) io.KeyMap[theirs] = static_cast<int>(ours);
  }
  static void PutKey(Key key, bool is_down) {
    const auto index = static_cast<std::size_t>(key);
    if (auto& down = ImGui::GetIO().KeysDown; index < std::size(down)) down[index] = is_down;
  }
  static void PutModifiers(const Modifiers& modifiers) {
    ImGui::GetIO().KeyCtrl = modifiers.control;
    ImGui::GetIO().KeyShift = modifiers.shift;
  }
#endif

  /// Returns true if text is being entered. Dear ImGui reports its end one frame late.
  bool TakesText(ViewerState& viewer) {
    if (ImGui::GetIO().WantTextInput) MakeFrame(viewer);
    return ImGui::GetIO().WantTextInput;
  }

  bool On(const KeyEvent& event, ViewerState& viewer) {
    const Key key = event.key;
    ignores_text_ = false;
    if (key == Key::tab || (key == Key::escape && parts_.help)) return false;
    if (event.is_pressed ? !TakesText(viewer) : !keys_down_.contains(key)) return false;
    if (event.is_pressed && keys_down_.contains(key)) {  // it is held, and counts again
      PutKey(key, false);
      MakeFrame(viewer);
    }
    if (event.is_pressed)
      keys_down_.insert(key);
    else
      keys_down_.erase(key);
    PutKey(key, event.is_pressed);
    PutModifiers(event.modifiers);
    if (event.is_pressed && key == Key::space) ImGui::GetIO().AddInputCharacter(' ');
    MakeFrame(viewer);
    PutModifiers({});  // their release is not reported
    return true;
  }

  bool On(const TextEvent& event, ViewerState& viewer) {
    ImGuiIO& io = ImGui::GetIO();
    if (ignores_text_ || !TakesText(viewer)) return false;
    io.AddInputCharactersUTF8(event.text.c_str());
    MakeFrame(viewer);
    return true;
  }

  bool On(const ButtonEvent& event, ViewerState& viewer) {
    ImGuiIO& io = ImGui::GetIO();
    const auto button = static_cast<std::size_t>(event.button == Button::left    ? ImGuiMouseButton_Left
                                                 : event.button == Button::right ? ImGuiMouseButton_Right
                                                                                 : ImGuiMouseButton_Middle);
    if (event.is_pressed) {
      if (holder_ == Holder::viewer) return false;
      MakeFrame(viewer);                // of the current positions
      Point(event.x, event.y, viewer);  // the item below it takes the press
      if (holder_ == Holder::nobody) holder_ = io.WantCaptureMouse ? Holder::panels : Holder::viewer;
    }
    if (holder_ == Holder::viewer) {
      // A click into the image ends any text entry, and leaves nothing below the pointer.
      if (event.is_pressed) ImGui::ClearActiveID();
      if (!event.is_pressed) holder_ = Holder::nobody;
      io.MousePos = {nowhere, nowhere};
      MakeFrame(viewer);
      return false;
    }
    io.MouseDown[button] = event.is_pressed;
    Point(event.x, event.y, viewer);
    if (std::none_of(std::begin(io.MouseDown), std::end(io.MouseDown), [](bool is_down) { return is_down; }))
      holder_ = Holder::nobody;
    return true;
  }

  bool On(const MoveEvent& event, ViewerState& viewer) {
    if (holder_ == Holder::viewer) return false;
    Point(event.x, event.y, viewer);
    return holder_ == Holder::panels || ImGui::GetIO().WantCaptureMouse;
  }

  bool On(const ScrollEvent& event, ViewerState& viewer) {
    if (holder_ == Holder::viewer) return false;
    Point(event.x, event.y, viewer);
    if (!ImGui::GetIO().WantCaptureMouse) return false;
    ImGui::GetIO().MouseWheel = static_cast<float>(event.steps);
    MakeFrame(viewer);
    return true;
  }

  bool On(const TickEvent& event, ViewerState&) {
    passed_ += static_cast<float>(event.seconds);
    return false;
  }
  template <typename Other>
  bool On(const Other&, ViewerState&) {
    return false;
  }

  void Point(double x, double y, ViewerState& viewer) {
    ImGui::GetIO().MousePos = {static_cast<float>(std::floor(x)),
                               static_cast<float>(std::floor(viewer.screen.size.height - y))};
    MakeFrame(viewer);
  }

  void MakeFrame(ViewerState& viewer) {
    viewer_ = &viewer;
    Dress();
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(viewer.screen.size.width), static_cast<float>(viewer.screen.size.height)};
    io.DeltaTime = std::max(shortest_time, std::exchange(passed_, 0.0F));
    items_.clear();
    ImGui::NewFrame();
    PanelFrame frame(viewer, Scale(), items_, sought_);
    DrawLabels(labels_, Scale(), look_.theme);
    text_.clear();
    if (parts_.column) DrawColumn(frame);
    if (parts_.bar) DrawBar(frame);
    if (parts_.help) DrawHelp(frame);
    ImGui::Render();
    for (const auto& action : frame.Asked()) action(viewer);
  }

  /// Draws it at the right, as high as the drawing.
  void DrawColumn(PanelFrame& frame) {
    const ImVec2 all = ImGui::GetIO().DisplaySize;
    const auto widest = static_cast<float>(std::floor(widest_share * static_cast<double>(all.x)));
    const float least = std::min(static_cast<float>(Pixels(narrowest)), widest);
    const auto width = static_cast<float>(Width(frame.viewer.screen.size.width));
    ImGui::SetNextWindowPos({all.x, 0}, ImGuiCond_Always, {1, 0});
    ImGui::SetNextWindowSize({width, all.y}, ImGuiCond_Always);
    ImGui::SetNextWindowSizeConstraints({least, all.y}, {widest, all.y});
    ImGui::Begin("column", nullptr, fixed_window | ImGuiWindowFlags_NoFocusOnAppearing);
    // Its edge was dragged; what a small window leaves no room for is no choice of the user's.
    if (holder_ == Holder::panels && ImGui::GetWindowWidth() != width) look_.width = ImGui::GetWindowWidth() / Scale();
    if (scroll_) ImGui::SetScrollY(*scroll_);
    farthest_scroll_ = ImGui::GetScrollMaxY();
    BeginText();
    for (const PanelKind& kind : panel_kinds) {
      const auto& parts = parts_of_[&kind];
      if (std::ranges::none_of(parts, [&](const auto& part) { return part->IsOfUse(frame.viewer); })) continue;
      if (!frame.Heading(kind.title, kind.is_open_at_first)) continue;
      for (std::size_t i = 0; i < parts.size(); ++i) {
        ImGui::PushID(kind.parts[i]->caption);
        if (i > 0) ImGui::Separator();
        if (parts.size() > 1) ImGui::TextUnformatted(kind.parts[i]->caption);
        parts[i]->Draw(frame);
        ImGui::PopID();
      }
    }
    EndText();
    ImGui::End();
  }

  /// Draws it at the bottom, as wide as the view. Over the view it lets the image and clicks through.
  void DrawBar(PanelFrame& frame) {
    constexpr float opacity_over_view = 0.6F;
    const double column = parts_.column ? Width(frame.viewer.screen.size.width) : 0;
    const float wide = ImGui::GetIO().DisplaySize.x - static_cast<float>(column);
    const auto high = static_cast<float>(HeightOfBar());
    ImGui::SetNextWindowPos({0, ImGui::GetIO().DisplaySize.y - high}, ImGuiCond_Always);
    ImGui::SetNextWindowSize({wide, high}, ImGuiCond_Always);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                        {2 * static_cast<float>(Pixels(bar_padding)), static_cast<float>(Pixels(bar_padding))});
    if (!parts_.column) ImGui::SetNextWindowBgAlpha(opacity_over_view);
    ImGui::Begin("bar", nullptr,
                 fixed_window | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoScrollbar |
                     ImGuiWindowFlags_NoFocusOnAppearing | (parts_.column ? 0 : ImGuiWindowFlags_NoInputs));
    BeginText();
    DrawStatusBar(frame);
    EndText();
    ImGui::End();
    ImGui::PopStyleVar(2);
  }

  /// Draws it in the middle of the view.
  void DrawHelp(PanelFrame& frame) {
    const ImVec2 all = ImGui::GetIO().DisplaySize;
    const float left = parts_.column ? all.x - static_cast<float>(Width(frame.viewer.screen.size.width)) : all.x;
    const auto line = static_cast<float>(LettersOfLabels(Scale()).height);
    const float bar = parts_.bar ? static_cast<float>(HeightOfBar()) : 0, top = line;
    const float wide = std::min(static_cast<float>(help_share) * left, static_cast<float>(Pixels(help_wide)));
    ImGui::SetNextWindowPos({std::floor((left - wide) / 2), std::floor(top)}, ImGuiCond_Always);
    // Below it a message has room.
    ImGui::SetNextWindowSize({std::floor(wide), std::max(line, std::floor(all.y - 2 * line - top - bar))},
                             ImGuiCond_Always);
    ImGui::Begin("help", nullptr, fixed_window | ImGuiWindowFlags_NoResize);
    BeginText();
    help_.Draw(frame);
    EndText();
    ImGui::End();
  }

  /// Adds text drawn until EndText to text_, if it is wanted.
  void BeginText() const {
    if (wants_text_) ImGui::LogToBuffer(0);
  }
  void EndText() {
    if (!wants_text_) return;
    text_ += context_->LogBuffer.c_str();
    ImGui::LogFinish();
  }

  ImGuiContext* const context_;
  std::map<const PanelKind*, std::vector<std::unique_ptr<Panel>>> parts_of_;
  HelpSheet help_;
  PanelParts parts_;
  std::vector<Label> labels_;              // of the frame that is made
  std::shared_ptr<const InkSheet> sheet_;  // null when the letters are to be made
  PanelSettings look_;
  double screen_ = 1;  // pixels per unit of length
  bool is_dressed_ = false, wants_text_ = false, has_new_parts_ = false;
  bool ignores_text_ = false;    // that of the key which opened the help
  std::optional<float> scroll_;  // of the column, where that is set
  float farthest_scroll_ = 0;
  float passed_ = 0;                // seconds since the last frame
  std::set<Key> keys_down_;         // of those that panels have got
  Holder holder_ = Holder::nobody;  // who got the press of the buttons that are down
  ViewerState* viewer_ = nullptr;   // of the last frame
  std::vector<PanelItem> items_;
  std::string text_, clipboard_, sought_;
};

}  // namespace

std::unique_ptr<Panels> MakePanels() { return std::make_unique<ImGuiPanels>(); }

}  // namespace ray
