#pragma once

#include <string>

namespace ray {

struct Options;

/// The output of requests. Those about a scene take RenderOptions.
namespace answer {

/// Does everything before the first ray of a render, and returns a summary with likely mistakes.
std::string Check(const Options& options);
std::string Files(const Options& options);
std::string Advise(const Options& options);
/// Writes the scene as .scn.
std::string Convert(const Options& options);
std::string RaysOfPixel(const Options& options);
std::string Info(const Options& options);
std::string Help(const Options& options);
std::string Version(const Options& options);
std::string List(const Options& options);
std::string Complete(const Options& options);
std::string Manual(const Options& options);

}  // namespace answer

/// Prints the answer to the request instead of doing the program's own work.
void AnswerRequest(const Options& options);

}  // namespace ray
