// SPDX-License-Identifier: Apache-2.0
// A typed application: the checker's output for a .app whose files have no errors (docs/config.md 10).  Names of elements and states
// are bound to Element and State, and times are exact.  The C backend and the command read an App.  No code changes it after the check.
#ifndef SMC_APPLICATION_H
#define SMC_APPLICATION_H

#include "compiler/sema/iomap.h"
#include "compiler/sema/network.h"
#include "compiler/sema/program.h"
#include "compiler/syntax/ast_app.h"

// What an executor can report about its ticks, in elements that the user names.
typedef enum AppStatistic { APP_TICKS, APP_OVERRUNS, APP_SKIPPED, APP_LATE, APP_BUSY, APP_STATISTICS } AppStatistic;

typedef struct AppMachine {
    Str name;
    uint32_t file;            // index of its file in AppFiles
    const Program *program;
    const State *initial;     // the state in which the machine starts; NULL: the first state of its file
    bool bytecode, resume;    // the task has @bytecode; has @resume
    bool swap;                // it can be swapped while the application runs
    uint32_t longest;         // for a machine that can be swapped: the most instructions of a step
    uint16_t number;          // index in App.machine, which is in file order
} AppMachine;

typedef struct AppTask {
    AstAppTaskKind kind;
    Str name;
    Span span;
    const Element *mode;      // the element of its @mode, or NULL
    bool has_init, has_safe;  // for AST_TASK_task: the user writes a function `init`, a function `safe`; else false
    const AppMachine *machine;
    uint16_t number;          // index in App.task, which is in file order
} AppTask;

typedef struct AppRate {
    uint64_t period;          // period of the rate in nanoseconds
    uint32_t every;           // its tasks run once in this many ticks of the executor
    VEC(const AppTask *) task;
    Span span;
} AppRate;

typedef struct AppExecutor {
    Str name;
    Span span;
    uint64_t period;          // time between two ticks in nanoseconds: the shortest period of its rates
    uint32_t priority;        // real-time priority of its thread, 1 to 99; 0: an ordinary thread
    bool catch_up;            // runs missed ticks later, instead of skipping them
    uint32_t most;            // catch_up: the most missed ticks that are run later
    const Element *statistic[APP_STATISTICS];     // by AppStatistic: the element that receives it, or NULL
    VEC(AppRate *) rate;      // in file order
} AppExecutor;

typedef struct AppStart { const Element *element; uint64_t cell; } AppStart;      // the value, as a bit cell of the element's type (convert.h)

// How a host connects to a running application to swap its machines (config.md 10.25).
typedef enum AppPlace { APP_NOWHERE, APP_AT_PATH, APP_AT_ADDRESS, APP_AT_LINE } AppPlace;

typedef struct AppSwapAt {
    AppPlace place;
    Str name;                 // the path, address or line, as written
    uint8_t ip[4];            // APP_AT_ADDRESS: its IPv4 address
    uint16_t port;            // APP_AT_ADDRESS: its TCP port
    uint32_t speed;           // APP_AT_LINE: bits per second of the serial line
    Str key;                  // name of the file with the key that hosts need; or NULL
} AppSwapAt;

typedef struct App App;
struct App {
    Str name;                 // the file's stem: "rocket" of rocket.app
    const Source *src;
    const StateVec *sv;
    const Element *time;      // the element with the time; NULL if no machine needs it
    Span time_span;
    uint64_t unit, watchdog;  // in nanoseconds: one unit of the time; the watchdog's timeout, 0: no watchdog
    uint32_t events;          // capacity of the event buffer, in events
    Str io, log, keep;        // file names as written; NULL if absent
    Str io_name;              // the stem of io: "rocket" of pins/rocket.io
    const IoMap *pins;        // the pins of io, or NULL
    Str net_name;             // the stem of the .net; NULL if the application has no .net
    const Network *net;       // the messages of net, or NULL
    uint32_t log_room;        // memory of the log in bytes
    uint32_t swap_room;       // size in bytes of each of the two slots in which a machine that can be swapped is stored
    uint32_t swap_trial;      // how many steps a swapped machine is on trial: until then the swap can be undone
    uint32_t swap_limit;      // the most instructions that a step of a swapped machine may execute, per millisecond of its period
    AppSwapAt swap_at;
    Str swap_store;           // the file with the images of confirmed swaps; or NULL
    const Element *armed;     // while it is true, swaps are refused; or NULL
    VEC(AppStart) start;
    VEC(AppExecutor *) executor;
    VEC(AppTask *) task;
    VEC(AppMachine *) machine;
};

// AppFiles lists each file that an application names once: the state vector first, then the pins, the messages, then machines in file order.
typedef struct AppFile {
    FileKind kind;
    AstWord name;             // the file's name as written at its first use
    bool wrong_kind;          // its name has the wrong extension, so it need not be opened
    const Source *src;        // set by the caller, which opens files; NULL if the file cannot be read
    const char *problem;      // set by the caller if src is NULL: why the file cannot be read
    size_t machines;          // number of machines of the application that this file defines
    size_t unbound;           // 1 + the index in AppFiles.instance of the first machine of this file without bindings
                              // (`NAME = VARIABLE` in braces after the file); 0: none
} AppFile;

// A machine of an application: a line `machine NAME "FILE"`.
typedef struct AppInstance {
    const AstAppTask *task;
    size_t file;              // index of its file in AppFiles.at
    const Program *program;   // the checked machine; NULL before its check, or if it has errors
} AppInstance;

typedef struct AppFiles {
    AppFile *at;
    size_t n;
    AppInstance *instance;    // in file order
    size_t instances;
} AppFiles;

const char *app_time_text(Arena *arena, uint64_t ns);         // returns the time with a unit: "10 ms"

#endif
