// SPDX-License-Identifier: Apache-2.0
// The style of a report page: for screens in light and in dark mode, and for paper.
#ifndef SMC_PAGE_STYLE_H
#define SMC_PAGE_STYLE_H

extern const char *const report_style[];              // the CSS in several strings; NULL-terminated

// The parts of the style that a plot in a separate file needs: ":root{--name:value;…}" of the light mode, and rules that use these variables.
extern const char plot_style_light[], plot_style[];

#endif
