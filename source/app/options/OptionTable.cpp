#include "source/app/options/OptionTable.h"

#include <algorithm>

namespace ray {
namespace {

bool IsKnown(KnownTo known_to, const Program& program) {
  switch (known_to) {
    case KnownTo::raypro:
      return program == Program::raypro;
    case KnownTo::rayview:
      return program == Program::rayview;
    case KnownTo::both:
      return program == Program::raypro || program == Program::rayview;
    case KnownTo::one:
    case KnownTo::all:
      return true;
  }
  return false;
}

}  // namespace

std::vector<OptionKind> KnownOptions(std::vector<OptionKind> list, const Program& program) {
  std::erase_if(list, [&](const OptionKind& option) { return !IsKnown(option.known_to, program); });
  return list;
}

const OptionKind* FindOption(const Program& program, const std::string& name) {
  for (const OptionKind& option : OptionTable(program)) {
    const auto is_name = [&](const char* candidate) { return name == candidate; };
    if (is_name(option.name) || std::ranges::any_of(option.aliases, is_name)) return &option;
  }
  return nullptr;
}

std::vector<std::string> OptionTopics(const Program& program) {
  std::vector<std::string> topics;
  for (const OptionKind& option : OptionTable(program))
    if (option.commands.empty() && (topics.empty() || topics.back() != option.topic)) topics.emplace_back(option.topic);
  return topics;
}

std::vector<std::string> CommandNamesOf(const Program& program) {
  std::vector<std::string> names;
  for (const CommandKind& command : program.commands()) names.emplace_back(command.name);
  return names;
}

const CommandKind* FindCommand(const Program& program, const std::string& name) {
  for (const CommandKind& command : program.commands())
    if (name == command.name) return &command;
  return nullptr;
}

bool Takes(const CommandKind& command, const OptionKind& option) {
  return std::ranges::any_of(option.commands, [&](const std::string& name) { return name == command.name; });
}

}  // namespace ray
