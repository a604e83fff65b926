#pragma once

#include <string_view>

namespace breccia::studio {

/// The files of the page, which are put into the program when it is built.

/// `page/index.html`
std::string_view page_document();
/// `page/main.js` with the modules that it imports
std::string_view page_script();
/// `page/studio.css`
std::string_view page_style();
/// `docs/decks.md`: the reference of the keys, from which the page makes its forms
std::string_view key_reference();

}  // namespace breccia::studio
