// SPDX-License-Identifier: Apache-2.0
// What runtime-c/statevec.h promises, in the simulation: elements, names, regions, the wire, what is refused.
#include <string.h>

#include "plain.h"
#include "runtime-c/psl/sim/sim.h"
#include "tests/test.h"
#include "wide.h"

static void start(void)
{
    sim_reset();
    memset(&wide_sv, 0, sizeof wide_sv);
    wide_vector.faults = 0;
    CHECK(sm_statevec_init(&wide_vector) == SM_OK);
}

static void test_functions(void)
{
    start();
    wide_set_f64(120.5);
    CHECK(wide_f64() == 120.5 && wide_sv.f64 == 120.5);
    wide_sv.flag = 7;
    CHECK(wide_flag() == 1);
    plain_set_i16(-3);
    CHECK(plain_i16() == -3 && plain_sv.i16 == -3);
}

static void test_names(void)
{
    CHECK(sm_find_element(&wide_names, "f64") == &wide_element[WIDE_E_f64]);
    CHECK(sm_find_element(&wide_names, "nothing") == NULL);
    CHECK(sm_find_region(&wide_names, "All") == &wide_layout.region[WIDE_R_All]);
    CHECK(sm_find_region(&wide_names, "*") == &wide_layout.whole);
}

int main(void)
{
    test_functions();
    test_names();
    return test_end("statevec");
}
