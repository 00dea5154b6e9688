#include "page/site_html.h"

#include <fmt/format.h>

#include "embedded/site.h"
#include "page/template_filling.h"
#include "text/escape.h"

namespace twrench::page {

std::string site_html(std::span<const SiteEntry> pages) {
  std::string items;
  for (const SiteEntry& page : pages) {
    items += fmt::format("<li><a href=\"{}\">{}<h2>{}</h2><p>{}</p></a></li>\n",
                         text::escape_xml(page.file), page.poster, text::escape_xml(page.title),
                         text::escape_xml(page.description));
  }
  TemplateFilling index(embedded::site().at("site.html"));
  index.put("<!-- twrench:pages -->\n", items);
  return std::move(index).filled();
}

}  // namespace twrench::page
