// SPDX-License-Identifier: Apache-2.0
// A typed application: the checker's output for a .app whose files have no errors (docs/config.md 10).  Elements and states are
// bound and times are exact.  The C backend and the command read it.  No code changes it after the check.
#ifndef SMC_APPLICATION_H
#define SMC_APPLICATION_H

#include "compiler/sema/iomap.h"
#include "compiler/sema/program.h"
#include "compiler/syntax/ast_app.h"

typedef enum AppStatistic { APP_TICKS, APP_OVERRUNS, APP_SKIPPED, APP_LATE, APP_BUSY, APP_STATISTICS } AppStatistic;

typedef struct AppMachine {
    Str name;
    uint32_t file;            // AppFiles.at[file]
    const Program *program;
    const State *initial;     // NULL: the first state
    bool bytecode, resume;
    uint16_t number;          // 0, 1, 2 … of machines, in file order
} AppMachine;

typedef struct AppTask {
    AstAppTaskKind kind;
    Str name;
    Span span;
    const Element *mode;      // or NULL
    bool has_init, has_safe;  // TASK
    const AppMachine *machine;
    uint16_t number;          // 0, 1, 2 … of all tasks, in file order
} AppTask;

typedef struct AppRate {
    uint64_t period;          // nanoseconds
    uint32_t every;           // ticks of its executor
    VEC(const AppTask *) task;
    Span span;
} AppRate;

typedef struct AppExecutor {
    Str name;
    Span span;
    uint64_t period;          // nanoseconds: the shortest of its rates
    uint32_t priority;        // 0: an ordinary thread
    bool catch_up;
    uint32_t most;            // ticks to catch up
    const Element *statistic[APP_STATISTICS];     // or NULL
    VEC(AppRate *) rate;      // in file order
} AppExecutor;

typedef struct AppStart { const Element *element; uint64_t cell; } AppStart;      // convert.h

typedef struct App {
    Str name;                 // "rocket" of rocket.app
    const Source *src;
    const StateVec *sv;
    const Element *time;      // or NULL: no machine needs the time
    Span time_span;
    uint64_t unit, watchdog;  // nanoseconds; watchdog 0: none
    uint32_t events;
    Str io, log, keep;        // file names as written; NULL if absent
    Str io_name;              // the stem of io: "rocket" of pins/rocket.io
    const IoMap *pins;        // or NULL
    uint32_t log_room;        // bytes
    VEC(AppStart) start;
    VEC(AppExecutor *) executor;
    VEC(AppTask *) task;
    VEC(AppMachine *) machine;
} App;

// The files of an application, each once: the state vector first, then the pins, then machines in file order.
typedef struct AppFile {
    FileKind kind;
    AstWord name;             // as written at its first use
    bool wrong_kind;          // its name has the wrong extension, so it need not be opened
    const Source *src;        // set by the caller, which opens files: the source, or NULL and
    const char *problem;      // the reason why it cannot be read
    const Program *program;   // of a machine, after its check
} AppFile;

typedef struct AppFiles { AppFile *at; size_t n; } AppFiles;

const char *app_time_text(Arena *arena, uint64_t ns);         // "10 ms"

#endif
