#include "source/view/gl/Drawer.h"

namespace ray {
namespace {

constexpr double hidden_lines = 0.3;  // of their cover is left where things are before them
constexpr R2::Color section_ground{0.08, 0.08, 0.1};
constexpr double section_margin = 1.05;

Painter::PictureLook LookOf(const FrameState::Picture& picture) {
  Painter::PictureLook look;
  look.exposure = picture.exposure.factor;
  look.srgb = picture.exposure.srgb;
  look.rows = picture.rows;
  return look;
}

/// The square from -1 to 1 in the middle of a part, as large as it can be.
ClipMatrix SectionMatrix(const DrawingSize& part) {
  const double aspect = static_cast<double>(part.width) / part.height;
  ClipMatrix m{};
  m[0] = (aspect > 1 ? 1 / aspect : 1) / section_margin;
  m[5] = (aspect > 1 ? 1 : aspect) / section_margin;
  m[10] = m[15] = 1;
  return m;
}

}  // namespace

template <typename List, typename GpuCache>
const GpuCache& Drawer::Keep(Slot<List, GpuCache>& slot, const std::shared_ptr<const List>& list) {
  if (slot.list != list) {
    slot.kept.reset();  // first, so that both are never there at once
    slot.kept = painter_.Keep(*list);
    slot.list = list;
  }
  return *slot.kept;
}

void Drawer::Fit(PictureSlot& slot, int width, int height) {
  if (slot.kept && slot.width == width && slot.height == height) return;
  slot.kept.reset();
  slot.kept = painter_.KeepPicture(width, height);
  slot.width = width;
  slot.height = height;
}

const GpuPicture& Drawer::Keep(PictureSlot& slot, const FrameState::Picture& picture) {
  if (picture.image) {
    const R2::Image& image = *picture.image;
    if (slot.image != picture.image) {
      Fit(slot, image.Width(), image.Height());
      painter_.Update(*slot.kept, 0, image.Height(), image.Channels());
      slot.image = picture.image;
      slot.number = 0;
    }
    return *slot.kept;
  }
  const Frame& frame = *picture.frame;
  if (slot.number != picture.number || slot.image) {
    slot.kept.reset();  // a new one is black
    Fit(slot, frame.Width(), frame.Height());
    slot.versions.assign(static_cast<std::size_t>(frame.Height()), 0);
    slot.image.reset();
    slot.number = picture.number;
  }
  // Runs of rows that were written since the last time.
  const int end = picture.rows < 0 ? frame.Height() : picture.rows;
  for (int row = 0; row < end;) {
    const int first = row;
    while (row < end && frame.Version(row) != slot.versions[static_cast<std::size_t>(row)]) {
      slot.versions[static_cast<std::size_t>(row)] = frame.Version(row);
      ++row;
    }
    if (row == first) {
      ++row;
      continue;
    }
    rows_.clear();
    frame.Copy(first, row - first, rows_);
    painter_.Update(*slot.kept, first, row - first, rows_);
  }
  return *slot.kept;
}

void Drawer::Draw(const FrameState& shown) {
  painter_.Begin(shown.size.width, shown.size.height, shown.background);
  painter_.SetPart(0, 0, shown.view.width, shown.view.height);
  const ClipMatrix& clip = shown.clip_from_drawing;
  const bool is_covered = shown.picture.has_value();
  if (is_covered) painter_.Draw(Keep(picture_, *shown.picture), LookOf(*shown.picture));
  if (shown.shows_faces && !is_covered) painter_.Draw(Keep(faces_, shown.faces), clip);
  if (shown.shows_edges) painter_.DrawEdges(Keep(faces_, shown.faces), clip, shown.edge_color);
  if (shown.quad && !is_covered)
    painter_.Draw(Keep(quad_, *shown.quad), *shown.quad->corners, clip, LookOf(*shown.quad));
  painter_.Draw(Keep(lines_, shown.lines), clip, 1, hidden_lines);
  if (shown.section) {
    const DrawingSize part{shown.size.width - shown.view.width, shown.size.height};
    painter_.SetPart(shown.view.width, 0, part.width, part.height);
    painter_.Fill(section_ground);
    painter_.Draw(Keep(section_, shown.section), SectionMatrix(part), 1, 1);
  }
  painter_.SetPart(0, 0, shown.size.width, shown.size.height);
  painter_.Draw(shown.labels);
}

std::vector<float> Drawer::ReadBackQuad() { return quad_.kept ? painter_.ReadBack(*quad_.kept) : std::vector<float>{}; }

}  // namespace ray
