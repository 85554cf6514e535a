#include <imgui.h>

#include <filesystem>

#include "source/view/commands/Commands.h"
#include "source/view/edit/SceneFiles.h"
#include "source/view/panels/Panel.h"

// The scenes that can be opened: those of the folder, and those that were opened before.
namespace ray {
namespace {

class OpenPanel : public Panel {
 public:
  bool IsOfUse(const ViewerState& viewer) const override { return viewer.shows.scenes; }

  void Draw(PanelFrame& frame) override {
    const ViewerState& viewer = frame.viewer;
    if (scene_number_ != viewer.scene.Number()) {
      scene_number_ = viewer.scene.Number();
      scenes_ = ScenesBeside(viewer.settings.scene);
      recent_ = viewer.host.RecentScenes();
    }
    frame.Say("Page Up and Page Down go through this folder");
    for (const std::string& file : scenes_) Offer(frame, file, std::filesystem::path(file).filename().string());
    if (scenes_.empty()) frame.Say("there is no scene in this folder");
    if (recent_.empty()) return;
    ImGui::Separator();
    frame.Say("opened before");
    for (const std::string& file : recent_) Offer(frame, file, file);
  }

 private:
  static void Offer(PanelFrame& frame, const std::string& file, const std::string& name) {
    ImGui::PushID(file.c_str());
    if (frame.Choice(name, file == frame.viewer.settings.scene))
      frame.Ask([file](ViewerState& v) { OpenScene(v, file); });
    ImGui::PopID();
  }

  int scene_number_ = 0;  // that the lists are for
  std::vector<std::string> scenes_, recent_;
};

}  // namespace

extern const PanelPart open_part{"open", [] { return std::unique_ptr<Panel>(new OpenPanel); }};

}  // namespace ray
