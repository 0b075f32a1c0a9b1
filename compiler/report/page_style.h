// SPDX-License-Identifier: Apache-2.0
// The style of a report page: light or dark as the reader's screen is, and for paper.
#ifndef SMC_PAGE_STYLE_H
#define SMC_PAGE_STYLE_H

extern const char *const report_style[];              // the CSS in several strings; NULL-terminated

// The part for a plot in a separate file: ":root{--name:value;…}" of the light page, and rules that use these variables.
extern const char plot_style_light[], plot_style[];

#endif
