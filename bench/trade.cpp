// What the renderer gives for its time, beside the goals set for it: one table a goal, each figure met or missed.
//
//     make bench && build/bench/trade [letters of goals...] [quick=1] [seeds=K] [scenes=a,b] [out=folder]
//                                     [raypro=program]
//
// Run from the root of the checkout. Errors are true ones, against two references with independent noise that cancels
// in the mean of (x - r1)(x - r2); they are rendered once and kept in `out`, beside trade-<letter>.csv. All of it takes
// about half an hour on two idle cores; quick=1 a tenth, with figures that only show that all works. The exit
// status is 1 when a goal is missed.

#include <cstdlib>

#include "bench/TradeClaims.h"
#include "bench/TradeProgram.h"
#include "bench/TradeSampling.h"

namespace {

struct Goal {
  char letter;
  const char* what;
  void (*measure)(trade::Lab&, trade::Table&);
};

constexpr Goal goals[] = {
    {'A', "error beside random sampling in the same CPU time", trade::ErrorAtEqualTime},
    {'D', "slope of log error over log samples, 16 to 256", trade::Slopes},
    {'E', "sky with a sun, 64 samples: gain over even directions with as many rays", trade::Sky},
    {'F', "one of many lights chosen a point: gain of importance", trade::ManyLights},
    {'G', "claimed errors beside true ones", trade::Claims},
    {'H', "stopping by the error, in 255ths", trade::Targets},
    {'I', "stopping by the clock", trade::Time},
    {'J', "adaptive tiles beside as many samples everywhere", trade::AdaptiveTiles},
    {'L', "what the estimate of the error costs", trade::CostOfClaims},
    {'M', "the same bytes again", trade::Determinism},
    {'N', "filters, 64 samples: error against their own truth beside the box's", trade::Filters},
};

int Usage(const char* word) {
  std::fprintf(stderr, "trade: what is '%s'? Goals are letters:\n", word);
  for (const Goal& goal : goals) std::fprintf(stderr, "  %c  %s\n", goal.letter, goal.what);
  std::fprintf(stderr, "Options are quick=1, seeds=K, scenes=a,b, out=folder, raypro=program.\n");
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  trade::Wishes wishes;
  wishes.raypro = std::filesystem::path(argv[0]).parent_path().parent_path() / "raypro";
  std::string letters;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto sign = word.find('=');
    const std::string name = word.substr(0, sign), value = sign == std::string::npos ? "" : word.substr(sign + 1);
    if (sign == std::string::npos) {
      for (const char letter : word) {
        if (std::none_of(std::begin(goals), std::end(goals), [&](const Goal& g) { return g.letter == letter; }))
          return Usage(argv[i]);
        letters += letter;
      }
    } else if (name == "quick") {
      wishes.quick = value != "0";
    } else if (name == "seeds" && std::atoi(value.c_str()) > 1) {
      wishes.seeds = std::atoi(value.c_str());
    } else if (name == "scenes") {
      wishes.scenes = value;
    } else if (name == "out") {
      wishes.out = value;
    } else if (name == "raypro") {
      wishes.raypro = value;
    } else {
      return Usage(argv[i]);
    }
  }

  int figures = 0, missed = 0;
  try {
    trade::Lab lab(wishes);
    for (const Goal& goal : goals) {
      if (!letters.empty() && letters.find(goal.letter) == std::string::npos) continue;
      trade::Table table(lab, goal.letter, goal.what);
      goal.measure(lab, table);
      figures += table.Goals();
      missed += table.Missed();
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "trade: %s\n", error.what());
    return 2;
  }
  std::printf("\n%d of %d figures met\n", figures - missed, figures);
  return missed > 0 ? 1 : 0;
}
