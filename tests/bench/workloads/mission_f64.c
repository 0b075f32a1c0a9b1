// SPDX-License-Identifier: Apache-2.0
// The mission by the definitions of the language: every value a double, every store a conversion, windows of doubles
// whose statistics are computed again at each use.
#include <math.h>
#include <string.h>

#include "stdlib/convert.h"
#include "tests/bench/workloads/mission.h"
#include "tests/bench/workloads/window.h"

enum { SAFE = 1, ARMED, IGNITION, BOOST, COAST, APOGEE, DROGUE, MAIN, LANDED, ABORT };

#define IN_STATE ((double)m->T)
#define BATTERY ((double)sv->battery)
#define MEDIAN window_median(&m->median)
#define AVERAGE window_avg(&m->average)
#define LOAD sm_read_f32(sv->load)

static void set_height(MissionF64 *m, MissionSv *sv) { sv->height = sm_to_f64(MEDIAN - m->ground); }

static void fault(MissionSv *sv, double n) { sv->faults = sm_to_u8((double)sv->faults + n); }

static void entry(MissionF64 *m, MissionSv *sv)
{
    switch (m->state) {
    case SAFE:
        sv->igniter = false;
        sv->drogue = false;
        sv->mainChute = false;
        sv->beacon = false;
        break;
    case ARMED:
        m->top = 0.0;
        m->peak = 0.0f;
        break;
    case IGNITION:
        sv->igniter = true;
        m->ignitions = sm_to_u8((double)m->ignitions + 1.0);
        break;
    case APOGEE:
        sv->apogee = m->top;
        sv->drogue = true;
        break;
    case MAIN:
        sv->mainChute = true;
        m->calm = 0;
        break;
    case LANDED:
    case ABORT:
        sv->beacon = true;
        break;
    default:
        break;
    }
}

static void leave(MissionF64 *m, MissionSv *sv)
{
    switch (m->state) {
    case IGNITION: sv->igniter = false; break;
    case DROGUE: sv->drogue = false; break;
    case MAIN: sv->mainChute = false; break;
    default: break;
    }
}

static uint32_t safe(MissionF64 *m, MissionSv *sv)
{
    m->ground = sm_to_f64(MEDIAN);
    sv->height = 0.0;
    if (BATTERY < 11000.0)
        fault(sv, 1.0);
    return sv->armSwitch && BATTERY >= 11000.0 && IN_STATE > 500.0 && window_range(&m->range) < 5.0 ? ARMED : 0;
}

static uint32_t armed(MissionF64 *m, MissionSv *sv)
{
    set_height(m, sv);
    if (!sv->armSwitch)
        return SAFE;
    if (BATTERY < 11000.0)
        return SAFE;
    if (fabs(sm_read_f64(sv->height)) > 20.0)
        return SAFE;
    return sv->launchButton && IN_STATE > 1000.0 ? IGNITION : 0;
}

static uint32_t ignition(MissionF64 *m, MissionSv *sv)
{
    set_height(m, sv);
    sv->load = sm_to_f32(AVERAGE);
    if (sm_read_f32(sv->acceleration) > 25.0 && LOAD > 25.0 / 2.0)
        return BOOST;
    if (IN_STATE > 2000.0) {
        fault(sv, 16.0);
        return ABORT;
    }
    return 0;
}

static uint32_t boost(MissionF64 *m, MissionSv *sv)
{
    set_height(m, sv);
    sv->load = sm_to_f32(AVERAGE);
    if (sm_read_f64(sv->height) > m->top)
        m->top = sm_read_f64(sv->height);
    if (LOAD > (double)m->peak)
        m->peak = sm_to_f32(LOAD);
    if (IN_STATE > 500.0 && LOAD < 0.0)
        return COAST;
    if (IN_STATE > 4500.0) {
        fault(sv, 1.0);
        return COAST;
    }
    return 0;
}

static uint32_t coast(MissionF64 *m, MissionSv *sv)
{
    set_height(m, sv);
    if (sm_read_f64(sv->height) > m->top)
        m->top = sm_read_f64(sv->height);
    if (IN_STATE > 1000.0 && sm_read_f64(sv->height) < m->top - 2.0)
        return APOGEE;
    if (IN_STATE > 30000.0) {
        fault(sv, 1.0);
        return APOGEE;
    }
    return 0;
}

static uint32_t apogee(MissionF64 *m, MissionSv *sv)
{
    set_height(m, sv);
    sv->load = sm_to_f32(AVERAGE);
    if (IN_STATE > 500.0 && window_max(&m->range) - m->ground < sm_read_f64(sv->apogee) - 4.0)
        return DROGUE;
    return IN_STATE > 5000.0 ? MAIN : 0;
}

static uint32_t drogue(MissionF64 *m, MissionSv *sv)
{
    set_height(m, sv);
    sv->load = sm_to_f32(AVERAGE);
    if (window_max(&m->range) - window_min(&m->range) > 30.0)
        fault(sv, 1.0);
    if (sm_read_f64(sv->height) < 300.0)
        return MAIN;
    return IN_STATE > 300000.0 ? MAIN : 0;
}

static uint32_t main_chute(MissionF64 *m, MissionSv *sv)
{
    set_height(m, sv);
    if (window_range(&m->range) < 2.0)
        m->calm = sm_to_u16((double)m->calm + 1.0);
    else
        m->calm = 0;
    if ((double)m->calm > 100.0 && sm_read_f64(sv->height) < 50.0)
        return LANDED;
    return IN_STATE > 300000.0 ? LANDED : 0;
}

static uint32_t landed(MissionF64 *m, MissionSv *sv)
{
    sv->load = sm_to_f32(AVERAGE);
    if (BATTERY < 11000.0 - 1000.0 && IN_STATE > 60000.0)
        sv->beacon = false;
    return 0;
}

static uint32_t aborted(MissionF64 *m, MissionSv *sv)
{
    set_height(m, sv);
    return !sv->armSwitch && fabs(sm_read_f64(sv->height)) < 20.0 && IN_STATE > 5000.0 ? SAFE : 0;
}

static uint32_t step(MissionF64 *m, MissionSv *sv)
{
    switch (m->state) {
    case SAFE: return safe(m, sv);
    case ARMED: return armed(m, sv);
    case IGNITION: return ignition(m, sv);
    case BOOST: return boost(m, sv);
    case COAST: return coast(m, sv);
    case APOGEE: return apogee(m, sv);
    case DROGUE: return drogue(m, sv);
    case MAIN: return main_chute(m, sv);
    case LANDED: return landed(m, sv);
    default: return aborted(m, sv);
    }
}

// ---- the machine ----

void mission_f64_init(MissionF64 *m, MissionSv *sv)
{
    memset(m, 0, sizeof *m);
    window_init(&m->median, m->slots, MEDIAN_OF);
    window_init(&m->average, m->slots + MEDIAN_OF, AVERAGE_OF);
    window_init(&m->range, m->slots + MEDIAN_OF + AVERAGE_OF, RANGE_OF);
    m->state = SAFE;
    m->first = true;
    sv->state = SAFE;
}

void mission_f64_step(MissionF64 *m, MissionSv *sv)
{
    uint32_t to;

    if (sv->time == UINT64_MAX || (m->ran && sv->time <= m->last))
        return;
    m->ran = true;
    m->last = sv->time;
    if (m->first) {
        m->start = sv->time;
        sv->state = m->state;
    }
    m->T = sv->time - m->start;
    window_put(&m->median, sm_read_f64(sv->altitude));
    window_put(&m->average, sm_read_f32(sv->acceleration));
    window_put(&m->range, sm_read_f64(sv->altitude));
    if (m->first)
        entry(m, sv);
    to = step(m, sv);
    if (to != 0) {
        leave(m, sv);
        m->state = to;
    }
    m->first = to != 0;
}
