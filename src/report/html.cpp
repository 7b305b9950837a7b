#include "report/html.hpp"

#include <fmt/format.h>

#include "audit/digest.hpp"
#include "report/report_content.hpp"

namespace rva {
namespace {

std::string escaped(std::string_view words) {
  std::string markup;
  for (const char byte : shown_text(words)) switch (byte) {
      case '&':
        markup += "&amp;";
        break;
      case '<':
        markup += "&lt;";
        break;
      case '>':
        markup += "&gt;";
        break;
      case '"':
        markup += "&quot;";
        break;
      case '\'':
        markup += "&#39;";
        break;
      default:
        markup += byte;
    }
  return markup;
}

}  // namespace

Html Html::text(std::string_view words) { return markup(escaped(words)); }

Html Html::typed(std::string_view words) { return element("bdi", text(words), "typed"); }

Html Html::element(std::string_view name, const Html& content, std::string_view class_name) {
  const std::string attribute = class_name.empty() ? "" : fmt::format(" class=\"{}\"", class_name);
  return markup(fmt::format("<{0}{1}>{2}</{0}>", name, attribute, content.markup_));
}

Html Html::jpeg(std::span<const std::byte> jpeg, std::string_view description) {
  const std::string_view bytes(reinterpret_cast<const char*>(jpeg.data()), jpeg.size());
  return markup(fmt::format("<img alt=\"{}\" src=\"data:image/jpeg;base64,{}\">", escaped(description),
                            base64_of(bytes)));
}

Html Html::markup(std::string_view written) {
  Html html;
  html.markup_ = written;
  return html;
}

Html& Html::operator+=(const Html& more) {
  markup_ += more.markup_;
  return *this;
}

}  // namespace rva
