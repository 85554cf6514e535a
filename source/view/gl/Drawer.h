#pragma once

#include <map>

#include "source/view/Presentation.h"
#include "source/view/gl/Painter.h"

namespace ray {

/// Draws presentations, and keeps with OpenGL what does not change from one to the next.
class Drawer {
 public:
  explicit Drawer(Painter& painter) : painter_(painter) {}

  void Draw(const Presentation& shown);
  /// The picture of a job or an image as it was last drawn, for tests: rows from the bottom, r g b.
  std::vector<float> ReadBackQuad();

 private:
  /// A list that was shown, and what became of it.
  template <typename List, typename Kept>
  struct Slot {
    std::shared_ptr<const List> list;
    std::shared_ptr<Kept> kept;
  };
  template <typename List, typename Kept>
  const Kept& Keep(Slot<List, Kept>& slot, const std::shared_ptr<const List>& list);

  /// A picture, and which rows of which frame it has.
  struct PictureSlot {
    std::uint64_t number = 0;
    std::shared_ptr<const R2::Image> image;
    int width = 0, height = 0;
    std::vector<std::uint32_t> versions;
    std::shared_ptr<KeptPicture> kept;
  };
  const KeptPicture& Keep(PictureSlot& slot, const Presentation::Picture& picture);
  void Fit(PictureSlot& slot, int width, int height);

  Painter& painter_;
  Slot<Triangles, KeptTriangles> faces_;
  Slot<Lines, KeptLines> lines_, section_;
  PictureSlot quad_, picture_;
  std::vector<float> rows_;
};

}  // namespace ray
