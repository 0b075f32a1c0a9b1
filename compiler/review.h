// SPDX-License-Identifier: Apache-2.0
// What smc report and smc graph show of a machine besides its program: findings, costs, and the runs of its scripts.
#ifndef SMC_REVIEW_H
#define SMC_REVIEW_H

#include "compiler/compile.h"
#include "compiler/report/page.h"

// Begins a review without runs.  Its findings are those in s->diags when the report is built.
void review_begin(Session *s, const Program *flown, Report *r);
// Adds the costs of a machine as it flies: compiled with the option `measure`, with its image as `smc build` writes it, without names but with
// pins.  `step_given`: the user chose s->step; otherwise the machine declares it, or its scripts do.
void review_add_costs(Session *s, const CompiledSource *m, const Buf *image, bool step_given, Report *r);
// Runs the script `src` on the engines in lock step and records what the first one does in *run.  `p` is the machine as its scripts run it.
// `script`: the compiled script; NULL: it is compiled now, and if it has errors, run->script is NULL and nothing has run.  Diagnostics go to
// run->diags, not to s->diags.
void review_run_script(Session *s, const Report *r, const Program *p, const Source *src, const Script *script, Engine **engine, size_t engines,
                       const ScriptOptions *o, ReportRun *run);
// Begins a review of an application, and of each of its machines as it flies.  opt_level: that of the images whose costs it has.
void review_begin_app(Session *s, const App *app, const Program *joint, int opt_level, Report *r);
// Runs the script `src` of an application into run number `number` of r, and of the report of each machine.  engine: by machine, an engine that
// counts coverage; `vm` runs all machines in lock step.
void review_run_app_script(Session *s, Report *r, const Source *src, Engine *vm, Engine *const *engine, const ScriptOptions *o, size_t number);
// Measures which code of p the runs of r cover, if none of their engines has measured it: runs the scripts of r again.
void review_measure_coverage(Session *s, const Program *p, Report *r);

#endif
