#pragma once

#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "source/view/Viewer.h"

namespace ray {

/// Keeps what a viewer asks for.
class Witness : public ViewerHost {
 public:
  std::string SaveTraced(const RenderJob& job) override {
    traced.push_back(job.Result()->image);
    traced_settings.push_back(job.Settings());
    return "saved";
  }
  void SaveDrawing() override { ++drawings; }
  std::string SaveRays(const std::string& obj) override {
    rays = obj;
    return "rays";
  }
  std::string SaveText(const std::string& file, const std::string& text) override {
    std::ofstream out(file);
    return out << text << std::flush ? "" : "cannot write " + file;
  }
  ReferenceImage ReadImage(const std::string& file) override { return file == "picture" ? picture : ReferenceImage(); }
  void SetClipboard(const std::string& text) override { clipboard = text; }
  void Print(const std::string& line) override { printed += line + "\n"; }

  std::vector<R2::Image> traced;
  std::vector<RenderSettings> traced_settings;
  int drawings = 0;
  std::string rays, clipboard, printed;
  ReferenceImage picture{std::make_shared<const R2::Image>(8, 8)};  // in the file of that name
};

}  // namespace ray
