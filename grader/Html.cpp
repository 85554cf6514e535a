#include "grader/Html.h"

#include <algorithm>

#include "R2/ImageFile.h"
#include "grader/Base64.h"
#include "source/text/Quoting.h"

namespace ray::grade {
namespace {

constexpr const char* style =
    "body{font:16px/1.45 system-ui,sans-serif;max-width:60em;margin:1em auto;padding:0 1em;color:#222;background:#fff}"
    "h1{font-size:1.5em}h2{font-size:1.15em;margin:1.6em 0 .3em;border-top:1px solid #ccc;padding-top:.6em}"
    "h3{font-size:1em;margin:1.2em 0 .2em}"
    "figure{display:inline-block;margin:.3em .6em .3em 0;vertical-align:top}figcaption{font-size:.85em;color:#555}"
    "img{image-rendering:pixelated;max-width:100%;min-width:8em;border:1px solid #ccc}"
    ".third{width:30%;max-width:18em;margin-right:1.5%}.third>img{width:100%;min-width:0}"
    "table{border-collapse:collapse}td,th{border:1px solid #ccc;padding:.2em "
    ".5em;text-align:left}td.n{text-align:right;white-space:nowrap}"
    "pre{font-size:.8em;overflow-x:auto;background:#f6f6f6;padding:.5em;white-space:pre-wrap}"
    ".right{background:#dff0d8}.known{background:#fcf3cf}.different,.failed{background:#f8d7da}"
    ".over{position:relative;display:inline-block;max-width:100%;overflow:auto}"
    ".over img{display:block;max-width:none;min-width:0}"
    ".over>div{position:absolute;top:0;left:0;width:50%;height:100%;max-width:100%;overflow:hidden;resize:horizontal;"
    "border-right:2px solid #c00;box-sizing:border-box}"
    ".bar{background:#69c;height:.8em;display:inline-block}"
    "@media print{body{max-width:none;print-color-adjust:exact;-webkit-print-color-adjust:exact}"
    "h2,h3,figure,tr{break-inside:avoid}h2,h3,h2~p{break-after:avoid}"
    ".over>div{position:static;width:auto;border:0}}";

}  // namespace

std::string HtmlOf(const std::string& text) {
  std::string html;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '<')
      html += "&lt;";
    else if (c == '>')
      html += "&gt;";
    else if (c == '&')
      html += "&amp;";
    else if (c == '"')
      html += "&quot;";
    else if (byte >= ' ' || c == '\n' || c == '\t')
      html += c;
    else
      html += "?";
  }
  return html;
}

std::string ImageTag(const R2::Image& image, const std::string& about) {
  const auto bytes = R2::FormatForName("x.png")->encode(image, {}, {});
  return "<img alt=\"" + HtmlOf(about) + "\" src=\"data:image/png;base64," + Base64(bytes) + "\">";
}

std::string Slider(const R2::Image& over, const std::string& about_over, const R2::Image& under,
                   const std::string& about_under) {
  return "<div class=\"over\">" + ImageTag(under, about_under) + "<div>" + ImageTag(over, about_over) + "</div></div>";
}

std::string Page(const std::string& title, const std::string& body) {
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
         "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n<title>" +
         HtmlOf(title) + "</title>\n<style>" + style + "</style></head>\n<body>\n<h1>" + HtmlOf(title) + "</h1>\n" +
         body + "</body></html>\n";
}

R2::Image CropAround(const R2::Image& image, int x, int y, int reach, int scale) {
  const int side = 2 * reach + 1;
  R2::Image crop(side * scale, side * scale);
  for (int j = 0; j < side * scale; ++j)
    for (int i = 0; i < side * scale; ++i) {
      const int column = std::clamp(x - reach + i / scale, 0, image.Width() - 1);
      const int row = std::clamp(y - reach + j / scale, 0, image.Height() - 1);
      crop.Set(i, j, image.At(column, row));
    }
  // Draws a frame around the pixel in the middle.
  const int low = reach * scale - 1, high = (reach + 1) * scale;
  for (int k = low; k <= high; ++k)
    for (const auto& [i, j] : {std::pair{k, low}, {k, high}, {low, k}, {high, k}}) crop.Set(i, j, {1, 1, 0});
  return crop;
}

}  // namespace ray::grade
