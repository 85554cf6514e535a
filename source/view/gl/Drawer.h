#pragma once

#include <map>

#include "source/view/FrameState.h"
#include "source/view/gl/Painter.h"

namespace ray {

/// Draws presentations, and keeps with OpenGL what does not change from one to the next.
class Drawer {
 public:
  explicit Drawer(Painter& painter) : painter_(painter) {}

  void Draw(const FrameState& shown);
  /// The picture of a job or an image as it was last drawn, for tests: rows from the bottom, r g b.
  std::vector<float> ReadBackQuad();

 private:
  /// A list that was shown, and what became of it.
  template <typename List, typename GpuCache>
  struct Slot {
    std::shared_ptr<const List> list;
    std::shared_ptr<GpuCache> kept;
  };
  template <typename List, typename GpuCache>
  const GpuCache& Keep(Slot<List, GpuCache>& slot, const std::shared_ptr<const List>& list);

  /// A picture, and which rows of which frame it has.
  struct PictureSlot {
    std::uint64_t number = 0;
    std::shared_ptr<const R2::Image> image;
    int width = 0, height = 0;
    std::vector<std::uint32_t> versions;
    std::shared_ptr<GpuPicture> kept;
  };
  const GpuPicture& Keep(PictureSlot& slot, const FrameState::Picture& picture);
  void Fit(PictureSlot& slot, int width, int height);

  Painter& painter_;
  Slot<Triangles, GpuTriangles> faces_;
  Slot<Lines, GpuLines> lines_, section_;
  PictureSlot quad_, picture_;
  std::vector<float> rows_;
};

}  // namespace ray
