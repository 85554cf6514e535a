#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "source/draw/FrameState.h"
#include "source/draw/gl/Painter.h"

namespace ray {

/// Draws FrameStates. Data that is unchanged from one to the next stays on the GPU.
class Drawer {
 public:
  explicit Drawer(Painter& painter) : painter_(painter) {}

  void Draw(const FrameState& state);

 private:
  /// A list of vertices and its buffer on the GPU.
  template <typename List, typename GpuList>
  struct Slot {
    std::shared_ptr<const List> list;
    std::shared_ptr<GpuList> uploaded;
  };
  template <typename List, typename GpuList, typename Uploader>
  GpuList& Upload(Slot<List, GpuList>& slot, const std::shared_ptr<const List>& list, const Uploader& uploader);
  const GpuLines& Upload(Slot<Lines, GpuLines>& slot, const std::shared_ptr<const Lines>& lines) {
    return Upload(slot, lines, painter_.lists);
  }

  /// A texture for an image, and the rows of a frame that it contains.
  struct ImageSlot {
    std::uint64_t number = 0;
    std::shared_ptr<const R2::Image> image;
    std::vector<std::uint32_t> versions;
    std::shared_ptr<GpuImage> uploaded;
  };
  const GpuImage& Upload(ImageSlot& slot, const FrameState::ShownImage& image);
  void UploadFrame(ImageSlot& slot, const Frame& frame, std::uint64_t number, int rows);
  void UploadImage(ImageSlot& slot, const std::shared_ptr<const R2::Image>& image);
  void UploadNewRows(ImageSlot& slot, const Frame& frame, int end);
  /// Draws the surfaces and the background.
  void DrawScene(const FrameState& state);
  /// Draws the image that covers the view, up to its slider, and the other side of the slider.
  void DrawImage(const FrameState& state);
  void Fit(ImageSlot& slot, int width, int height);

  Painter& painter_;
  Slot<PreviewScene, GpuSurfaces> faces_;
  Slot<Lines, GpuLines> lines_, marks_, lit_, crop_, section_;
  ImageSlot quad_, covering_, beside_, depths_;
  std::vector<float> rows_;
};

}  // namespace ray
