#pragma once

#include <functional>
#include <string>

#include "source/view/edit/ScnField.h"
#include "source/view/panels/Panel.h"

namespace ray {

/// The numbers of a scene's statement as widgets: a field for text, before it a swatch of a color, and below it a
/// picker or a slider.
class FieldWidgets {
 public:
  /// A slider's ends; along a logarithm where both are above 0.
  struct Range {
    double least = 0, most = 1;
  };

  /// All fields of the statement; what is changed is asked of the viewer's editor.
  void Draw(PanelFrame& frame, std::uint32_t statement);

  /// One number by itself; `set` gets what it is to be, and whether that extends what the slider did before.
  static void DrawNumber(PanelFrame& frame, const std::string& name, double value, const Range& range,
                         const std::function<void(double, bool)>& set);

 private:
  void DrawField(PanelFrame& frame, std::uint32_t statement, const ScnField& field);
  void DrawPicker(PanelFrame& frame, std::uint32_t statement, const ScnField& field);

  std::string picked_;  // the field whose picker is open; empty for none
};

/// A swatch; whether it was clicked.
bool DrawSwatch(PanelFrame& frame, const std::string& name, const std::vector<double>& color);

}  // namespace ray
