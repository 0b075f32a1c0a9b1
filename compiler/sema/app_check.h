// SPDX-License-Identifier: Apache-2.0
// What the files of the checker of applications share.  Inside sema/ only.
#ifndef SMC_APP_CHECK_H
#define SMC_APP_CHECK_H

#include "compiler/sema/app.h"
#include "compiler/sema/sema.h"

typedef struct AppCheck {
    const CheckContext *c;
    const AstApp *ast;
    App *app;
    const AppFiles *files;
    const StateVec *sv;           // NULL: it has errors; then elements are not looked for
    const IoMap *pins;            // or NULL
    unsigned guesses;             // how many more unknown names are compared with all known ones
    Map file_index;               // of machines: name as written to 1 + its place in files
    Map machine_file;             // name as written to the Span where it is named first
    Map task, executor;           // name to the Span of the first
    Map vital;                    // element's name to what it holds: const char *
    Map start;                    // element's name to the Span of its first value
    Span service[AST_APP_TASK_COUNT];     // where inputs, outputs, log, keep stand
} AppCheck;

// The element, or NULL after a message (or where the state vector has errors).
const Element *app_find_element(AppCheck *k, const AstWord *name);

Str app_stem(AppCheck *k, Str path);      // "rocket" of pins/rocket.io

// ---- check_app_names.c ----

void check_app_products(AppCheck *k);
void check_app_platform_files(AppCheck *k);     // the log's and keep's

// ---- check_app_time.c ----

typedef struct AppRange { uint64_t least, most; bool power_of_two; const char *text; } AppRange;

// The amount as a whole number; false after a message: `what` is not what `r` says.
bool app_whole(AppCheck *k, const AstAmount *a, const AppRange *r, const char *what, uint64_t *value);
void check_app_rates(AppCheck *k, const AstAppExecutor *in, AppExecutor *out);

// ---- check_app_task.c ----

bool app_is_of_runtime(const char *name);       // what begins with it may be a name of runtime-c

void check_app_tasks(AppCheck *k, const AstAppExecutor *in, AppExecutor *out);      // behind its rates

// ---- check_app_start.c ----

void check_app_start(AppCheck *k);

#endif
