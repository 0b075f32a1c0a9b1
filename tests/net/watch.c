// SPDX-License-Identifier: Apache-2.0
// The receiver.  It checks in every step that all elements belong to one message, that no older message follows a newer one, and that silence
// stores its values.  It prints a line at each begin and end of silence, and the counts at the end.  It ends when standard input ends.
#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>

#include "receiver_app.h"

static uint32_t newest, wrong;
static bool was_silent = true;

static void check_values(bool silent)
{
    const uint32_t n = link_n();

    wrong += link_square() != (uint64_t)n * n;
    wrong += n < newest && !was_silent;
    if (silent && link_accepted())
        wrong += link_half() != -1 || !link_odd();
    else if (!silent)
        wrong += link_half() != n / 2.0 || link_odd() != (n & 1);
    newest = n;
}

SmResult watch_step(const SmTick *tick)
{
    const bool silent = link_age() > 300;
    char byte;
    ssize_t n;

    if (tick->number == 0)
        fcntl(0, F_SETFL, O_NONBLOCK);
    check_values(silent);
    if (silent != was_silent)
        printf("%s\n", silent ? "silent" : "hears");
    fflush(stdout);
    was_silent = silent;
    n = read(0, &byte, 1);
    if (n == 1 && byte == '?')
        printf("accepted %u refused %u damaged %u repeated %u late %u short %u long %u hash %u connected %u broken %u wrong %u ticks %lu\n",
               link_accepted(), link_refused(), link_damaged(), link_repeated(), link_late(), link_shorts(), link_longs(), link_hashes(),
               link_connected(), link_broken(), wrong, (unsigned long)tick->number);
    if (n == 0)
        sm_app_stop(&receiver_app);
    return SM_OK;
}
