#include "source/app/report/Messages.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include "tests/source/app/Program.h"

namespace ray::testing {
namespace {

TEST(Terminal, ColorsErrorsWarningsAndCarets) {
  EXPECT_EQ(Colored("a.scn:1:1: error: unknown command 'spere'\n    1 | spere\n      | ^~~~~ did you mean 'sphere'?"),
            "a.scn:1:1: \033[1;31merror:\033[0m unknown command 'spere'\n    1 | spere\n"
            "      | \033[1;32m^~~~~\033[0m did you mean 'sphere'?");
  EXPECT_EQ(Colored("raypro: warning: -focus has no effect"), "raypro: \033[1;33mwarning:\033[0m -focus has no effect");
  EXPECT_EQ(Colored("raypro: progress saved"), "raypro: progress saved");
  EXPECT_EQ(ColoredFailure("raypro: -width must be"), "\033[1;31mraypro:\033[0m -width must be");
}

/// Both ends of a pseudoterminal.
class PseudoTerminal {
 public:
  PseudoTerminal() : descriptor_(posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK)) {
    if (descriptor_ < 0 || grantpt(descriptor_) != 0 || unlockpt(descriptor_) != 0) return;
    name_ = ptsname(descriptor_);
    other_end_ = open(name_.c_str(), O_RDWR | O_NOCTTY);  // otherwise written text is lost with its writer
  }
  ~PseudoTerminal() {
    close(other_end_);
    close(descriptor_);
  }
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  bool IsOpen() const { return other_end_ >= 0; }
  const std::string& Name() const { return name_; }
  std::string Written() const {
    char text[4096];
    const ssize_t length = read(descriptor_, text, sizeof text);
    return {text, static_cast<std::size_t>(length < 0 ? 0 : length)};
  }

 private:
  int descriptor_ = -1, other_end_ = -1;
  std::string name_;
};

TEST(Terminal, GetsColorsUnlessItIsDumbOrTheyAreForbidden) {
  NEEDS_THE_PROGRAM();
  const PseudoTerminal terminal;
  if (!terminal.IsOpen()) GTEST_SKIP() << "this system gives no pseudo-terminal";
  const struct {
    std::map<std::string, std::string> environment;
    bool has_color;
  } cases[] = {{{{"TERM", "xterm"}, {"NO_COLOR", ""}}, true},
               {{{"TERM", "xterm"}, {"NO_COLOR", "1"}}, false},
               {{{"TERM", "dumb"}, {"NO_COLOR", ""}}, false},
               {{{"TERM", ""}, {"NO_COLOR", ""}}, false}};
  for (const auto& [environment, has_color] : cases) {
    RunProgram({"-spp"}, {.standard_error = terminal.Name(), .environment = environment});
    const std::string text = terminal.Written();
    EXPECT_TRUE(Has(text, "unknown option")) << text;
    EXPECT_EQ(Has(text, "\033["), has_color) << text;
  }
  const Finished piped = RunProgram({"-spp"}, {.environment = {{"TERM", "xterm"}, {"NO_COLOR", ""}}});
  EXPECT_TRUE(piped.error.starts_with("raypro: unknown option '-spp'")) << piped.error;
}

}  // namespace
}  // namespace ray::testing
