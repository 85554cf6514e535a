#include "source/app/options/CommandLine.h"
#include "source/app/options/RenderChecks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <iterator>
#include <random>
#include <set>
#include <sstream>

#include "source/app/Status.h"
#include "source/app/options/OptionTable.h"
#include "source/app/options/ViewerOptions.h"
#include "tests/source/app/Program.h"
#include "tests/source/app/options/ScenePrograms.h"

namespace ray {
namespace {

using testing::Has;

using Words = std::vector<std::string>;

RenderOptions Parsed(const Words& words) { return ReadCommandLine(Program::raypro, words); }

/// Returns the names that a program needs, followed by more words.
Words Beside(const Program& program, const Words& more) {
  Words words{"in.scn"};
  if (program == Program::raypro) words.emplace_back("out.ppm");
  return testing::With(words, more);
}
ViewerOptions ViewParsed(const Words& more) {
  return ReadCommandLine<ViewerOptions>(Program::rayview, Beside(Program::rayview, more));
}

/// Returns the message of the error, or "" if there is none.
std::string ErrorOf(const Words& words, const Program& program = Program::raypro) {
  return project::MessageOf<UsageError>([&] {
    auto options = ReadCommandLine(program, words);
    if (!options.files.scene.empty()) CompleteForScene(options);
  });
}

/// With the names that a render needs.
std::string ErrorBeside(const Words& words, const Program& program = Program::raypro) {
  return ErrorOf(Beside(program, words), program);
}

Words Split(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

template <class T>
const Number<T>* AsNumber(const OptionKind& option) {
  return std::get_if<Number<T>>(&option.value);
}

bool IsNumber(const OptionKind& option) {
  return AsNumber<int>(option) || AsNumber<std::int64_t>(option) || AsNumber<std::uint64_t>(option) ||
         AsNumber<double>(option) || std::holds_alternative<OneNumberOf>(option.value);
}

TEST(CommandLine, NoTwoOptionsShareANameOrAlias) {
  for (const Program& program : programs) {
    std::vector<std::string> names;
    for (const OptionKind& option : OptionTable(program)) {
      names.emplace_back(option.name);
      names.insert(names.end(), option.aliases.begin(), option.aliases.end());
    }
    std::ranges::sort(names);
    EXPECT_EQ(std::ranges::adjacent_find(names), names.end()) << *std::ranges::adjacent_find(names);
  }
}

// If the option refused its own default or read it as something else, the help would be wrong.
TEST(CommandLine, EveryOptionGivenItsDefaultChangesNothing) {
  for (const Program& program : scene_programs) {
    const auto defaults = program.defaults();
    for (const OptionKind& option : OptionTable(program)) {
      Words words = Split(defaults->Show(option));
      if (words.empty()) continue;
      words.insert(words.begin(), "-" + std::string(option.name));
      const auto options = ReadWords(program, Beside(program, words));
      for (const OptionKind& other : OptionTable(program))
        EXPECT_EQ(options->Show(other), defaults->Show(other)) << option.name;
    }
  }
}

TEST(CommandLine, EveryOptionTakesEachOfItsChoices) {
  for (const Program& program : scene_programs)
    for (const OptionKind& option : OptionTable(program)) {
      if (!IsSetting(option)) continue;
      for (const std::string& choice : Choices(option)) {
        Words words{"-" + std::string(option.name), choice};
        if (words[0] == "-context") words.emplace_back("-headless");
        EXPECT_EQ(ReadWords(program, Beside(program, words))->Show(option), choice);
      }
    }
}

TEST(CommandLine, DefaultsAreTheCoursesAndTheSpecifications) {
  const RenderOptions o = Parsed({"in.scn", "out.jpg"});
  EXPECT_EQ(o.files.scene, "in.scn");
  EXPECT_EQ(o.files.image, "out.jpg");
  EXPECT_FALSE(o.request);
  EXPECT_EQ(o.render.width, 256);
  EXPECT_EQ(o.render.height, 256);
  EXPECT_EQ(o.render.samples, 1);
  EXPECT_EQ(o.render.trace.max_depth, 3);
  EXPECT_EQ(o.render.trace.min_luminance, 0.01);
  EXPECT_EQ(o.render.trace.shadow_samples, 16);
  EXPECT_TRUE(o.render.trace.shadows);
  EXPECT_EQ(o.render.seed, 0u);
  EXPECT_EQ(o.render.threads, 0);
  EXPECT_EQ(o.render.tile_size, 32);
  EXPECT_EQ(o.accelerator.name, "auto");
  EXPECT_EQ(o.encoding.bits, 8);
  EXPECT_EQ(o.encoding.jpeg_quality, 95);
  EXPECT_EQ(o.parse.include_depth, 64);
}

TEST(CommandLine, OneDashTwoDashesAndEqualsMeanTheSame) {
  for (const Words& spelling : {Words{"-width", "512"}, {"--width", "512"}, {"-width=512"}, {"--width=512"}}) {
    Words words = spelling;
    words.insert(words.end(), {"in.scn", "out.ppm"});
    EXPECT_EQ(Parsed(words).render.width, 512) << spelling[0];
  }
}

TEST(CommandLine, OptionsMayComeBeforeBetweenAndAfterTheNames) {
  const RenderOptions o = Parsed({"-width", "5", "in.scn", "-srgb", "out.ppm", "-crop", "1", "2", "3", "4"});
  EXPECT_EQ(o.files.scene, "in.scn");
  EXPECT_EQ(o.files.image, "out.ppm");
  EXPECT_EQ(o.render.width, 5);
  EXPECT_TRUE(o.encoding.srgb);
  EXPECT_EQ(o.render.crop->x0, 1);
  EXPECT_EQ(o.render.crop->y1, 4);
}

TEST(CommandLine, AfterTwoDashesEverythingIsAName) {
  const RenderOptions o = Parsed({"--", "-in.scn", "-width.ppm"});
  EXPECT_EQ(o.files.scene, "-in.scn");
  EXPECT_EQ(o.files.image, "-width.ppm");
}

TEST(CommandLine, SilentAliasesSetTheSameValue) {
  EXPECT_EQ(Parsed({"a", "b", "-maxreflections", "7"}).render.trace.max_depth, 7);
  EXPECT_EQ(Parsed({"a", "b", "-max_reflections", "7"}).render.trace.max_depth, 7);
  EXPECT_EQ(Parsed({"a", "b", "-minluminance", "0.5"}).render.trace.min_luminance, 0.5);
  EXPECT_TRUE(Parsed({"a", "-dry-run"}).Asks("check"));
}

TEST(CommandLine, SrgbMakesTexturesAndImageLinear) {
  const RenderOptions o = Parsed({"a", "b", "-srgb"});
  EXPECT_TRUE(o.encoding.srgb);
  EXPECT_TRUE(o.parse.decode_srgb);
  EXPECT_FALSE(Parsed({"a", "b"}).parse.decode_srgb);
}

TEST(CommandLine, SeveralFoldersMayBeAllowed) {
  const RenderOptions o = Parsed({"a", "b", "-allow_path", "x", "-allow_path=y"});
  ASSERT_EQ(o.parse.allowed_folders.size(), 2u);
  EXPECT_EQ(o.parse.allowed_folders[1], "y");
}

TEST(CommandLine, SeedsUseAll64Bits) {
  EXPECT_EQ(Parsed({"a", "b", "-seed", "18446744073709551615"}).render.seed, 18446744073709551615u);
}

TEST(CommandLine, ALeadingPlusIsAllowed) { EXPECT_EQ(Parsed({"a", "b", "-width", "+5"}).render.width, 5); }

TEST(Extremes, K6_BadNumbersAreRefusedWithOptionValueAndRange) {
  for (const OptionKind& option : OptionTable(Program::raypro)) {
    if (!IsNumber(option)) continue;
    for (const char* word :
         {"12abc", "", "+", "+-1", "++1", "0x10", "1,5", "nan", "inf", "1e999", "1e99999999999", " 1", "1 "}) {
      const std::string error = ErrorBeside({"-" + std::string(option.name), word});
      EXPECT_TRUE(Has(error, "-" + std::string(option.name) + " must be " + Range(option))) << word << ": " << error;
      EXPECT_TRUE(Has(error, "'" + std::string(word) + "'")) << word << ": " << error;
    }
  }
}

TEST(Extremes, K6_NumbersDoNotDependOnTheLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  std::setlocale(LC_ALL, "de_DE.UTF-8");  // harmless if it is not installed
  EXPECT_EQ(Parsed({"a", "b", "-min_luminance", "0.5"}).render.trace.min_luminance, 0.5);
  EXPECT_NE(ErrorBeside({"-min_luminance", "0,5"}), "");
  std::setlocale(LC_ALL, before.c_str());
}

TEST(Extremes, K6_NumbersUnderflowToZeroButMayNotOverflow) {
  EXPECT_EQ(Parsed({"a", "b", "-min_luminance", "1e-999"}).render.trace.min_luminance, 0);
  EXPECT_EQ(Parsed({"a", "b", "-min_luminance", "1e-310"}).render.trace.min_luminance, 1e-310);
  EXPECT_NE(ErrorBeside({"-min_luminance", "1e999"}), "");
  EXPECT_NE(ErrorBeside({"-min_luminance", std::string(400, '9')}), "");
}

TEST(CommandLine, EveryWholeNumberTakesItsLimitsAndNothingBeyond) {
  for (const OptionKind& option : OptionTable(Program::raypro)) {
    const auto* number = AsNumber<int>(option);
    if (!number) continue;
    const auto is_stored = [&](std::int64_t value) {
      RenderOptions options;
      try {
        Store(option, Words{std::to_string(value)}, options);
      } catch (const UsageError&) {
        return false;
      }
      return number->member.read(options) == value;
    };
    EXPECT_TRUE(is_stored(number->low)) << option.name;
    EXPECT_TRUE(is_stored(number->high)) << option.name;
    EXPECT_FALSE(is_stored(std::int64_t{number->low} - 1)) << option.name;
    EXPECT_FALSE(is_stored(std::int64_t{number->high} + 1)) << option.name;
  }
}

TEST(Extremes, F6_MaxDepthIsAnyNumberFromZeroOn) {
  EXPECT_EQ(Parsed({"a", "b", "-max_depth", "0"}).render.trace.max_depth, 0);
  EXPECT_EQ(Parsed({"a", "b", "-max_depth", "1000000000"}).render.trace.max_depth, 1'000'000'000);
  EXPECT_TRUE(Has(ErrorBeside({"-max_depth", "-1"}), "-max_depth must be a whole number, 0 to"));
}

TEST(Extremes, F7_MinLuminanceIsAnyNumberFromZeroOn) {
  EXPECT_EQ(Parsed({"a", "b", "-min_luminance", "0"}).render.trace.min_luminance, 0);
  EXPECT_EQ(Parsed({"a", "b", "-min_luminance", "2"}).render.trace.min_luminance, 2);
  EXPECT_EQ(ErrorBeside({"-min_luminance", "-0.5"}), "-min_luminance must be a number, at least 0, got '-0.5'");
  EXPECT_NE(ErrorBeside({"-min_luminance", "nan"}), "");
}

TEST(Extremes, G5_SamplesAreAtLeastOneAndFitAnInteger) {
  EXPECT_NE(ErrorBeside({"-samples", "0"}), "");
  EXPECT_NE(ErrorBeside({"-samples", "2147483648"}), "");
  EXPECT_EQ(Parsed({"a", "b", "-samples", "2147483647"}).render.samples, 2147483647);
}

TEST(CommandLine, ARepeatedOptionTakesItsLastValue) {
  EXPECT_EQ(Parsed({"a", "b.ppm", "-samples", "4", "--samples=9"}).render.samples, 9);
  EXPECT_EQ(Parsed({"a", "b.ppm", "-max_depth", "4", "-maxreflections", "5"}).render.trace.max_depth, 5);
  EXPECT_EQ(ErrorBeside({"-srgb", "-srgb"}), "");
  EXPECT_EQ(Parsed({"a", "-debugpixel", "1", "2", "-debugpixel", "3", "4"}).pixel->x, 3);
  EXPECT_TRUE(Parsed({"a", "-check", "-check"}).Asks("check"));
}

TEST(CommandLine, AnotherProgramsOptionIsUnknownAndHasOneEquivalent) {
  for (const Program& program : scene_programs) {
    std::set<std::string> words;
    for (const OptionKind& option : OptionTable(program))
      for (const std::string word : option.facts.elsewhere) {
        EXPECT_FALSE(FindOption(program, word)) << word;
        EXPECT_TRUE(words.insert(word).second) << word;
      }
  }
}

TEST(CommandLine, OptionsExcludeOptionsThatExist) {
  for (const Program& program : programs)
    for (const OptionKind& option : OptionTable(program))
      for (const char* other : option.facts.excludes) EXPECT_TRUE(FindOption(program, other)) << other;
}

TEST(CommandLine, EverySettingOfARenderStatesItsEffects) {
  for (const Program& program : scene_programs)
    for (const OptionKind& option : OptionTable(program)) {
      const bool says = option.facts.HasAny({Fact::image, Fact::samples, Fact::budget, Fact::speed, Fact::run,
                                             Fact::reading, Fact::messages, Fact::window});
      EXPECT_EQ(says, IsSetting(option)) << option.name;
    }
}

TEST(CommandLine, TheImageOfALoneSceneIsBesideIt) {
  const auto image_of = [](std::vector<std::string> words) {
    return ReadCommandLine(Program::raypro, words).files.image;
  };
  EXPECT_EQ(image_of({"my/in.scn"}), "my/in.png");
  EXPECT_EQ(image_of({"-width", "64", "In.SCN", "-srgb"}), "In.png");
  EXPECT_EQ(image_of({"my.v2/in.yaml"}), "my.v2/in.png");
  EXPECT_EQ(image_of({"scene01.json"}), "scene01.png");
  EXPECT_EQ(image_of({"in.scn", "out.jpg"}), "out.jpg");
  EXPECT_EQ(image_of({"in.scn", "-check"}), "");
}

TEST(CommandLine, AnExtensionMayBeInCapitals) {
  EXPECT_EQ(Parsed({"S.YAML"}).files.image, "S.png");
  EXPECT_EQ(Parsed({"s.Yml"}).files.image, "s.png");
}

TEST(CommandLine, HelpAnywhereIsAnsweredDespiteOtherMistakes) {
  for (const Words& words : {Words{"-help"},
                             {"--help"},
                             {"-h"},
                             {"in.scn", "out.jpg", "-help"},
                             {"-nonsense", "-help"},
                             {"-width", "abc", "-help"},
                             {"-help", "in.scn", "out.jpg"}})
    EXPECT_TRUE(Parsed(words).Asks("help")) << words[0];
  EXPECT_EQ(Parsed({"-help", "light"}).subject, "light");
  EXPECT_EQ(Parsed({"-help=light"}).subject, "light");
  EXPECT_EQ(Parsed({"-help", "max_depth"}).subject, "max_depth");
  EXPECT_EQ(Parsed({"-help", "quality"}).subject, "quality");  // a topic comes before an option
}

// Any other exception would end the program with the status of a failed render.
TEST(CommandLine, AnyArgumentsParseOrGiveAUsageError) {
  Words vocabulary{"", "-", "--", "---", "=", "-=", "--=x", "a", "1", "-1", "1e9", "on", "\xff\xfe", "-\n", "graph"};
  for (const Program& program : programs)
    for (const OptionKind& option : OptionTable(program))
      for (const char* end : {"", "=", "=1", "=on"}) vocabulary.push_back("-" + std::string(option.name) + end);
  std::mt19937 random(3);
  for (int round = 0; round < 20'000; ++round) {
    Words words(random() % 7);
    for (std::string& word : words) word = vocabulary[random() % vocabulary.size()];
    try {
      ReadWords(programs[random() % programs.size()], words);
    } catch (const UsageError& error) {
      EXPECT_STRNE(error.what(), "");
    }
  }
}

TEST(CommandLine, AnOptionOfTheOtherProgramIsReportedAsOne) {
  for (const Program& program : scene_programs)
    for (const OptionKind& option : OptionTable(TheOther(program))) {
      const std::string name = option.name;
      if (FindOption(program, name)) continue;
      const std::string hint = "-" + name + " is an option of " + NameOf(TheOther(program));
      EXPECT_TRUE(Has(ErrorBeside({"-" + name}, program), hint)) << name;
    }
}

// An option of both programs must be read equally in both, or an image traced in the window differs.
TEST(CommandLine, SharedOptionsHaveOneDefaultExceptForTheSize) {
  for (const OptionKind& option : OptionTable(Program::rayview))
    EXPECT_TRUE(option.known_to == KnownTo::rayview ||
                Program::rayview.defaults()->Show(option) == Program::raypro.defaults()->Show(option))
        << option.name;
  EXPECT_EQ(ViewerOptions().render.width, 512);
  EXPECT_EQ(ViewerOptions().render.height, 512);
}

TEST(CommandLine, RayviewTakesOneNameAndItsOwnOptions) {
  const ViewerOptions o = ViewParsed({"-image", "s.png", "-output_image=w.png", "-headless", "-context", "egl",
                                      "-events", "-", "-screenshot", "e.png", "-record", "r.txt", "-reference", "a.pfm",
                                      "-samples", "4", "-width", "640", "-v"});
  EXPECT_EQ(o.program, &Program::rayview);
  EXPECT_FALSE(o.request);
  EXPECT_EQ(o.files.scene, "in.scn");
  EXPECT_EQ(o.files.image, "s.png");
  EXPECT_EQ(o.view.output_image, "w.png");
  EXPECT_TRUE(o.view.headless);
  EXPECT_FALSE(o.view.exit_immediately);
  EXPECT_EQ(o.view.context, "egl");
  EXPECT_EQ(o.view.events, "-");
  EXPECT_EQ(o.view.screenshot, "e.png");
  EXPECT_EQ(o.view.record, "r.txt");
  EXPECT_EQ(o.view.reference, "a.pfm");
  EXPECT_EQ(o.render.samples, 4);
  EXPECT_EQ(o.render.width, 640);
  EXPECT_EQ(o.render.height, 512);
  EXPECT_TRUE(o.verbose);
  EXPECT_TRUE(ViewParsed({"-exit_immediately"}).view.exit_immediately);
  EXPECT_EQ(ViewParsed({}).files.image, "");
}

TEST(CommandLine, DebugpixelNamesAPixelAndNeedsNoImage) {
  const RenderOptions o = Parsed({"in.scn", "-debugpixel", "255", "0", "-samples", "4"});
  EXPECT_TRUE(o.Asks("debugpixel"));
  EXPECT_EQ(o.pixel->x, 255);
  EXPECT_EQ(o.pixel->y, 0);
  EXPECT_EQ(o.render.samples, 4);
}

// To examine a render, users append an option to its command.
TEST(CommandLine, DebugpixelAndCheckMayBeAppendedToAnyRender) {
  const Words renders[] = {
      {"-report", "r.json", "-stats"}, {"-time", "5s", "-resume"}, {"-error", "2", "-adaptive", "tile"},
      {"-replay", "r.json"},           {"-checkpoint", "1m"},      {"-layers", "depth", "-restart"},
      {"-reference", "a,b"},           {"-keep_checkpoint"},       {"-denoise", "-samples", "4"}};
  for (const Words& render : renders)
    for (const Words& more : {Words{"-check"}, Words{"-debugpixel", "1", "2"}}) {
      Words words = render;
      words.insert(words.end(), more.begin(), more.end());
      EXPECT_EQ(ErrorBeside(words), "") << render[0];
    }
}

/// Returns a value for the option that is not its default.
Words SomeValue(const OptionKind& option, const Options& defaults) {
  for (const std::string& choice : Choices(option))
    if (choice != defaults.Show(option)) return {choice};
  if (std::holds_alternative<Flag>(option.value)) return {};
  if (std::holds_alternative<NumberList>(option.value)) {
    const Words numbers{"1", "4.5", "1e-30", "2"};
    return {numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(option.arguments.size())};
  }
  if (std::holds_alternative<Rectangle>(option.value)) return {"0", "1", "5", "6"};
  if (std::string(option.name) == "layers") return {"depth,id"};
  if (std::string(option.name) == "part") return {"3/8"};
  if (std::string(option.name) == "define") return {"name=it is"};
  if (std::holds_alternative<FileName>(option.value) || std::holds_alternative<Repeated>(option.value))
    return {"a 'name'"};
  return {"7"};
}

TEST(CommandLine, CommonWordsForAValueSuggestIt) {
  for (const Program& program : scene_programs)
    for (const OptionKind& option : OptionTable(program)) {
      if (!IsSetting(option)) continue;
      const auto given = program.defaults(), read = program.defaults();
      EXPECT_EQ(given->TypedFor(program, option), Words{}) << option.name;
      Store(option, std::string(option.name) == "confidence" ? Words{"0.5"} : SomeValue(option, *given), *given);
      const Words words = given->TypedFor(program, option);
      ASSERT_FALSE(words.empty()) << option.name;
      const auto equals = words[0].find('=');
      Store(option,
            equals == std::string::npos ? Words(words.begin() + 1, words.end()) : Words{words[0].substr(equals + 1)},
            *read);
      EXPECT_EQ(read->Show(option), given->Show(option)) << option.name;
    }
}

// Text copied from a web page may have a dash instead of two hyphens.
TEST(CommandLine, OptionsWithAnotherDashAreNoNames) {
  EXPECT_EQ(ErrorOf({"--", "\u2013width", "out.ppm"}), "") << "behind -- all are names";
  EXPECT_EQ(ErrorOf({"\u2013my scene.scn", "out.ppm"}), "") << "no option has that name";
}

}  // namespace
}  // namespace ray
