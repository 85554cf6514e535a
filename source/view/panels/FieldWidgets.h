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

  /// All fields of the statement; changes are requests to the viewer's editor.
  void Draw(PanelFrame& frame, std::uint32_t statement);

  /// One number; `set` gets the new value, and whether it continues the change of the same slider.
  static void DrawNumber(PanelFrame& frame, const std::string& name, double value, const Range& range,
                         const std::function<void(double, bool)>& set);

 private:
  void DrawField(PanelFrame& frame, std::uint32_t statement, const ScnField& field);
  void DrawPicker(PanelFrame& frame, std::uint32_t statement, const ScnField& field);

  std::string picked_;  // the field whose picker is open; empty for none
};

/// A swatch; returns true if it was clicked.
bool DrawSwatch(PanelFrame& frame, const std::string& name, const std::vector<double>& color);

}  // namespace ray
