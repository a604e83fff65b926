#pragma once

#include <string_view>

namespace breccia {

/// The texts of pages that contain their style, their scripts and the plotting library. They are made when the program
/// is built.

/// `page/assess.html`
std::string_view assess_page_template();
/// `page/fit.html`
std::string_view fit_page_template();
/// `page/study.html`
std::string_view study_page_template();
/// `page/sweep.html`
std::string_view sweep_page_template();
/// The elements of a page that draw the views of three dimensions: three.js and `page/views_main.js`.
std::string_view views_scripts();

}  // namespace breccia
