// SPDX-License-Identifier: Apache-2.0
// The log and the saved state vector of an application.  app.c and run.c call these two modules only through
// SmWriting (app.h), so that an application that has neither does not link them.
#include "runtime-c/app.h"

static SmResult restore_vector(SmApp *app)
{
    const SmResult r = app->keep ? sm_keep_restore(app->keep) : SM_OK;

    app->restored = r == SM_OK && app->keep && app->keep->restored;
    return r;
}

// Writes what is pending to the media.  If a medium fails, the next call retries.
static void write_pending(SmApp *app, uint64_t budget)
{
    if (app->keep)
        (void)sm_keep_write(app->keep);
    if (app->log && app->log->out.id != 0)
        (void)sm_log_drain(app->log, budget);
}

static void close_media(SmApp *app, const SmTick *last)
{
    if (app->keep)
        (void)sm_keep_write(app->keep);
    if (!app->log || app->log->out.id == 0)               // the log was never opened
        return;
    (void)sm_log_step(app->log, last);
    (void)sm_log_close(app->log);
}

const SmWriting sm_writing = {restore_vector, write_pending, close_media};
