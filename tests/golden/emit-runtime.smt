# What the flight runtime gets of a state vector without and with `lock`; elements give way to the vector's own names.
args build --emit=c --runtime open.sv shut.sv && cat open.h open.c && sed -n '/flight runtime/,$p' shut.h && grep vector shut.c

-- open.sv --
[Valves]
bool open
[Sensors]
F64 pressure
U8  class
-- shut.sv --
[options]
lock
[Bytes]
bool vector
U8   set_vector
-- stdout --
// The state vector open.  Made by smc from open.sv: change that, not this file.
#ifndef OPEN_SV_H_INCLUDED
#define OPEN_SV_H_INCLUDED

#include <stdbool.h>
#include <stdint.h>

#include "runtime-c/statevec.h"

#ifdef __cplusplus
extern "C" {
#endif

// The state vector of open.sv.  Every machine built with it declares this struct, and they can be used together.
// The layout is the same on every target, without hidden padding.  A bool is a byte: 0 is false,
// anything else true.
#if !defined(OPEN_SV_LAYOUT)
#define OPEN_SV_LAYOUT 0x6b534153u
typedef struct OpenSv {
    // [Valves]
    uint8_t  open;                    // bool
    uint8_t  pad_at_1_[7];

    // [Sensors]
    SmF64    pressure;
    uint8_t  class_;                  // class
    uint8_t  pad_at_17_[7];
} OpenSv;

// Does not compile if the compiler inserts padding or has types of other sizes.
typedef char OpenSv_layout_check[sizeof(OpenSv) == 24 ? 1 : -1];
#elif OPEN_SV_LAYOUT != 0x6b534153u
#error "OpenSv: this header and one included before it were generated from different state vectors"
#endif

// ---- for the flight runtime: runtime-c/statevec.h documents these ----

extern OpenSv open_sv;        // its elements; for one thread
extern SmStateVec open_vector;
extern const SmLayout open_layout;
extern const SmElement open_element[];        // by the numbers that follow
extern const SmNames open_names;

enum {
    OPEN_E_open,
    OPEN_E_pressure,
    OPEN_E_class,
    OPEN_ELEMENTS        // their number
};

enum {
    OPEN_R_Valves,
    OPEN_R_Sensors,
    OPEN_REGIONS        // their number
};

static inline bool open_open(void) { return open_sv.open != 0; }
static inline void open_set_open(bool value) { open_sv.open = value; }

static inline SmF64 open_pressure(void) { return open_sv.pressure; }
static inline void open_set_pressure(SmF64 value) { open_sv.pressure = value; }

static inline uint8_t open_class(void) { return open_sv.class_; }
static inline void open_set_class(uint8_t value) { open_sv.class_ = value; }

// Copy a whole region at once, from or to its members in a copy of the vector; other members stay unchanged.

static inline SmResult open_read_Valves(OpenSv *copy)
{
    return sm_read_region(&open_vector, &open_layout.region[OPEN_R_Valves], (uint8_t *)copy + 0);
}
static inline SmResult open_write_Valves(const OpenSv *copy)
{
    return sm_write_region(&open_vector, &open_layout.region[OPEN_R_Valves], (const uint8_t *)copy + 0);
}

static inline SmResult open_read_Sensors(OpenSv *copy)
{
    return sm_read_region(&open_vector, &open_layout.region[OPEN_R_Sensors], (uint8_t *)copy + 8);
}
static inline SmResult open_write_Sensors(const OpenSv *copy)
{
    return sm_write_region(&open_vector, &open_layout.region[OPEN_R_Sensors], (const uint8_t *)copy + 8);
}

#ifdef __cplusplus
}
#endif

#endif
// The state vector open.  Made by smc from open.sv: change that, not this file.
#include "open.h"

OpenSv open_sv;

SmStateVec open_vector = {&open_layout, &open_sv, false, {0}, 0};

const SmElement open_element[] = {        // offset, type, region
    {0, SM_BOOL, OPEN_R_Valves},        // open
    {8, SM_F64, OPEN_R_Sensors},        // pressure
    {16, SM_U8, OPEN_R_Sensors},        // class
};

static const SmRegion open_regions[] = {        // offset, size, size on the wire, first element, number of elements
    {0, 1, 1, 0, 1},        // Valves
    {8, 9, 9, 1, 2},        // Sensors
};

const SmLayout open_layout = {
    0x6b534153u, OPEN_ELEMENTS, OPEN_REGIONS, open_element, open_regions,
    {0, 24, 10, 0, OPEN_ELEMENTS}
};

static const char *const open_element_names[] = {
    "open",
    "pressure",
    "class",
};

static const char *const open_region_names[] = {
    "Valves",
    "Sensors",
};

const SmNames open_names = {&open_layout, "open", open_element_names, open_region_names};
// ---- for the flight runtime: runtime-c/statevec.h documents these ----

extern ShutSv shut_sv;        // its elements; only for code that holds its lock
extern SmStateVec shut_vector;
extern const SmLayout shut_layout;
extern const SmElement shut_element[];        // by the numbers that follow
extern const SmNames shut_names;

enum {
    SHUT_E_vector,
    SHUT_E_set_vector,
    SHUT_ELEMENTS        // their number
};

enum {
    SHUT_R_Bytes,
    SHUT_REGIONS        // their number
};

// Each of these acquires and releases the lock.  If it cannot, it reads 0, writes nothing, and counts a fault in shut_vector.faults.

static inline bool shut_vector_2(void)
{
    bool value = false;

    if (sm_enter(&shut_vector) == SM_OK) {
        value = shut_sv.vector != 0;
        sm_leave(&shut_vector);
    }
    return value;
}
static inline void shut_set_vector_2(bool value)
{
    if (sm_enter(&shut_vector) == SM_OK) {
        shut_sv.vector = value;
        sm_leave(&shut_vector);
    }
}

static inline uint8_t shut_set_vector(void)
{
    uint8_t value = 0;

    if (sm_enter(&shut_vector) == SM_OK) {
        value = shut_sv.set_vector;
        sm_leave(&shut_vector);
    }
    return value;
}
static inline void shut_set_set_vector(uint8_t value)
{
    if (sm_enter(&shut_vector) == SM_OK) {
        shut_sv.set_vector = value;
        sm_leave(&shut_vector);
    }
}

// Copy a whole region at once, from or to its members in a copy of the vector; other members stay unchanged.

static inline SmResult shut_read_Bytes(ShutSv *copy)
{
    return sm_read_region(&shut_vector, &shut_layout.region[SHUT_R_Bytes], (uint8_t *)copy + 0);
}
static inline SmResult shut_write_Bytes(const ShutSv *copy)
{
    return sm_write_region(&shut_vector, &shut_layout.region[SHUT_R_Bytes], (const uint8_t *)copy + 0);
}

#ifdef __cplusplus
}
#endif

#endif
// The state vector shut.  Made by smc from shut.sv: change that, not this file.
SmStateVec shut_vector = {&shut_layout, &shut_sv, true, {0}, 0};
    {0, SM_BOOL, SHUT_R_Bytes},        // vector
    {1, SM_U8, SHUT_R_Bytes},        // set_vector
    "vector",
    "set_vector",
