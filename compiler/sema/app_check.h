// SPDX-License-Identifier: Apache-2.0
// Shared by the files that check applications.  Only files in sema/ include this header.
#ifndef SMC_APP_CHECK_H
#define SMC_APP_CHECK_H

#include "compiler/sema/application.h"
#include "compiler/sema/sema.h"

typedef struct AppCheck {
    const CheckContext *c;
    const AstApp *ast;
    App *app;
    const AppFiles *files;
    const StateVec *sv;           // NULL if it has errors; then elements are not looked up
    const IoMap *pins;            // NULL if the application has no pins, or they have errors
    const Network *net;           // the messages of the application, or NULL
    unsigned guesses;             // how many more unknown names may be compared with all known ones
    Map machine_file;             // the file name as written of a machine without bindings, to the Span of its first use
    Map machine_state;            // "N ELEMENT" of a machine, its file's index and the element that is its S, to the AppMachine
    Map task, executor;           // the name of a task or executor, to the Span of its first use
    Map statistic;                // the name of an element that an executor writes, to a description of its content (const char *)
    Map start;                    // the name of an element in [start], to the Span of its first value
    Span service[AST_APP_TASK_COUNT];     // by AstAppTaskKind: the position of the inputs, outputs, log and keep task
} AppCheck;

// Returns the element, or NULL after a report.  Also returns NULL, without a report, if the state vector has errors.
const Element *app_find_element(AppCheck *k, const AstWord *name);

Str app_file_stem(AppCheck *k, Str path);  // returns the file's stem: "rocket" for pins/rocket.io

// Reports `name` as a duplicate if `seen` contains it; otherwise adds it.  `what` is the kind of thing that it names.
void app_check_unique(AppCheck *k, Map *seen, const AstWord *name, const char *what);

const AstAppOption *app_find_option(const AstApp *ast, AstAppOptionKind kind);        // NULL if it is absent

// ---- check_app_names.c ----

void check_app_products(AppCheck *k);           // the files that are generated: no two may have the same name
void check_app_platform_files(AppCheck *k);     // checks that no two options or sources name a file that is written

// ---- check_app_net.c ----

void check_app_net(AppCheck *k);                // the messages, together with the tasks and the other writers of elements

// ---- check_app_time.c ----

typedef enum AppRangeId {
#define APP_RANGE(name, what, least, most, power_of_two, limits) APP_RANGE_##name,
#include "compiler/sema/app_ranges.def"
#undef APP_RANGE
    APP_RANGES
} AppRangeId;

// The values that a number of an application can have: a row of app_ranges.def.
typedef struct AppRange {
    const char *what;         // for the message: "the watchdog's time"
    uint64_t least, most;     // in nanoseconds, bytes, Hz or without a unit
    bool power_of_two;        // the number must be a power of two
    const char *limits;       // for the message: "1 ms to 1 h"
} AppRange;

extern const AppRange app_ranges[APP_RANGES];

// Converts the amount to a whole number.  If it is not in the range, reports that, sets *value to the range's least value, and returns
// false.
bool app_check_amount(AppCheck *k, const AstAmount *a, AppRangeId range, uint64_t *value);
// Reports a file name whose length is outside the range: the platform opens the file (PAL_NAME in runtime-c/pal/config.h).
void check_app_name_length(AppCheck *k, const AstWord *file, const AppRange *r);
void check_app_rates(AppCheck *k, const AstAppExecutor *in, AppExecutor *out);

// ---- check_app_swap.c ----

void check_app_swap_at(AppCheck *k, const AstAppOption *o);     // checks one of swap_at, swap_speed and swap_key
void check_app_swap_place(AppCheck *k);                         // after all options: what they require of each other

// ---- check_app_task.c ----

bool app_is_reserved_name(const char *name);    // whether runtime-c may use the name, because it begins with one of its prefixes

void check_app_tasks(AppCheck *k, const AstAppExecutor *in, AppExecutor *out);      // checks the tasks; call it after check_app_rates

#endif
