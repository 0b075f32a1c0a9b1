// SPDX-License-Identifier: Apache-2.0
// Internals of plots.  Lengths and positions are in tenths of a drawing unit, so that all are whole numbers.
#ifndef SMC_REPORT_PLOT_H
#define SMC_REPORT_PLOT_H

#include "compiler/report/page.h"

enum {
    PLOT_WIDE = 9600, PLOT_LEFT = 640, PLOT_RIGHT = 9480,         // width of the plot; start and end of the time axis
    PLOT_BAND = 220,                                              // height of the band at the top that shows the states
    PLOT_TITLE = 190, PLOT_ROW = 800, PLOT_STRIP = 110, PLOT_GAP = 60         // height of a row's title, of a row of numbers, of a bool; gap
};

typedef struct Plot {
    Buf *out;
    const Trace *t;
    long top, bottom;             // y of the upper and lower end of the rows below the band
} Plot;

void plot_write_tenths(Buf *out, long x);             // writes 123 as 12.3
long plot_x_of_step(const Trace *t, double step);             // where a step, or a fraction of one, begins
void plot_draw_line(Plot *p, const char *class_name, long x1, long y1, long x2, long y2);
void plot_draw_rect(Plot *p, const char *class_name, long x, long y, long wide, long high);
// Writes text of a class; `anchor` aligns its start, middle or end at x.
void plot_draw_text(Plot *p, const char *class_name, const char *anchor, long x, long y, const char *text);

// Returns a round step size of which about `about` multiples are between lo and hi; 0 if no such size exists.
double plot_round_step(double lo, double hi, int about);
const char *plot_label(Arena *arena, double x);       // x as text with at most five digits, unless it is a whole number below 10^7

extern const char plot_defs[];                        // SVG definitions of the patterns of bands, which begin a drawing
long plot_draw_body(Arena *arena, const Trace *t, Buf *out);  // writes everything inside the <svg> tag; returns the height of the drawing

void plot_draw_bands(Plot *p);                        // draws the states as bands at the top, and as tints behind the rows
long plot_draw_legend(Plot *p, long y);               // draws the legend at y; returns the y of its end

#endif
