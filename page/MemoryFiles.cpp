#include "page/MemoryFiles.h"

#include <filesystem>

#include "source/parse/Files.h"
#include "source/text/Quoting.h"

namespace ray {

std::map<std::string, std::string>& MemoryFiles() {
  static std::map<std::string, std::string> files;
  return files;
}

const std::string& StandardInput() { throw FileError{"there is no standard input here", {}}; }

std::string ReadFile(const FoundFile& file) {
  const auto found = MemoryFiles().find(file.canonical);
  if (found == MemoryFiles().end()) throw FileError{QuotedPath(file.shown) + " is a folder", {}};
  return found->second;
}

}  // namespace ray

namespace std {
namespace filesystem {
namespace {

string Absolute(const path& name) {
  string absolute = ("/" / name).lexically_normal().string();
  if (absolute.size() > 1 && absolute.ends_with('/')) absolute.pop_back();
  return absolute;
}

bool IsFile(const string& absolute) { return ray::MemoryFiles().contains(absolute); }

string Prefix(const string& folder) { return folder == "/" ? folder : folder + "/"; }

bool IsFolder(const string& absolute) {
  const string prefix = Prefix(absolute);
  const auto next = ray::MemoryFiles().lower_bound(prefix);
  return absolute == "/" || (next != ray::MemoryFiles().end() && next->first.starts_with(prefix));
}

}  // namespace

path canonical(const path& name, error_code& error) {
  const string absolute = Absolute(name);
  error = {};
  if (!IsFile(absolute) && !IsFolder(absolute)) error = make_error_code(errc::no_such_file_or_directory);
  return error ? path() : path(absolute);
}

bool exists(const path& name, error_code& error) {
  canonical(name, error);
  const bool is_there = !error;
  error = {};
  return is_there;
}

bool is_directory(const path& name) { return IsFolder(Absolute(name)); }
bool is_directory(const path& name, error_code& error) {
  error = {};
  return is_directory(name);
}
bool is_regular_file(const path& name, error_code& error) {
  error = {};
  return IsFile(Absolute(name));
}

path read_symlink(const path&, error_code& error) {
  error = make_error_code(errc::invalid_argument);
  return {};
}

directory_iterator::directory_iterator(const path& folder, error_code& error) {
  error = {};
  const string prefix = Prefix(Absolute(folder));
  set<string> names;
  for (auto file = ray::MemoryFiles().lower_bound(prefix);
       file != ray::MemoryFiles().end() && file->first.starts_with(prefix); ++file) {
    const string rest = file->first.substr(prefix.size());
    names.insert(rest.substr(0, rest.find('/')));
  }
  for (const string& name : names) entries_.emplace_back(folder / name);
}

}  // namespace filesystem
}  // namespace std
