// SPDX-License-Identifier: Apache-2.0
// How the page of a report looks: light or dark as the reader's screen is, and on paper.
#ifndef SMC_REPORT_STYLE_H
#define SMC_REPORT_STYLE_H

extern const char *const report_style[];              // NULL closes it

// Of these, for a plot that stands alone: ":root{--name:value;…}" of the light page, and rules that use them.
extern const char plot_style_light[], plot_style[];

#endif
