// SPDX-License-Identifier: Apache-2.0
// Inside of plots: where things lie.  Lengths are in tenths of a unit of the drawing, so that all are whole numbers.
#ifndef SMC_REPORT_PLOT_H
#define SMC_REPORT_PLOT_H

#include "compiler/emit/report/report.h"

enum {
    PLOT_WIDE = 9600, PLOT_LEFT = 640, PLOT_RIGHT = 9480,         // of the whole; where the time begins and ends
    PLOT_BAND = 220,                                              // the band of states on top
    PLOT_TITLE = 190, PLOT_ROW = 800, PLOT_STRIP = 110, PLOT_GAP = 60
};

typedef struct Plot {
    Buf *out;
    const Trace *t;
    long top, bottom;             // of the rows, below the band
} Plot;

void plot_tenths(Buf *out, long x);                   // 123 as 12.3
long plot_x(const Trace *t, double step);             // where a step begins, or a part of one
void plot_line(Plot *p, const char *class_name, long x1, long y1, long x2, long y2);
void plot_rect(Plot *p, const char *class_name, long x, long y, long wide, long high);
// Text in its class, at its start, middle or end.
void plot_text(Plot *p, const char *class_name, const char *anchor, long x, long y, const char *text);

// A step such that from lo to hi there are about `about` round numbers; 0 where there is none.
double plot_round_step(double lo, double hi, int about);
const char *plot_label(Arena *arena, double x);       // five digits at most

extern const char plot_defs[];                        // the patterns, for the head of a drawing
long plot_body(Arena *arena, const Trace *t, Buf *out);       // all but the <svg> around it; gives how high it is

void plot_bands(Plot *p);                             // on top, and tinted behind the rows
long plot_legend(Plot *p, long y);                    // gives where it ends

#endif
