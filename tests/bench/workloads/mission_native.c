// SPDX-License-Identifier: Apache-2.0
// The mission as an expert writes it.  A statistic is computed from a ring where it is needed (hand_window.h), because a running sum would
// accumulate errors.
#include <math.h>
#include <string.h>

#include "tests/bench/workloads/mission.h"

enum { SAFE = 1, ARMED, IGNITION, BOOST, COAST, APOGEE, DROGUE, MAIN, LANDED, ABORT };

static const float thrust = 25.0f, least_average = 12.5f;            // m/s2
static const double main_height = 300.0;                             // m
enum { BATTERY_LOW = 11000 };                                        // mV
enum { LONGEST_BURN = 4500, LATEST_APOGEE = 30000, LATEST_GROUND = 300000 };   // ms

HAND_MEDIAN(Median, altitudes, double, 11)
HAND_AVERAGE(Average, accelerations, float, AVERAGE_OF)
HAND_ENDS(Range, recent, double, RANGE_OF)

static double range(const Range *w) { return recent_most(w) - recent_least(w); }

// ---- states ----

static double height(const MissionNative *m)
{
    return altitudes_median(&m->altitude_median) - m->ground;
}

static void fault(MissionSv *sv, unsigned n)
{
    sv->faults = (uint8_t)(sv->faults + n > UINT8_MAX ? UINT8_MAX : sv->faults + n);
}

static void change(MissionNative *m, uint32_t to)
{
    m->state = to;
    m->first = true;
}

static void safe(MissionNative *m, MissionSv *sv, bool first)
{
    if (first)
        sv->igniter = sv->drogue = sv->mainChute = sv->beacon = false;
    m->ground = altitudes_median(&m->altitude_median);
    sv->height = 0;
    if (sv->battery < BATTERY_LOW)
        fault(sv, 1);
    if (sv->armSwitch && sv->battery >= BATTERY_LOW && m->in_state > 500 && range(&m->altitude_range) < 5)
        change(m, ARMED);
}

static void armed(MissionNative *m, MissionSv *sv, bool first)
{
    if (first) {
        m->top = 0;
        m->peak = 0;
    }
    sv->height = height(m);
    if (!sv->armSwitch || sv->battery < BATTERY_LOW || fabs(sv->height) > 20)
        change(m, SAFE);
    else if (sv->launchButton && m->in_state > 1000)
        change(m, IGNITION);
}

static void ignition(MissionNative *m, MissionSv *sv, bool first)
{
    if (first) {
        sv->igniter = true;
        if (m->ignitions < UINT8_MAX)
            m->ignitions++;
    }
    sv->height = height(m);
    sv->load = accelerations_average(&m->acceleration_average);
    if (sv->acceleration > thrust && sv->load > least_average) {
        sv->igniter = false;
        change(m, BOOST);
    } else if (m->in_state > 2000) {
        fault(sv, 16);
        sv->igniter = false;
        change(m, ABORT);
    }
}

static void boost(MissionNative *m, MissionSv *sv)
{
    sv->height = height(m);
    sv->load = accelerations_average(&m->acceleration_average);
    if (sv->height > m->top)
        m->top = sv->height;
    if (sv->load > m->peak)
        m->peak = sv->load;
    if (m->in_state > 500 && sv->load < 0) {
        change(m, COAST);
    } else if (m->in_state > LONGEST_BURN) {
        fault(sv, 1);
        change(m, COAST);
    }
}

static void coast(MissionNative *m, MissionSv *sv)
{
    sv->height = height(m);
    if (sv->height > m->top)
        m->top = sv->height;
    if (m->in_state > 1000 && sv->height < m->top - 2) {
        change(m, APOGEE);
    } else if (m->in_state > LATEST_APOGEE) {
        fault(sv, 1);
        change(m, APOGEE);
    }
}

static void apogee(MissionNative *m, MissionSv *sv, bool first)
{
    if (first) {
        sv->apogee = m->top;
        sv->drogue = true;
    }
    sv->height = height(m);
    sv->load = accelerations_average(&m->acceleration_average);
    if (m->in_state > 500 && recent_most(&m->altitude_range) - m->ground < sv->apogee - 4)
        change(m, DROGUE);
    else if (m->in_state > 5000)
        change(m, MAIN);
}

static void drogue(MissionNative *m, MissionSv *sv)
{
    sv->height = height(m);
    sv->load = accelerations_average(&m->acceleration_average);
    if (range(&m->altitude_range) > 30)
        fault(sv, 1);
    if (sv->height < main_height || m->in_state > LATEST_GROUND) {
        sv->drogue = false;
        change(m, MAIN);
    }
}

static void main_chute(MissionNative *m, MissionSv *sv, bool first)
{
    if (first) {
        sv->mainChute = true;
        m->calm = 0;
    }
    sv->height = height(m);
    if (range(&m->altitude_range) >= 2)
        m->calm = 0;
    else if (m->calm < UINT16_MAX)
        m->calm++;
    if ((m->calm > 100 && sv->height < 50) || m->in_state > LATEST_GROUND) {
        sv->mainChute = false;
        change(m, LANDED);
    }
}

static void landed(MissionNative *m, MissionSv *sv, bool first)
{
    if (first)
        sv->beacon = true;
    sv->load = accelerations_average(&m->acceleration_average);
    if (sv->battery < BATTERY_LOW - 1000 && m->in_state > 60000)
        sv->beacon = false;
}

static void aborted(MissionNative *m, MissionSv *sv, bool first)
{
    if (first)
        sv->beacon = true;
    sv->height = height(m);
    if (!sv->armSwitch && fabs(sv->height) < 20 && m->in_state > 5000)
        change(m, SAFE);
}

// ---- the machine ----

void mission_native_init(MissionNative *m, MissionSv *sv)
{
    memset(m, 0, sizeof *m);
    m->state = SAFE;
    m->first = true;
    sv->state = SAFE;
}

void mission_native_step(MissionNative *m, MissionSv *sv)
{
    const bool first = m->first;

    if (first) {
        m->first = false;
        m->start = sv->time;
        sv->state = m->state;
    }
    m->in_state = (uint32_t)(sv->time - m->start);
    altitudes_put(&m->altitude_median, sv->altitude);
    accelerations_put(&m->acceleration_average, sv->acceleration);
    recent_put(&m->altitude_range, sv->altitude);
    switch (m->state) {
    case SAFE: safe(m, sv, first); break;
    case ARMED: armed(m, sv, first); break;
    case IGNITION: ignition(m, sv, first); break;
    case BOOST: boost(m, sv); break;
    case COAST: coast(m, sv); break;
    case APOGEE: apogee(m, sv, first); break;
    case DROGUE: drogue(m, sv); break;
    case MAIN: main_chute(m, sv, first); break;
    case LANDED: landed(m, sv, first); break;
    case ABORT: aborted(m, sv, first); break;
    default: break;
    }
}
