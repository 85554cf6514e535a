#include "source/view/gl/Painter.h"

#include "source/view/gl/Canvas.h"
#include "source/view/gl/ListDrawer.h"
#include "source/view/gl/PictureDrawer.h"
#include "source/view/gl/TextDrawer.h"

namespace ray {

struct Painter::Parts {
  explicit Parts(Target target) : canvas(target) {}

  Canvas canvas;
  ListDrawer lists;
  PictureDrawer pictures;
  TextDrawer text;
};

Painter::Painter(Target target) : parts_(std::make_unique<Parts>(target)) {}

Painter::~Painter() = default;

std::shared_ptr<GpuTriangles> Painter::Keep(const Triangles& triangles) { return parts_->lists.Keep(triangles); }

std::shared_ptr<GpuLines> Painter::Keep(const Lines& lines) { return parts_->lists.Keep(lines); }

std::shared_ptr<GpuPicture> Painter::KeepPicture(int width, int height) { return parts_->pictures.Keep(width, height); }

void Painter::Update(GpuPicture& picture, int first, int count, std::span<const float> rgb) {
  parts_->pictures.Update(picture, first, count, rgb);
}

std::vector<float> Painter::ReadBack(const GpuPicture& picture) { return parts_->pictures.ReadBack(picture); }

void Painter::Begin(int width, int height, const R2::Color& background) {
  parts_->canvas.Begin(width, height, background);
}

void Painter::SetPart(int x, int y, int width, int height) { parts_->canvas.SetPart(x, y, width, height); }

void Painter::Fill(const R2::Color& color) { parts_->canvas.Fill(color); }

void Painter::Draw(const GpuTriangles& triangles, const ClipMatrix& clip_from_drawing) {
  parts_->lists.Draw(triangles, clip_from_drawing);
}

void Painter::Draw(const GpuLines& lines, const ClipMatrix& clip_from_drawing, double width, double hidden) {
  parts_->lists.Draw(lines, clip_from_drawing, width, hidden);
}

void Painter::DrawEdges(const GpuTriangles& triangles, const ClipMatrix& clip_from_drawing, const Rgba& color) {
  parts_->lists.DrawEdges(triangles, clip_from_drawing, color);
}

void Painter::Draw(const GpuPicture& picture, const std::array<std::array<float, 3>, 4>& corners,
                   const ClipMatrix& clip_from_drawing, const PictureLook& look) {
  parts_->pictures.Draw(picture, corners, clip_from_drawing, look);
}

void Painter::Draw(const GpuPicture& picture, const PictureLook& look) { parts_->pictures.Draw(picture, look); }

void Painter::Draw(std::span<const Label> labels) {
  parts_->canvas.LeavePart();
  parts_->text.Draw(labels, parts_->canvas.Width(), parts_->canvas.Height());
  parts_->canvas.ReturnToPart();
}

void Painter::Finish() { glFinish(); }

R2::Image Painter::Read() { return parts_->canvas.Read(); }

}  // namespace ray
