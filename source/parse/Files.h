#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace ray {

/// Why a file named by a scene cannot be read, in words; the reader adds the place that names it.
struct FileError {
  std::string message, hint;
  std::string similar{};  // the name of an existing file that resembles the missing one; may be empty
};

/// A file that exists and may be read.
struct FoundFile {
  std::string shown;      // as messages call it: next to the file that names it
  std::string canonical;  // absolute and free of links: the same for every name of a file
};

/// What messages, and lists of a scene's files, call standard input. The user names it "-".
inline constexpr const char* standard_input_name = "<stdin>";
/// All of it: read when it is first asked for, and kept, since it can be read but once. Throws FileError.
const std::string& StandardInput();

/// Finds and opens the files of one scene. A scene may come from a stranger: it reads regular files below its own
/// folder, the current folder and the folders that the user allows, and nothing else.
class Files {
 public:
  /// Files longer than this are refused.
  static constexpr std::size_t max_bytes = std::size_t{1} << 30;

  /// Opens the top scene wherever it lies: the user named it. "-" is standard input, as if it lay in the current
  /// folder. Throws FileError when a folder that is to be allowed is none.
  Files(const std::string& top_scene, const std::vector<std::string>& allowed_folders);

  const std::string& TopName() const { return top_; }
  bool IsStandardInput() const { return top_ == standard_input_name; }
  /// The top scene; throws FileError.
  FoundFile Top() const;
  /// Looks in the folder of the file that names it, then in the current folder. A file whose path is that of another
  /// folder or computer, such as "../x.png", "/home/me/x.png" or "C:\x.png", and which is not there, is looked for by
  /// its name in each of these folders, in their textures/, and in the same two places above them. Throws FileError,
  /// with the name of a similar file if there is one.
  FoundFile Find(const std::string& name, const std::string& named_in) const;
  /// Looks in these folders, the first first; "" is the current one. Throws FileError.
  FoundFile FindIn(std::span<const std::string> folders, const std::string& name) const;
  /// Warnings about the files that were not where their paths say but found elsewhere; one for each path.
  const std::set<std::string>& Remarks() const { return remarks_; }
  /// The whole file. Throws FileError, also when a link or another kind of file has taken its place since Find.
  std::string Read(const FoundFile& file) const;

 private:
  /// Throws FileError, but returns one in `denied` if the system does not let us look there.
  std::optional<FoundFile> FindAt(const std::string& folder, const std::string& name,
                                  std::optional<FileError>& denied) const;
  std::optional<FoundFile> FindElsewhere(std::span<const std::string> folders, const std::string& name) const;
  bool IsAllowed(const std::string& canonical) const;
  std::string SimilarIn(std::span<const std::string> folders, const std::string& name) const;

  std::string top_;
  std::vector<std::string> roots_;  // canonical
  mutable std::set<std::string> remarks_;
};

/// The contents of a regular file that Files found. Throws FileError, also if a link or another kind of file has taken
/// its place since. Only this function, of ReadFile.cpp, and StandardInput read input; the page in a browser has its
/// own version.
std::string ReadFile(const FoundFile& file);

}  // namespace ray
