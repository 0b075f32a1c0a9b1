// SPDX-License-Identifier: Apache-2.0
// A program that sets the parameters of an emitted machine.  Each value out of range is refused, and so is every value after the first step.
// Exit code 0 if the machine behaves as its source defines.
#include <math.h>
#include <stdio.h>

#include "deploy.h"

static int failed;

static void check(int holds, const char *what)
{
    if (!holds) {
        printf("does not hold: %s\n", what);
        failed = 1;
    }
}

static Deploy machine;
static DeploySv sv;

// Sets these values in a new machine.  Returns its result.
static uint32_t set(double limit, float gain, int16_t offset)
{
    DeployParameters p;
    uint32_t refused;

    check(deploy_init(&machine, &sv, 1) == DEPLOY_OK, "the machine starts");
    deploy_get_parameters(&machine, &p);
    p.limit = limit;
    p.gain = gain;
    p.offset = offset;
    p.all = 255;
    refused = deploy_set_parameters(&machine, &p);
    deploy_get_parameters(&machine, &p);
    check(refused == 0 ? p.all == 255 && p.offset == offset : p.all == 3 && p.offset == -3 && p.on, "all are set, or none");
    return refused;
}

int main(void)
{
    DeployParameters p = { 450, 0, 3, 0, true };

    check(deploy_set_parameters(&machine, &p) == 1, "nothing is set before init");
    check(set(150, -1.5f, -5) == 0 && set(1000, 1.5f, 5) == 0, "the ends of the ranges");
    check(set(149.99, 0, 0) == 1 && set(1000.01, 0, 0) == 1 && set((double)NAN, 0, 0) == 1 && set((double)INFINITY, 0, 0) == 1, "the first one");
    check(set(450, 1.51f, 0) == 2 && set(450, -1.51f, 0) == 2 && set(450, NAN, 0) == 2 && set(450, 0, -6) == 4 && set(450, 0, 6) == 4, "the others");
    check(set(200, 0.25f, 5) == 0, "these");
    p.limit = 200;
    for (sv.G = 1; sv.G < 6; sv.G++) {
        check(deploy_step(&machine, &sv) == DEPLOY_OK && sv.x == 200 * 0.25 + 255 + 5 + 1, "the machine computes with them");
        deploy_get_parameters(&machine, &p);
        check(p.limit == 200 && deploy_set_parameters(&machine, &p) == 1, "a machine that has stepped refuses all");
    }
    return failed;
}
