#include "source/app/files/OutputFile.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "source/app/Status.h"
#include "source/app/files/TemporaryFile.h"
#include "source/text/Quoting.h"

namespace ray {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void Refuse(const std::string& name, const std::string& reason, const std::string& kept_as = {}) {
  throw OutputError("cannot write " + Quoted(name) + ": " + reason, kept_as);
}

/// Returns the end of a chain of links, which need not exist.
fs::path FollowLinks(const std::string& name) {
  constexpr int most_links = 40;  // as the system itself allows
  fs::path path = name;
  std::error_code error;
  for (int i = 0; fs::is_symlink(fs::symlink_status(path, error)); ++i) {
    if (i == most_links) Refuse(name, "it has too many levels of symbolic links");
    path = path.parent_path() / fs::read_symlink(path, error);
    if (error) Refuse(name, error.message());
  }
  return path;
}

void RefuseUnfitTarget(const OutputFile& output) {
  std::error_code error;
  const fs::file_status status = fs::status(output.name, error);  // also for the name of a pipe in /dev/fd
  if (status.type() == fs::file_type::not_found) return;
  if (error) Refuse(output.name, error.message());
  if (fs::is_directory(status)) Refuse(output.name, "it is a folder");
  if (!fs::is_regular_file(status)) Refuse(output.name, "it is not a regular file");
  // The rename would succeed in a folder of ours, but a read-only file is meant to be kept.
  if (faccessat(AT_FDCWD, output.target.c_str(), W_OK, AT_EACCESS) != 0)
    Refuse(output.name, std::generic_category().message(errno));
}

void RefuseUnfitFolder(const OutputFile& output) {
  const fs::path folder = output.target.parent_path();
  std::error_code error;
  if (!folder.empty() && !fs::is_directory(folder, error))
    Refuse(output.name, "the folder " + Quoted(folder.string()) + " does not exist");
  if (output.target.filename().empty()) Refuse(output.name, "it names no file");
  // The only reliable test of whether a folder accepts files is to create one.
  try {
    const TemporaryFile probe(output.target);
  } catch (const std::system_error& failure) {
    Refuse(output.name, failure.code().message());
  }
}

/// Writes a file with the permissions of `replaced`.
void WriteAt(const fs::path& target, const fs::path& replaced, std::span<const unsigned char> bytes) {
  TemporaryFile file(target, replaced);
  file.Write(bytes);
  file.Become();
}

/// Saves the bytes elsewhere and throws an OutputError that states where they are, or why that failed.
[[noreturn]] void KeepElsewhere(const OutputFile& output, std::span<const unsigned char> bytes,
                                const std::string& reason) {
  std::error_code error;
  const fs::path folder = fs::temp_directory_path(error);
  if (error) Refuse(output.name, reason + "; there is no temporary folder to keep it in");
  const fs::path refuge = folder / ("raypro-" + std::to_string(getpid()) + "-" + output.target.filename().string());
  try {
    WriteAt(refuge, output.target, bytes);
  } catch (const std::system_error& failure) {
    Refuse(output.name,
           reason + "; nor can it be kept as " + QuotedPath(refuge.string()) + ": " + failure.code().message());
  }
  Refuse(output.name, reason + "; it is kept as " + QuotedPath(refuge.string()), refuge.string());
}

}  // namespace

void RefuseInputs(const OutputFile& output, std::span<const std::string> inputs) {
  for (const std::string& input : inputs) {
    std::error_code error;
    if (fs::equivalent(output.target, input, error) && !error)
      Refuse(output.name, "it is the input " + Quoted(input) + " itself");
  }
}

OutputFile CheckOutput(const std::string& name, std::span<const std::string> inputs) {
  OutputFile output{.name = name, .target = FollowLinks(name)};
  output.is_link = output.target != fs::path(name);
  RefuseUnfitTarget(output);
  RefuseInputs(output, inputs);
  RefuseUnfitFolder(output);
  RemoveLeftOvers(output.target);
  return output;
}

bool IsThere(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::exists(file, ignored);
}

std::string NameBeside(const std::string& name, const std::string& word) {
  const fs::path path(name);
  return (path.parent_path() / (path.stem().string() + "." + word + path.extension().string())).string();
}

void WriteWhole(const OutputFile& output, std::span<const unsigned char> bytes) {
  if (output.is_standard_output)
    return WriteStandardOutput(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  try {
    WriteAt(output.target, output.target, bytes);
  } catch (const std::system_error& failure) {
    KeepElsewhere(output, bytes, failure.code().message());
  }
}

void WriteStandardOutput(const std::string& text) {
  std::span<const char> rest = text;
  while (!rest.empty()) {
    const ssize_t written = write(STDOUT_FILENO, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0 && errno == EPIPE) return;
    if (written < 0) Refuse("standard output", std::generic_category().message(errno));
    rest = rest.subspan(static_cast<std::size_t>(written));
  }
}

}  // namespace ray
