# An application becomes static tables; a make rule names all files that it is made of.
args build rocket.app -MD && cat rocket_app.h rocket_app.c rocket_app.d

-- rocket.sv --
[options]
lock
[A]
U64 time
U32 missionState
U8 engineMode
F64 altitude
U32 late
-- mission.sm --
[state_vector]
U64 time         @alias G
U32 missionState @alias S
[Pad]
.step
    T > 100: -> Flight
[Flight] @safe
-- rocket.app --
[options]
state_vector "rocket.sv"
time         time 1 ms
log          "flight 1.log" 4 KB
keep         "rocket.state"
watchdog     0.5 s
[start]
engineMode = 2
altitude   = 1 / 3
[flight] @priority 80 @overrun catch_up 3 @late late
every 10 ms:
    task navigation @init
    machine mission "mission.sm" @state Flight @resume
    task engine @mode engineMode @safe
at 10 Hz:
    log
[slow]
every 1 s:
    keep @mode engineMode
-- stdout --
// The application rocket.  Made by smc from rocket.app: change that, not this file.
#ifndef ROCKET_APP_H_INCLUDED
#define ROCKET_APP_H_INCLUDED

#include "runtime-c/sm.h"
#include "rocket.h"

#ifdef __cplusplus
extern "C" {
#endif

extern SmApp rocket_app;

// ---- you write these: runtime-c/task.h documents them ----

// Every 10 ms.
SmResult navigation_init(void);
SmResult navigation_step(const SmTick *tick);

// Every 10 ms, as its mode says: engineMode.
SmResult engine_step(const SmTick *tick);
SmResult engine_safe(const SmTick *tick);

#ifdef __cplusplus
}
#endif

#endif
// The application rocket.  Made by smc from rocket.app: change that, not this file.
#include "rocket_app.h"

#include "mission.h"
#include "stdlib/convert.h"

static SmEvent ring[64];
static SmEvents events = {.at = ring, .room = 64, .guarded = true};

// ---- machines ----

static Mission missionSelf;
static uint64_t missionCopy[(sizeof(RocketSv) + 7) / 8];        // its snapshot of the state vector

static SmMachine machines[] = {
    {.name = "mission", .type = &mission_machine, .self = &missionSelf, .sv = &rocket_vector, .events = &events, .copy = missionCopy, .initial = 2, .resume = true, .restored = &rocket_app.restored, .number = 0},
};

// ---- the flight log ----

static const SmMachine *const logged[] = {
    &machines[0],
};
static const char *const taskNames[] = {
    "navigation",
    "mission",
    "engine",
    "log",
    "keep",
};
static const char *const executorNames[] = {
    "flight",
    "slow",
};
static uint8_t logBuffer[4096];
static SmLog flightLog = {
    .file = "flight 1.log", .sv = &rocket_vector, .names = &rocket_names, .events = &events,
    .machine = logged, .machines = 1,
    .task = taskNames, .tasks = 5, .executor = executorNames, .executors = 2,
    .buffer = logBuffer, .room = sizeof logBuffer
};

// ---- the saved state vector ----

static uint8_t keepBuffer[2 * SM_KEEP_SIZE(25u)];
static SmKeep keeper = {.memory = "rocket.state", .sv = &rocket_vector, .buffer = keepBuffer};

// ---- tasks, in source order ----

static SmResult navigationInit(void *context)
{
    (void)context;
    return navigation_init();
}
static SmResult navigationStep(void *context, const SmTick *tick)
{
    (void)context;
    return navigation_step(tick);
}

static SmResult engineStep(void *context, const SmTick *tick)
{
    (void)context;
    return engine_step(tick);
}
static SmResult engineSafe(void *context, const SmTick *tick)
{
    (void)context;
    return engine_safe(tick);
}

static SmTask tasks[] = {
    {.name = "navigation", .init = navigationInit, .step = navigationStep, .number = 0},
    {.name = "mission", .init = sm_machine_init, .step = sm_machine_step, .context = &machines[0], .number = 1},
    {.name = "engine", .step = engineStep, .safe = engineSafe, .mode = &rocket_element[ROCKET_E_engineMode], .number = 2},
    {.name = "log", .init = sm_log_init, .step = sm_log_step, .context = &flightLog, .number = 3},
    {.name = "keep", .step = sm_keep_step, .context = &keeper, .mode = &rocket_element[ROCKET_E_engineMode], .number = 4},
};

static SmTask *const order[] = {
    &tasks[0],        // navigation
    &tasks[1],        // mission
    &tasks[2],        // engine
    &tasks[3],        // log
    &tasks[4],        // keep
};

// ---- executors ----

static const SmRate rates[] = {
    {.every = 1, .tasks = 3, .task = &order[0]},        // [flight] every 10 ms
    {.every = 10, .tasks = 1, .task = &order[3]},        // [flight] every 100 ms
    {.every = 1, .tasks = 1, .task = &order[4]},        // [slow] every 1 s
};

static SmExecutor executors[] = {
    {.name = "flight", .period = 10000000u, .rate = &rates[0], .rates = 2, .priority = 80, .overrun = SM_CATCH_UP, .most = 3,
     .vitals = {.late = &rocket_element[ROCKET_E_late]},
     .time = &rocket_element[ROCKET_E_time], .unit = 1000000u,
     .sv = &rocket_vector, .events = &events, .number = 0},
    {.name = "slow", .period = 1000000000u, .rate = &rates[2], .rates = 1,
     .time = &rocket_element[ROCKET_E_time], .unit = 1000000u,
     .sv = &rocket_vector, .events = &events, .number = 1},
};

static SmExecutor *const threads[] = {
    &executors[0],
    &executors[1],
};

// ---- the values of elements before the first step ----

static void setValues(void *vector)
{
    RocketSv *sv = (RocketSv *)vector;

    sm_cell_store(SM_U8, &sv->engineMode, 0x2u);        // 2
    sm_cell_store(SM_F64, &sv->altitude, 0x3fd5555555555555u);        // 0.3333333333333333
}

// ---- the application ----

SmApp rocket_app = {
    .name = "rocket", .sv = &rocket_vector, .events = &events,
    .executor = threads, .executors = 2,
    .set = setValues,
    .keep = &keeper,
    .log = &flightLog,
    .writing = &sm_writing,
    .watchdog = 500000000u,
};

#ifndef SM_NO_MAIN
int main(void)
{
    return sm_app_main(&rocket_app);
}
#endif
rocket_app.c rocket_app.h rocket.c rocket.h mission.c mission.h: rocket.app rocket.sv mission.sm
