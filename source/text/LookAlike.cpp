#include "source/text/LookAlike.h"

#include <algorithm>
#include <array>

#include "source/text/Quoting.h"

namespace ray {
namespace {

/// The characters from first to last, which resemble ASCII characters: all of them `ascii`, or consecutive ones from it
/// on.
struct LookAlike {
  char32_t first, last;
  const char* name;
  const char* ascii;
  bool is_in_order = false;
};

// Names of The Unicode Standard, in lower case; for ranges, the common part of the names.
constexpr std::array look_alikes{
    LookAlike{0x00A0, 0x00A0, "a no-break space", " "},
    LookAlike{0x00AB, 0x00AB, "a quotation mark", "\""},
    LookAlike{0x00AD, 0x00AD, "a soft hyphen, which is invisible", ""},
    LookAlike{0x00B7, 0x00B7, "a middle dot", "*"},
    LookAlike{0x00BB, 0x00BB, "a quotation mark", "\""},
    LookAlike{0x00D7, 0x00D7, "a multiplication sign", "*"},
    LookAlike{0x00F7, 0x00F7, "a division sign", "/"},
    LookAlike{0x0660, 0x0669, "an Arabic-Indic digit", "0", true},
    LookAlike{0x06F0, 0x06F9, "an Arabic-Indic digit", "0", true},
    LookAlike{0x180E, 0x180E, "a vowel separator, which is invisible", ""},
    LookAlike{0x2000, 0x200A, "a space of typography", " "},
    LookAlike{0x200B, 0x200B, "a zero-width space", ""},
    LookAlike{0x200C, 0x200D, "a zero-width joiner", ""},
    LookAlike{0x200E, 0x200F, "a direction mark, which is invisible", ""},
    LookAlike{0x2010, 0x2010, "a hyphen", "-"},
    LookAlike{0x2011, 0x2011, "a non-breaking hyphen", "-"},
    LookAlike{0x2012, 0x2012, "a figure dash", "-"},
    LookAlike{0x2013, 0x2013, "an en dash", "-"},
    LookAlike{0x2014, 0x2015, "an em dash", "-"},
    LookAlike{0x2018, 0x201B, "a curly quotation mark", "'"},
    LookAlike{0x201C, 0x201F, "a curly quotation mark", "\""},
    LookAlike{0x2028, 0x2029, "a line separator", " "},
    LookAlike{0x202F, 0x202F, "a narrow no-break space", " "},
    LookAlike{0x2032, 0x2032, "a prime", "'"},
    LookAlike{0x2033, 0x2033, "a double prime", "\""},
    LookAlike{0x2044, 0x2044, "a fraction slash", "/"},
    LookAlike{0x205F, 0x205F, "a space of typography", " "},
    LookAlike{0x2060, 0x2060, "a word joiner, which is invisible", ""},
    LookAlike{0x2066, 0x2069, "a direction mark, which is invisible", ""},
    LookAlike{0x2212, 0x2212, "a minus sign", "-"},
    LookAlike{0x2215, 0x2215, "a division slash", "/"},
    LookAlike{0x3000, 0x3000, "an ideographic space", " "},
    LookAlike{0xFE63, 0xFE63, "a small hyphen-minus", "-"},
    LookAlike{0xFEFF, 0xFEFF, "a byte order mark, which is invisible", ""},
    LookAlike{0xFF01, 0xFF5E, "a full-width character", "!", true},
};

const LookAlike* Find(char32_t c) {
  const auto found = std::ranges::find_if(look_alikes, [&](const LookAlike& l) { return l.first <= c && c <= l.last; });
  return found == look_alikes.end() ? nullptr : &*found;
}

std::string AsciiOf(const LookAlike& found, char32_t c) {
  if (!found.is_in_order) return found.ascii;
  return {static_cast<char>(found.ascii[0] + static_cast<char>(c - found.first))};
}

std::string CodePoint(char32_t c) {
  constexpr char digits[] = "0123456789ABCDEF";
  std::string text = "U+";
  for (int shift = 12; shift >= 0; shift -= 4) text += digits[c >> shift & 15];
  return text;
}

}  // namespace

std::string WithoutLookAlikes(std::string_view word) {
  std::string plain;
  while (!word.empty()) {
    const auto [bytes, code] = FirstCharacter(word);
    const LookAlike* found = code < 0x80 ? nullptr : Find(code);
    plain += found ? AsciiOf(*found, code) : std::string(word.substr(0, bytes));
    word.remove_prefix(bytes);
  }
  return plain;
}

std::string LookAlikeHint(std::string_view word) {
  for (std::string_view rest = word; !rest.empty();) {
    const auto [bytes, code] = FirstCharacter(rest);
    rest.remove_prefix(bytes);
    const LookAlike* found = code < 0x80 ? nullptr : Find(code);
    if (!found) continue;
    const std::string plain = WithoutLookAlikes(word);
    const bool is_blank = plain.find_first_not_of(' ') == std::string::npos;
    return "it has " + CodePoint(code) + ", " + found->name + ": " +
           (is_blank ? plain.empty() ? "delete it" : "type a space" : "type " + Quoted(plain));
  }
  return {};
}

}  // namespace ray
