#include <gtest/gtest.h>

#include <string>

#include "source/view/HelpText.h"
#include "tests/source/view/Contrast.h"
#include "tests/source/view/ScriptedViewer.h"
#include "tests/source/view/WithOptions.h"

namespace ray {
namespace {

/// What a user of a small, a usual and a dense large window looks at, step by step.
class Layout : public ScriptedViewer<WithOptions, 512, 512> {
 protected:
  static constexpr const char* sizes[] = {"512 512", "1280 800", "3840 2160 2"};
  static constexpr const char* modes[] = {
      "",
      "key H",
      "key Escape",
      "click left 150 260",
      "key Escape\nclick right 150 260",
      "key G",
      "key B",
      "key T",
      "key C",
      "key X",
      "move 400 300",
      "key Shift+X",
      "key Shift+X",
      "key Shift+X",
      "key H",
      "key Escape",
      "key X\nkey P",
      "key F7",
      "key F12",
      "key F12",
      "drop /no/such/folder/that/has/a/rather/long/name/and/another/one/below/it/of/a/scene/that/is/not/there.scn",
  };

  template <typename Check>
  void InEveryMode(const Check& check) {
    for (const char* size : sizes)
      for (const bool has_panels : {false, true}) {
        Open(project::Root() / "scenes/hello.scn");
        Do(std::string("resize ") + size);
        if (has_panels) viewer_->ShowPanels({});
        for (const char* mode : modes) {
          Do(mode);
          SCOPED_TRACE(std::string(size) + (has_panels ? " with panels: " : ": ") + mode);
          check(viewer_->Show());
        }
        Do("key P\nkey S\nkey I");
        SCOPED_TRACE(std::string(size) + (has_panels ? " with panels, flat" : ", flat"));
        check(viewer_->Show());
      }
  }
};

/// The size of letters on a screen of that density.
LetterSize LettersAt(double scale) {
  const auto panels = MakePanels();
  panels->SetScale(scale);
  return panels->Letters();
}

/// Where a label is drawn, in pixels.
PixelBox BoxOf(const Label& label, const LetterSize& letters) {
  return {label.x, label.y, static_cast<double>(CountLetters(label.text)) * letters.width, letters.height};
}

void ExpectWithin(const FrameState& shown, const LetterSize& letters) {
  for (const Label& label : shown.labels) {
    const PixelBox box = BoxOf(label, letters);
    const double bottom = box.bottom - shown.bottom;
    EXPECT_TRUE(box.left >= 0 && bottom >= 0 && bottom + box.height <= shown.view.height) << label.text;
    EXPECT_LE(box.left + box.width, shown.view.width + shown.section_size.width) << label.text;
  }
}

void ExpectApart(const FrameState& shown, const LetterSize& letters) {
  for (std::size_t i = 0; i < shown.labels.size(); ++i)
    for (std::size_t k = i + 1; k < shown.labels.size(); ++k) {
      const PixelBox a = BoxOf(shown.labels[i], letters), b = BoxOf(shown.labels[k], letters);
      const bool are_apart = a.left + a.width <= b.left || b.left + b.width <= a.left ||
                             a.bottom + a.height <= b.bottom || b.bottom + b.height <= a.bottom;
      EXPECT_TRUE(are_apart) << shown.labels[i].text << "\n" << shown.labels[k].text;
    }
}

void ExpectRead(const FrameState& shown) {
  for (const Label& label : shown.labels)
    for (const contrast::Color& behind : {contrast::Color{0, 0, 0}, contrast::Color{1, 1, 1}}) {
      const auto ground = contrast::Over({0, 0, 0}, Label::ground_alpha / 255.0, behind);
      EXPECT_GE(contrast::Between(contrast::AsColor(label.color), ground), contrast::of_text) << label.text;
    }
}

TEST_F(Layout, TextIsReadableAndOverlapsNeitherPanelsNorText) {
  InEveryMode([](const FrameState& shown) {
    const LetterSize letters = LettersAt(shown.line_width);  // lines are as wide as the screen is dense
    ExpectWithin(shown, letters);
    ExpectApart(shown, letters);
    ExpectRead(shown);
  });
}

TEST_F(Layout, ALongMessageGoesOnInTheNextLine) {
  Do("drop /a/folder/whose/name/is/long/and/another/one/with/a/name/as/long/as/that/missing.scn");
  std::string message;
  for (const Label& label : viewer_->Show().labels) message += label.text;
  EXPECT_GT(viewer_->Show().labels.size(), 1u);
  EXPECT_NE(message.find("missing.scn"), std::string::npos) << message;
}

}  // namespace
}  // namespace ray
