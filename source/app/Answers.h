#pragma once

#include <string>

namespace ray {

struct Options;

/// What requests print. Those of a scene take RenderOptions.
namespace answer {

/// Does everything that rendering would short of the first ray, and names likely mistakes.
std::string Check(const Options& options);
std::string Files(const Options& options);
std::string Advise(const Options& options);
/// Writes the scene as .scn too.
std::string Convert(const Options& options);
std::string RaysOfPixel(const Options& options);
std::string Info(const Options& options);
std::string Help(const Options& options);
std::string Version(const Options& options);
std::string List(const Options& options);
std::string Complete(const Options& options);
std::string Manual(const Options& options);

}  // namespace answer

/// Prints what is asked for instead of the program's own work.
void AnswerRequest(const Options& options);

}  // namespace ray
